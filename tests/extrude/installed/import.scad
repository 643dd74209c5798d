import("files/bead.stl");
translate([25, 0, 0]) difference() {
    import("files/bead_binary.stl", convexity = 4);
    translate([0, -20, -20]) cube([20, 20, 40]);
}
translate([-20, 0, 0]) import("files/prism.off");
translate([0, 20, 0]) surface("files/heights.dat");
translate([20, 25, 0]) intersection() {
    scale([3, 3, 1]) surface(file = "files/heights.dat", center = true);
    cylinder(r = 5.5, h = 10, $fn = 9);
}
import("files/missing.stl");
