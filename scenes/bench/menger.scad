// Menger's sponge of a level as one difference: each box goes through the whole cube.
// Levels 3, 4, 5 have 220, 1,756 and 14,044 boxes.
level = 3;

size = 27;
// The squares of one side that are taken away: positions and sizes in units of the side.
function squares(level, x, y, s) =
    level == 0 ? [] :
    concat([[x + s / 3, y + s / 3, s / 3]],
           [for (i = [0 : 2], j = [0 : 2]) if (i != 1 || j != 1)
               each squares(level - 1, x + i * s / 3, y + j * s / 3, s / 3)]);

module bars()
    for (q = squares(level, -0.5, -0.5, 1))
        translate(size * [q[0], q[1], -0.6]) cube(size * [q[2], q[2], 1.2]);

difference() {
    cube(size, center = true);
    bars();
    rotate([90, 0, 0]) bars();
    rotate([0, 90, 0]) bars();
}
