// minkowski, resize, projection and the hull of drawings.
linear_extrude(5) minkowski() {
    difference() { square([20, 12]); translate([5, 4]) square([8, 4]); }
    circle(r = 1.5, $fn = 12);
}
translate([30, 0, 0]) linear_extrude(5) minkowski() {
    polygon([[0, 0], [12, 0], [12, 4], [4, 4], [4, 12], [0, 12]]);
    rotate(20) square(3, center = true);
    translate([1, 1]) polygon([[0, 0], [2, 0], [0, 1]]);
}
translate([0, 30, 0]) linear_extrude(5) minkowski() { square(5); square(0); }
translate([0, 40, 0]) linear_extrude(5) resize([20, 0], auto = true)
    difference() { circle(r = 4, $fn = 7); translate([3, -10]) square(20); }
translate([30, 40, 0]) linear_extrude(5) resize([5, 8]) translate([2, 2]) square([10, 4]);
translate([-30, 0, 0]) linear_extrude(5) projection() rotate([30, 40, 0]) difference() {
    cube(10);
    translate([5, 5, -1]) cylinder(r = 3, h = 20, $fn = 9);
}
translate([-30, 30, 0]) linear_extrude(5) projection(cut = true) {
    translate([0, 0, 2]) rotate([20, 0, 0]) difference() {
        cube([16, 12, 20], center = true);
        cylinder(r = 4, h = 40, $fn = 8, center = true);
    }
    translate([12, 0, 0]) cube(4);
}
