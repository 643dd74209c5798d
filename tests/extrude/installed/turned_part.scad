// OpenSCAD 2021.01 leaves the part of a segment out, 2025 makes one of it.
rotate_extrude(angle = 120, $fn = 50) translate([10, 0]) square([5, 9]);
translate([40, 0]) rotate_extrude(angle = 90, $fa = 8, $fs = 0.25) translate([3, 0]) circle(2, $fn = 9);
translate([0, 40]) rotate_extrude(angle = -80, $fn = 40) translate([-10, 0]) circle(6, $fn = 9);
