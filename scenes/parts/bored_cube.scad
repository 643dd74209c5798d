// A rounded cube with three bores: five solids.
$fn = 64;

difference() {
    intersection() {
        cube(20, center = true);
        sphere(13);
    }
    for (turn = [[0, 0, 0], [90, 0, 0], [0, 90, 0]])
        rotate(turn) cylinder(h = 30, r = 6, center = true);
}
