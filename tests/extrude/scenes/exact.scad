// Round by nature: compared with a mesh of fine facets.
$fn = 50;
linear_extrude(height = 10) difference() {
    square([40, 30]);
    translate([20, 15]) circle(r = 8);
}
translate([60, 0, 0]) linear_extrude(height = 12, center = true, scale = 0.4) {
    circle(r = 10);
    translate([8, 0]) square(10);
}
translate([90, 0, 0]) linear_extrude(height = 12, scale = 0) scale([1, 0.5]) circle(r = 10);
translate([0, 50, 0]) linear_extrude(height = 4) hull() {
    circle(5);
    translate([20, 3]) circle(2);
    translate([0, 15]) square(3);
}
translate([50, 50, 0]) linear_extrude(height = 4) offset(r = 3) square([20, 10]);
translate([90, 50, 0]) linear_extrude(height = 4) offset(r = -2) difference() {
    square([30, 20]);
    translate([10, 5]) square([5, 8]);
}
translate([0, 90, 0]) linear_extrude(height = 4) difference() {
    offset(r = 2) circle(10);
    circle(10);
}
translate([50, 100, 0]) rotate_extrude() polygon([[5, 0], [15, 0], [15, 4], [9, 6], [9, 12], [5, 14]]);
translate([90, 100, 0]) rotate_extrude(angle = 220) translate([4, 0]) square([8, 5]);
// Hulls of cylinders side by side are exact as well.
translate([0, 140, 0]) hull() for (x = [0, 20], y = [0, 12]) translate([x, y, 0])
    cylinder(r = 3, h = 6);
translate([50, 140, 0]) rotate([30, 40, 10]) hull() {
    cylinder(r = 8, h = 5, center = true);
    translate([20, 3, 0]) cylinder(r = 4, h = 5, center = true);
    translate([5, 1, 0]) cylinder(r = 1, h = 5, center = true);
}
translate([90, 140, 0]) difference() {
    hull() {
        cylinder(r = 8, h = 5);
        translate([20, 3, 0]) rotate([180, 0, 0]) translate([0, 0, -5]) cylinder(r = 8, h = 5);
    }
    translate([0, 0, -1]) cylinder(r = 4, h = 10);
}
