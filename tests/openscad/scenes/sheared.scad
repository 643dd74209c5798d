$fn = 64;
multmatrix([[1, 0.4, 0.7, 0], [0, 1, 0.2, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    difference() {
        cube([20, 15, 12]);
        translate([10, 7, -1]) cylinder(h = 14, r = 4);
    }
translate([40, 0, 6]) multmatrix([[1, 0.5, 0, 0], [0.3, 1, 0.4, 0], [0, 0, 1, 0]]) sphere(r = 8);
translate([0, 35, 0]) multmatrix([[1, 0, 0.8, 0], [0, 1, 0, 0], [0, 0, 1, 0]])
    cylinder(h = 14, r1 = 7, r2 = 2);
