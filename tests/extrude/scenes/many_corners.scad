// Polygons of so many convex pieces that they become surfaces: flush with other solids, subtracted,
// scaled, with holes, and crossing themselves.

function star(n, a, b) = [for (i = [0:n - 1]) let (r = i % 2 ? a : b) [r * cos(i * 360 / n), r * sin(i * 360 / n)]];

difference() {
    union() {
        linear_extrude(height = 4) difference() {
            polygon(star(300, 10, 8));
            circle(r = 3, $fn = 40);
        }
        translate([0, 0, 4]) cylinder(r = 5, h = 2, $fn = 24);
        translate([8, -1, 0]) cube([6, 2, 4]);
    }
    translate([5, 0, -1]) cube([2, 2, 4]);
    translate([-6, 0, 2]) linear_extrude(height = 2) polygon(star(260, 2, 1.5));
}

translate([24, 0, 0]) linear_extrude(height = 5, scale = 0.5) polygon(star(280, 6, 5));

translate([-22, 0, 0]) linear_extrude(height = 3, center = true)
    polygon(concat(star(300, 6, 4), star(40, 3, 2)), paths = [[for (i = [0:299]) i], [for (i = [300:339]) i]]);
