// Solids without volume are nothing; as the first operand of a difference they leave nothing.
$fn = 32;
cube([10, 10, 10]);
cube([0, 10, 10]);
translate([12, 0, 0]) cylinder(h = 0, r = 4);
translate([12, 0, 0]) cylinder(h = 8, r = 0);
translate([12, 0, 0]) sphere(r = 0);
difference() {
    cube([0, 5, 5]);
    translate([20, 0, 0]) cube(5);
}
difference() {
    translate([20, 0, 0]) cube(8);
    translate([20, 0, 0]) cylinder(h = 0, r = 4);
    translate([24, 4, 4]) cylinder(h = 10, r1 = 3, r2 = 0);
}
scale([1, 0, 1]) translate([40, 0, 0]) cube(9);
