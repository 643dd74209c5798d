// Solids that meet in a point, a line or a circle.
$fn = 64;
sphere(r = 6);
translate([12, 0, 0]) sphere(r = 6);
translate([0, 0, 6]) cylinder(h = 6, r1 = 0, r2 = 5);
translate([20, 0, 0]) cube([4, 4, 4]);
translate([24, 4, 0]) cube([4, 4, 4]);
difference() {
    translate([0, 20, 0]) cube([20, 12, 6]);
    translate([10, 26, 0]) cylinder(h = 6, r = 6);
}
