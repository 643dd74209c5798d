$fn = 48;
color("red") difference() {
    cube(16, center = true);
    color("blue") sphere(r = 9.5);
}
color([0.1, 0.8, 0.3]) translate([20, 0, 0]) cylinder(h = 12, r = 5, center = true);
difference() {
    translate([0, 20, 0]) cube(12, center = true);
    color("#ffaa00") translate([4, 16, 4]) cube(12, center = true);
}
color("navy", 1.0) translate([20, 20, 0]) sphere(r = 6);
