$fn = 96;
cylinder(h = 15, r1 = 8, r2 = 0);
translate([20, 0, 0]) cylinder(h = 12, r1 = 6, r2 = 0, center = true);
