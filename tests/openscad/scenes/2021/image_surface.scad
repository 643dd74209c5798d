// The brightness of an image as heights, and the other way round.

difference() {
    surface("heights.png", center = true);
    translate([0.5, 0.5, -2]) cube([9, 9, 200]);
}
translate([12, 0, 20]) surface("heights.png", invert = true);
