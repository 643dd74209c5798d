// Sections of what is askew: their corners are on no grid, but where Clipper combines them. Small
// ones, beside which the grid is coarse, and enlarged afterwards.
module small() scale(0.01) children();
scale([100, 100, 1]) linear_extrude(height = 1) projection(cut = true) small()
    rotate([20, 30, 10]) cube([3.3, 2.2, 5.5], center = true);
translate([6, 0, 0]) scale([100, 100, 1]) linear_extrude(height = 1) projection(cut = true) small()
    translate([0, 0, -3.3]) linear_extrude(height = 10, twist = 77, slices = 7) difference() {
        circle(3, $fn = 7);
        translate([1, 0]) circle(1, $fn = 5);
    }
translate([0, 7, 0]) scale([100, 100, 1]) linear_extrude(height = 1) difference() {
    projection(cut = true) small() translate([0, 0, -3.3])
        linear_extrude(height = 10, twist = 77, slices = 7) square([3, 2]);
    circle(0.01, $fn = 7);
}
translate([6, 7, 0]) scale([100, 100, 1]) linear_extrude(height = 1) mirror([1, 0.3])
    projection(cut = true) small() translate([0, 0, -3.3]) {
        linear_extrude(height = 10, twist = 77, slices = 7) square([3, 2]);
        cylinder(h = 8, r1 = 2, r2 = 1.3, $fn = 9);
    }
