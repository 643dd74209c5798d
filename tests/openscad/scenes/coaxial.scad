// Cylinders on one axis, equal and different radii, flush and overlapping.
$fn = 48;
difference() {
    union() {
        cylinder(h = 10, r = 10);
        translate([0, 0, 10]) cylinder(h = 10, r = 10);
        translate([0, 0, 5]) cylinder(h = 30, r = 6);
    }
    cylinder(h = 8, r = 6);
    translate([0, 0, 8]) cylinder(h = 40, r = 3);
    translate([0, 0, 30]) cylinder(h = 5, r1 = 3, r2 = 5);
}
