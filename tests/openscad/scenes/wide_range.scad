// Features from 0.1 to 100.
$fn = 64;
difference() {
    cube([100, 60, 5]);
    for (i = [0 : 5])
        translate([10 + 15 * i, 30, -1]) cylinder(h = 7, r = 0.2 * pow(2, i));
    translate([2, 2, 4.9]) cube([96, 5, 0.2]);
}
translate([50, 30, 5]) sphere(r = 4);
