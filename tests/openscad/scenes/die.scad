// A rounded die with its pips, of render() and modules.
$fn = 48;
module pips(n) {
    for (i = [0 : n - 1])
        rotate(360 * i / n) translate([n > 1 ? 5 : 0, 0, 10]) sphere(r = 1.8);
}
render() difference() {
    intersection() {
        cube(20, center = true);
        sphere(r = 13.5);
    }
    pips(1);
    rotate([90, 0, 0]) pips(2);
    rotate([0, 90, 0]) pips(3);
    rotate([0, -90, 0]) pips(4);
    rotate([-90, 0, 0]) pips(5);
    rotate([180, 0, 0]) pips(6);
}
