// Faces that are not plane: OpenSCAD cuts them where the solid first meets another one.

module prism(bottom, top) {
    n = len(bottom);
    polyhedron(points = concat(bottom, top), faces = concat(
        [[for (i = [n - 1:-1:0]) i], [for (i = [0:n - 1]) n + i]],
        [for (i = [0:n - 1]) [i, (i + 1) % n, n + (i + 1) % n, n + i]]));
}

module block() // all diagonals of one length
    prism([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], [[0, 0, 4], [4, 0, 5], [4, 4, 4], [0, 4, 5]]);

module star() let (n = 7) prism(
    [for (i = [0:n - 1]) 4 * [cos(360 * i / n), sin(360 * i / n), 0]],
    [for (i = [0:n - 1]) (3 + i % 2) * [cos(360 * i / n + 25), sin(360 * i / n + 25), 0] +
        [0, 0, 5 + (i * i) % 3]]);

rotate([20, 40, 60]) scale([1, 2, 0.5]) block();
translate([12, 0, 0]) mirror([1, 1, 0]) rotate([0, 30, 0]) block();
translate([-12, 0, 0]) rotate([50, 0, 20]) difference() {
    star();
    translate([0, 0, 3]) cube([1, 9, 9]);
    rotate([90, 0, 0]) scale(0.4) star();
}
translate([0, 14, 0]) rotate([0, 70, 0]) intersection() {
    star();
    mirror([0, 0, 1]) translate([0, 0, -5]) star();
}
translate([12, 14, 0]) resize([2, 9, 0], auto = [false, false, true]) rotate([10, 20, 0]) star();
