// Hulls of spheres and boxes: planes, cylinders, cones and spheres.
$fn = 24;
hull() for (x = [0, 20], y = [0, 12], z = [0, 8]) translate([x, y, z]) sphere(2);
translate([30, 0, 0]) hull() { sphere(5); translate([0, 0, 12]) sphere(2); }
translate([50, 0, 0]) hull() {
    sphere(3);
    translate([12, 0, 0]) sphere(1);
    translate([4, 10, 0]) sphere(2);
    translate([5, 3, 9]) sphere(0.5);
    translate([4, 3, 1]) sphere(1);
}
translate([55, 30, 0]) hull() { cube([10, 10, 1]); translate([5, 5, 8]) sphere(3); }
translate([0, 60, 0]) rotate([20, 30, 0]) hull()
    for (x = [0, 10], y = [0, 10]) translate([x, y, 0]) sphere(2);
translate([30, 60, 0]) hull() for (i = [0:5]) translate([i * 3, 0, 0]) sphere(1 + i % 3);
translate([30, 30, 0]) difference() {
    hull() { sphere(4); translate([10, 0, 0]) sphere(4); translate([10, 0, 0]) sphere(4); }
    translate([0, -10, 4]) cube(20);
    translate([-10, -10, 0]) cube([30, 10, 30]);
}
