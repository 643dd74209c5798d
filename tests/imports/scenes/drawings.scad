// Drawings in files, below extrusions and by themselves in Booleans.
linear_extrude(5) import("page.svg");
translate([0, 60, 0]) mirror([1, 0, 0]) linear_extrude(10, scale = [0.5, 0.8])
    import("page.svg", center = true, dpi = 96);
translate([80, 0, 0]) linear_extrude(8) difference() {
    import("part.dxf", layer = "part", $fn = 24);
    translate([14, 24]) circle(3, $fn = 9);
}
translate([80, 60, 0]) linear_extrude(file = "part.dxf", layer = "more", origin = [26, 0], height = 4);
translate([140, 40, 0]) rotate_extrude(file = "part.dxf", layer = "part", scale = 0.5, $fn = 16);
