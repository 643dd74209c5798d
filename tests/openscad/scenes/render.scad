// render() shows one mesh of one colour, and what is left of it is framed; what is cut outside of
// it is cut as ever.
$fn = 48;
difference() {
    render(convexity = 4) difference() {
        color("red") cube(20, center = true);
        color("green") cylinder(h = 40, r = 6, center = true);
    }
    translate([0, -10, 0]) render(convexity = 4) difference() {
        cube(6, center = true);
        translate([0, 0, 2]) cube(4, center = true);
    }
}
color("blue") translate([25, 0, 0]) render(convexity = 4) difference() {
    linear_extrude(12) difference() {
        circle(8);
        circle(4);
    }
    color("red") translate([0, 0, 8]) cube(20);
}
translate([0, 25, 0]) render() intersection() {
    translate([-50, -50, -3]) cube(100);
    cube([12, 12, 20], center = true);
}
translate([30, 25, 0]) rotate([0, 0, 30]) linear_extrude(5) {
    circle(6);
    translate([14, 0]) circle(4);
}
translate([0, 50, 0]) render() {
    #cube(6);
    %translate([0, 0, 10]) cube(6);
}
