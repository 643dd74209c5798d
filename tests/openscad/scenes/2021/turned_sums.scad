// SPDX-License-Identifier: MIT
// Turned profiles in flat segments as operands of sums and hulls: convex ones on either side of the
// axis, with tips and with flat ends, one with a waist, one that is hollow, and a part of a turn.
module ball(side) {
    rotate_extrude($fn = 14) polygon([
        [0, -3], [side * 1.2, -2.7], [side * 2.4, -1.6], [side * 3, 0], [side * 2.5, 1.5],
        [side * 1, 2.8], [0, 2.9]
    ]);
}
module drum() {
    rotate_extrude($fn = 9) polygon([[0, -2], [1.5, -2], [2.5, -1], [3, 1], [2, 2], [0, 2]]);
}
module waist() {
    rotate_extrude($fn = 8) polygon([[0, -3], [3, -3], [1.5, -0.5], [1.4, 0.5], [2.5, 3], [0, 3]]);
}
minkowski() { cube([4, 3, 2]); ball(1); }
translate([14, 0, 0]) minkowski() { cube([2, 3, 1]); ball(-1); }
translate([0, 14, 0]) minkowski() { cube([4, 1, 2]); drum(); }
translate([14, 14, 0]) hull() { ball(1); translate([5, 1, 1]) drum(); }
translate([28, 0, 0]) minkowski() { cube([1, 2, 1]); waist(); }
translate([28, 14, 0]) minkowski() {
    cube([1, 2, 1]);
    rotate_extrude($fn = 8) polygon([[1, -1], [3, -1], [3.5, 0], [2.5, 1], [1.5, 0.5]]);
}
translate([0, 28, 0]) minkowski() {
    cube([2, 1, 1]);
    rotate_extrude($fn = 12, angle = 150) polygon([[0, -2], [2, -1], [2.5, 0], [1.5, 1], [0, 2]]);
}
