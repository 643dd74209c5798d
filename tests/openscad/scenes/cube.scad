// Every way to write a cube.
cube([30, 20, 10]);
translate([40, 10, 5]) cube([12, 20, 10], center = true);
translate([5, 30, 0]) cube(8);
translate([30, 34, 4]) cube(8, center = true);
translate([50, 30, 0]) cube([1, 2.5, 17.25]);
