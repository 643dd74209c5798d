// Discs next to nothing thick, of more faces than are cut out of a box: a hull needs all corners.
module disc(r) linear_extrude(1e-12) circle(r, $fn = 100);
module plate() hull() for (x = [-6, 6], y = [-4, 4]) translate([x, y, 0]) disc(2);
hull() { translate([0, 0, 10]) disc(2); disc(3); }
translate([20, 0, 0]) hull() { translate([0, 0, 10]) plate(); plate(); }
