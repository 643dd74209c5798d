linear_extrude(height = 10) difference() {
    square([40, 30]);
    translate([20, 15]) circle(r = 8, $fn = 64);
}
// Scaled, up to a point.
translate([50, 0, 0]) linear_extrude(height = 12, center = true, scale = 0.5) {
    circle(r = 10, $fn = 40);
    translate([8, 0]) square(10);
}
translate([50, 50, 0]) rotate([20, 30, 10]) linear_extrude(height = 15, scale = 0)
    translate([3, 4]) polygon(
        [[0, 0], [20, 0], [20, 20], [0, 20], [5, 5], [15, 5], [15, 15], [5, 15]],
        paths = [[0, 1, 2, 3], [4, 5, 6, 7]]);
// Not convex, many corners, crossing itself.
translate([0, 50, 0]) linear_extrude(height = 5)
    polygon([[0, 0], [30, 0], [30, 20], [15, 8], [0, 20], [5, 10]]);
translate([-50, 50, 0]) linear_extrude(height = 4) polygon(
    [for (i = [0:199]) let (r = 10 + 4 * (i % 2) + 3 * sin(i * 7)) r * [cos(i * 1.8), sin(i * 1.8)]]);
translate([-50, -50, 0]) linear_extrude(height = 4)
    polygon([for (i = [0:6]) 15 * [cos(i * 360 * 3 / 7), sin(i * 360 * 3 / 7)]]);
// Overlapping.
translate([-50, 0, 0]) linear_extrude(height = 7) for (i = [0:20])
    rotate(i * 360 / 21) translate([10, 0]) rotate(30) square([6, 2], center = true);
