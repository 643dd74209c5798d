$fn = 96;
sphere(r = 10);
translate([18, 3, 2]) sphere(d = 9);
translate([-15, 5, -4]) sphere(4);
