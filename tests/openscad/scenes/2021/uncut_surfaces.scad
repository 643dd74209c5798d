// Surfaces of triangles beside Booleans, as operands of hull, resize and minkowski. In a preview,
// which is what csgcast shows, the tube has too many faces to be cut.

k = $preview ? 360 : 24;

module roof() polyhedron([[0, 0, 0], [4, 0, 0], [4, 5, 0], [0, 5, 0], [2, 0, 3], [2, 5, 3]],
    [[0, 1, 2, 3], [0, 4, 1], [3, 2, 5], [0, 3, 5, 4], [1, 4, 5, 2]]);
module corner() difference() { cube(4); translate([1, 1, -1]) cube(9); }
module tube() polyhedron([for (i = [0:k - 1]) let (p = let (j = i % (k / 4) * 4 / k) floor(4 * i / k) == 0 ? [6 - 12 * j, -6]
        : floor(4 * i / k) == 1 ? [-6, -6 + 12 * j] : floor(4 * i / k) == 2 ? [-6 + 12 * j, 6] : [6, 6 - 12 * j])
        each [for (q = [[1, 0], [0.6, 0], [0.6, 2], [0.8, 2], [0.8, 1], [1, 1]]) [p.x * q[0], p.y * q[0], q[1]]]],
    [for (i = [0:k - 1], j = [0:5]) let (r = (i + 1) % k, s = (j + 1) % 6) [6 * i + s, 6 * i + j, 6 * r + j, 6 * r + s]]);

hull() { roof(); translate([9, 0, 1]) corner(); rotate_extrude(angle = 90, $fn = 8) translate([5, 0]) square([2, 1]); }
translate([0, 20, 0]) resize([8, 0, 0], auto = true) { roof(); translate([3, 1, 1]) corner(); }
translate([30, 10, 0]) difference() {
    minkowski() { union() { tube(); translate([2, 2, 1]) corner(); } cube([0.5, 1, 0.5]); }
    translate([2, -9, 1]) cube(9);
}
