// Twisted, with holes; twisted and scaled to less, to more and to a point; clockwise and not.
linear_extrude(height = 20, twist = 90, slices = 20) difference() {
    square(10, center = true);
    circle(r = 3, $fn = 12);
}
translate([0, 30, 0]) linear_extrude(height = 20, twist = -200, scale = 0.3, center = true, $fn = 30)
    translate([2, 0]) square([6, 4]);
translate([-30, 30, 0]) linear_extrude(height = 12, twist = 100, scale = 1.7) {
    translate([4, 0]) circle(r = 3);
    translate([-4, 0]) circle(r = 3);
}
translate([30, -30, 0]) linear_extrude(height = 20, twist = 45, scale = 0, $fn = 50)
    square([10, 4], center = true);
translate([-30, 0, 0]) linear_extrude(height = 15, twist = 400, $fa = 20) translate([5, 0]) circle(2);
// Scaled along x and y differently, also to a line.
translate([30, 0, 0]) linear_extrude(height = 20, scale = [2, 0.5]) difference() {
    circle(r = 6, $fn = 20);
    translate([2, 1]) square(3);
}
translate([30, 30, 0]) linear_extrude(height = 20, scale = [0, 1]) square(10, center = true);
translate([-30, -30, 0]) difference() {
    linear_extrude(height = 10, scale = [0.5, 1.5], $fn = 3) square([16, 12], center = true);
    translate([0, 0, -1]) cylinder(h = 20, r = 3, $fn = 16);
}
