// A cube less k intersections of a sphere and a cylinder: written as a union of products it has
// 2^k (k + 1) terms.
k = 14;
fn = 32;

module bite(i) {
    a = 137.508 * i;          // spread evenly over the upper half of a ball
    z = 1 - i / k;
    translate(12 * [cos(a) * sqrt(1 - z * z), sin(a) * sqrt(1 - z * z), z])
        intersection() {
            sphere(4, $fn = fn);
            rotate([0, 0, a]) rotate([90, 0, 0])
                cylinder(h = 10, r = 2.5, center = true, $fn = fn);
        }
}

difference() {
    translate([-10, -10, -10]) cube([20, 20, 19]);
    for (i = [0 : k - 1]) bite(i);
}
