// Sections of a mesh whose faces six digits bend apart: of it and of Booleans with it, also where a
// face of it lies at z = 0.
module part() import("coarse_part.off");
linear_extrude(1) projection(cut = true) rotate([20, 31, 7]) part();
translate([12, 0, 0]) linear_extrude(1) projection(cut = true) part();
translate([24, 0, 0]) linear_extrude(1) projection(cut = true)
    difference() { translate([0, 0, -1]) part(); rotate([0, 40, 20]) cube([3, 3, 9], center = true); }
translate([0, 12, 0]) linear_extrude(1) projection(cut = true)
    difference() { translate([1, 1, -1]) cube([7, 8, 2]); rotate([70, 0, 0]) part(); }
translate([14, 12, 0]) linear_extrude(1) projection(cut = true) {
    intersection() { rotate([-10, 20, 30]) part(); sphere(4, $fn = 9); }
    mirror([1, 0.3, 0.1]) rotate([10, 5, 0]) part();
}
translate([0, -14, 0]) linear_extrude(2) projection(cut = true)
    translate([0, 0, 0.412793]) rotate([25.0055, 12.3234, 0]) part();
