// Unions of spheres and cylinders at all angles.
$fn = 32;
module bond(a, b) {
    d = b - a;
    translate(a) rotate([0, acos(d[2] / norm(d)), atan2(d[1], d[0])]) cylinder(h = norm(d), r = 0.8);
}
atoms = [[0, 0, 0], [8, 2, 1], [12, 9, -2], [6, 14, 3], [-2, 10, 5], [-4, 3, -6]];
for (i = [0 : 5]) {
    translate(atoms[i]) sphere(r = 2 + i / 4);
    bond(atoms[i], atoms[(i + 1) % 6]);
}
