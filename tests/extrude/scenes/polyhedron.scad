// Convex, facing the wrong way at first.
function turned(faces) = [for (f = faces) [for (i = [len(f) - 1:-1:0]) f[i]]];
polyhedron(points = [[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0], [5, 5, 12]],
    faces = turned([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [3, 2, 1, 0]]));

// A star's prism.
n = 5;
star = [for (z = [0, 8]) for (i = [0:2 * n - 1]) let (r = i % 2 ? 4 : 12)
    [30 + r * cos(i * 36), r * sin(i * 36), z]];
polyhedron(points = star, faces = [
    [for (i = [0:2 * n - 1]) i],
    [for (i = [2 * n - 1:-1:0]) i + 2 * n],
    for (i = [0:2 * n - 1]) [i, i + 2 * n, (i + 1) % (2 * n) + 2 * n, (i + 1) % (2 * n)]]);

// A torus.
m = 12;
k = 8;
ring = [for (i = [0:m - 1]) for (j = [0:k - 1]) let (r = 12 + 5 * cos(j * 360 / k))
    [r * cos(i * 360 / m), 40 + r * sin(i * 360 / m), 5 * sin(j * 360 / k)]];
polyhedron(points = ring, faces = [for (i = [0:m - 1]) for (j = [0:k - 1])
    [i * k + j, i * k + (j + 1) % k, ((i + 1) % m) * k + (j + 1) % k, ((i + 1) % m) * k + j]]);

// Faces that are not plane.
translate([40, 40, 0]) difference() {
    polyhedron(
        points = [[0, 0, 0], [20, 0, 0], [20, 20, 0], [0, 20, 0], [0, 0, 10], [20, 0, 15],
            [20, 20, 9], [0, 20, 14]],
        faces = [[0, 1, 2, 3], [4, 5, 1, 0], [7, 6, 5, 4], [5, 6, 2, 1], [6, 7, 3, 2],
            [7, 4, 0, 3]]);
    translate([10, 10, -1]) cylinder(r = 4, h = 30, $fn = 30);
}
