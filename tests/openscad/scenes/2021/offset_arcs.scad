// Arcs that turn by a multiple of a half of their segments: the last bit decides how many they have.

for (i = [0 : 5])
    translate([22 * (i % 3), 22 * floor(i / 3), 0]) linear_extrude(4)
        offset(r = [4, 5, 3, 4, 7, -3][i], $fn = [6, 6, 12, 20, 3, 6][i]) circle(6, $fn = [4, 5, 8, 8, 4, 4][i]);
translate([66, 0, 0]) linear_extrude(4) offset(r = -2, $fn = 6) difference() { square(30, center = true); square(9); }
