// Sums with a sphere; sum_mesh.scad has the same solids as hulls.
$fn = 24;
minkowski() {
    translate([1, 2, 3]) sphere(2);
    rotate(30) cube([15, 10, 5]);
}
translate([30, 0, 0]) minkowski() {
    difference() {
        cube(12);
        translate([4, -1, -1]) cube([4, 7, 20]);
    }
    sphere(1);
}
translate([0, 30, 0]) minkowski() {
    sphere(2);
    translate([3, 0, 0]) sphere(1);
}
