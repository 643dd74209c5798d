// A plate with n x n holes: -D n=10 is 100 holes, -D n=32 is 1,024.
n = 10;
fn = 64;

pitch = 100 / n;
difference() {
    cube([100, 100, 5]);
    for (i = [0 : n - 1], j = [0 : n - 1])
        translate([(i + 0.5) * pitch, (j + 0.5) * pitch, -1])
            cylinder(h = 7, r = 0.35 * pitch, $fn = fn);
}
