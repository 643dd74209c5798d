$fn = 96;
cylinder(h = 12, r1 = 8, r2 = 5);
translate([20, 0, 0]) cylinder(h = 12, d1 = 4, d2 = 15, center = true);
translate([0, 20, 0]) cylinder(h = 3, r1 = 8, r2 = 7.5);
