// The shadow of a mesh of many faces, and of solids beside it.

module torus(n, m) polyhedron(
    points = [for (i = [0:n - 1], j = [0:m - 1]) let (a = 360 * i / n, b = 360 * j / m)
        [(9 + 3 * cos(b)) * cos(a), (9 + 3 * cos(b)) * sin(a), 3 * sin(b)]],
    faces = [for (i = [0:n - 1], j = [0:m - 1]) let (k = (i + 1) % n, l = (j + 1) % m)
        each [[m * i + j, m * i + l, m * k + l], [m * i + j, m * k + l, m * k + j]]]);

linear_extrude(3) difference() {
    square(30, center = true);
    projection() {
        rotate([50, 20, 0]) torus(48, 24);
        translate([8, 8, 0]) rotate([10, 20, 30]) cube(4);
    }
}
