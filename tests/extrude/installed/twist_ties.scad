// Sides in the plane of the axis: both diagonals are equally long.
linear_extrude(height = 10, twist = 3) square(20);
translate([40, 0, 0]) linear_extrude(height = 10, twist = -30, slices = 3) square(20);
translate([0, 40, 0]) linear_extrude(height = 20, twist = 30, slices = 2) difference() {
    translate([-1, -1]) square(10);
    square(8);
}
translate([40, 40, 0]) linear_extrude(height = 10, scale = [2, 1]) square(10, center = true);
