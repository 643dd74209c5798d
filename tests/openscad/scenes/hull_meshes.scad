// Of meshes in a hull only the points count: of many faces, open and flat ones alike. A mesh of many
// faces is resized by its box.

module torus(n, m) polyhedron(
    points = [for (i = [0:n - 1], j = [0:m - 1]) let (a = 360 * i / n, b = 360 * j / m)
        [(9 + 3 * cos(b)) * cos(a), (9 + 3 * cos(b)) * sin(a), 3 * sin(b)]],
    faces = [for (i = [0:n - 1], j = [0:m - 1]) let (k = (i + 1) % n, l = (j + 1) % m)
        each [[m * i + j, m * i + l, m * k + l], [m * i + j, m * k + l, m * k + j]]]);

hull() {
    torus(48, 24);
    translate([0, 0, 12]) polyhedron([[-2, 0, 0], [2, 0, 0], [0, 3, 0], [0, 1, 4]],
        [[0, 1, 2], [0, 3, 1]]);
}
translate([0, 0, -12]) resize([24, 0, 9]) torus(48, 24);
