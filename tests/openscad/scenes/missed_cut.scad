// A plate with 21 holes and a cutter that misses it: with that the largest tree of which solids that do not show are kept.

difference() {
    cube([60, 50, 5]);
    for (i = [0 : 20]) translate([6 + 12 * (i % 5), 6 + 11 * floor(i / 5), -1]) cylinder(h = 9, r = 3, $fn = 30);
    translate([0, 0, 20]) cylinder(h = 3, r = 4, $fn = 30);
}
