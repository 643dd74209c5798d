// Alike from no two sides: for the camera. Without rounding, so that pictures compare sharply.
cube([30, 20, 10]);
translate([5, 5, 9]) cube([8, 6, 14]);
translate([20, -10, 2]) cube([4, 30, 4]);
translate([-7, 3, 1]) rotate([10, 20, 30]) cube([12, 4, 5]);
