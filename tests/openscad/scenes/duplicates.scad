// The same solid twice, added, cut and intersected.
$fn = 48;
union() {
    sphere(r = 8);
    sphere(r = 8);
}
translate([20, 0, 0]) intersection() {
    cube(10, center = true);
    cube(10, center = true);
    cylinder(h = 10, r = 6, center = true);
}
difference() {
    translate([-20, 0, 0]) cube(12, center = true);
    translate([-20, 0, 0]) cube(12, center = true);
}
translate([0, 20, 0]) difference() {
    cube(12, center = true);
    cube([12, 12, 6], center = true);
}
