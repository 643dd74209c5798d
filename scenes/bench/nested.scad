// A random tree of unions, differences and intersections over n spheres, cubes and cylinders, of
// the given depth: -D n=256 -D depth=8, -D n=4096 -D depth=16.
n = 256;
depth = 8;
seed = 1;
fn = 32;

share = pow(n, -1 / depth); // of a node's solids that its larger half takes
radius = 16 * pow(n, -1 / 3);

module solid(key) {
    v = rands(0, 1, 7, key);
    r = radius * (0.7 + 0.8 * v[3]);
    translate([for (i = [0 : 2]) 20 * v[i] - 10]) rotate([180 * v[4], 180 * v[5], 0])
        if (v[6] < 0.33) sphere(r, $fn = fn);
        else if (v[6] < 0.66) cube(1.6 * r, center = true);
        else cylinder(h = 3 * r, r = 0.7 * r, center = true, $fn = fn);
}

// Of two solids apart there is no intersection: the second one is a large sphere.
module tree(n, key) {
    half = min(n - 1, max(1, round(share * n)));
    op = rands(0, 1, 8, key)[7];
    if (n == 1) solid(key);
    else if (n == 2 && op < 0.3) intersection() {
        solid(2 * key);
        sphere(11, $fn = fn);
    }
    else if (op < 0.5) difference() {
        tree(half, 2 * key);
        tree(n - half, 2 * key + 1);
    }
    else {
        tree(half, 2 * key);
        tree(n - half, 2 * key + 1);
    }
}

difference() { // one object, whatever the random root is
    sphere(11, $fn = fn);
    tree(n - 2, seed);
    translate([0, -20, 4]) cube(20);
}
