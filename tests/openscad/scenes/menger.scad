// Many boxes on one ray, all faces flush.
module sponge(n, s) {
    if (n == 0)
        cube(s);
    else
        for (x = [0 : 2], y = [0 : 2], z = [0 : 2])
            if ((x == 1 ? 1 : 0) + (y == 1 ? 1 : 0) + (z == 1 ? 1 : 0) < 2)
                translate(s / 3 * [x, y, z]) sponge(n - 1, s / 3);
}
sponge(2, 27);
