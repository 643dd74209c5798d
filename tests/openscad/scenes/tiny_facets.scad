// Small circles become pentagons unless told otherwise; $fa and $fs, fractions and large $fn.
sphere(r = 1);
translate([4, 0, 0]) cylinder(h = 2, r = 1);
translate([8, 0, 0]) cylinder(h = 2, r = 1.2, $fs = 0.4);
translate([12, 0, 0]) sphere(r = 1.5, $fa = 20, $fs = 0.1);
translate([16, 0, 0]) cylinder(h = 2, r1 = 1.5, r2 = 0.5, $fn = 19.7);
translate([0, 5, 0]) sphere(r = 1.5, $fn = 13);
translate([4, 5, 0]) sphere(r = 1.5, $fn = 14);
translate([8, 5, 0]) cylinder(h = 2, r = 1.5, $fn = 480);
translate([12, 5, 0]) cylinder(h = 2, r = 1.5, $fn = 2);
