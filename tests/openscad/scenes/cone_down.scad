$fn = 96;
cylinder(h = 15, r1 = 0, r2 = 8);
translate([20, 0, 0]) cylinder(h = 12, r1 = 0, r2 = 6, center = true);
