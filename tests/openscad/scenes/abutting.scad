// Unions of solids that touch: no seam inside may show through the windows.
$fn = 48;
difference() {
    union() {
        cube([10, 20, 10]);
        translate([10, 0, 0]) cube([10, 20, 10]);
        translate([0, 0, 10]) cube([20, 20, 4]);
        translate([20, 10, 7]) rotate([0, 90, 0]) cylinder(h = 12, r = 5);
        translate([32, 10, 7]) rotate([0, 90, 0]) cylinder(h = 8, r1 = 5, r2 = 0);
    }
    translate([5, 5, -1]) cube([10, 10, 9]);
}
