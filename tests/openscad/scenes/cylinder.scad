$fn = 96;
cylinder(h = 20, r = 6);
translate([18, 0, 0]) cylinder(h = 10, d = 12, center = true);
translate([0, 18, 5]) rotate([90, 0, 30]) cylinder(h = 8, r = 3);
