// Of solids that a matrix makes flat the points are left for hull() and minkowski(), but of a union
// of several nothing is; faces of fewer than three corners have points as well.

hull() {
    scale([1, 1, 0]) cylinder(r = 4, h = 9, $fn = 7);
    translate([1, 1, 6]) cube(2);
    scale([0, 1, 1]) translate([0, 6, 0]) { cube(5); sphere(3, $fn = 6); }
}
translate([15, 0, 0]) hull() {
    polyhedron([[0, 0, 0], [0, 0, 7]], [[0, 1]]);
    rotate([20, 30, 0]) scale([2, 2, 0]) group() translate([1, 0, 3]) sphere(2, $fn = 8);
}
translate([30, 0, 0]) difference() {
    minkowski() { cube(4); scale([1, 0, 1]) cube(2); }
    translate([2, -1, 2]) cube([2, 9, 9]);
}
