// Ellipsoids, elliptic cylinders and cones.
$fn = 96;
scale([2, 1, 0.5]) sphere(r = 8);
translate([28, 0, 0]) rotate([10, 20, 30]) scale([0.5, 1.5, 1]) cylinder(h = 16, r = 6, center = true);
translate([0, 24, 0]) scale([1.5, 0.7, 1]) cylinder(h = 12, r1 = 7, r2 = 0);
translate([28, 24, 4]) scale([1, 1, -1]) rotate([0, 45, 0]) scale([1, 0.4, 1]) cube(9, center = true);
