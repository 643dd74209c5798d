// A random tree of unions, differences and intersections over n spheres, cubes and cylinders, of
// the given depth: -D n=256 -D depth=8, -D n=4096 -D depth=16.
n = 256;
depth = 8;
seed = 1;
fn = 32;

share = pow(n, -1 / depth); // of a node's solids that its larger half takes

function random(key, lo, hi) = rands(lo, hi, 1, key)[0];
function place(at, size, key) = [for (i = [0 : 2]) at[i] + random(key + 0.1 * i, -size, size)];

module solid(at, key) {
    r = random(key + 0.3, 2, 5);
    kind = floor(random(key + 0.4, 0, 3));
    translate(at) rotate([random(key + 0.5, 0, 180), random(key + 0.6, 0, 180), 0])
        if (kind == 0) sphere(r, $fn = fn);
        else if (kind == 1) cube(1.6 * r, center = true);
        else cylinder(h = 3 * r, r = 0.7 * r, center = true, $fn = fn);
}

module tree(n, at, size, key) {
    half = min(n - 1, max(1, round(share * n)));
    op = random(key + 0.7, 0, 1);
    a = place(at, size, key + 1000);
    b = place(at, size, key + 2000);
    if (n == 1) solid(at, key);
    else if (op < 0.6) { tree(half, a, 0.8 * size, 2 * key); tree(n - half, b, 0.8 * size, 2 * key + 1); }
    else if (op < 0.85) difference() {
        tree(half, a, 0.8 * size, 2 * key);
        tree(n - half, b, 0.8 * size, 2 * key + 1);
    }
    else intersection() {
        tree(half, at, 0.5 * size, 2 * key);
        tree(n - half, at, 0.5 * size, 2 * key + 1);
    }
}

difference() { // one object, whatever the random root is
    intersection() {
        cube(80, center = true);
        tree(n - 2, [0, 0, 0], 16, seed);
    }
    translate([0, 0, 62]) cube(80, center = true);
}
