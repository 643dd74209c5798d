// A frame of many faces, not convex and too many to be cut, plus a box. In a preview, which is what
// csgcast shows, its sides are divided; OpenSCAD's mesh is of few faces.

k = $preview ? 12 : 1;
function along(corners, i) = let (j = floor(i / k), t = i % k / k)
    (1 - t) * corners[j % 4] + t * corners[(j + 1) % 4];
function place(i, j) = let (p = along([[6, 0], [6, 3], [3, 3], [3, 0]], j),
    q = along([[1, 1], [-1, 1], [-1, -1], [1, -1]], i)) [p.x * q.x, p.x * q.y, p.y];

difference() {
    minkowski() {
        polyhedron([for (i = [0:4 * k - 1], j = [0:4 * k - 1]) place(i, j)],
            [for (i = [0:4 * k - 1], j = [0:4 * k - 1]) let (m = 4 * k, r = (i + 1) % m, s = (j + 1) % m)
                [m * i + j, m * i + s, m * r + s, m * r + j]]);
        cube([1, 2, 0.5]);
    }
    translate([2, -9, 1]) cube(9);
}
