$fn = 64;
rotate([15, 35, 65]) difference() {
    cube([20, 14, 10], center = true);
    rotate([0, 90, 0]) cylinder(h = 30, r = 3, center = true);
}
rotate(a = 50, v = [1, 1, 1]) translate([25, 0, 0]) cylinder(h = 18, r1 = 5, r2 = 3, center = true);
rotate([0, -120, 10]) translate([20, 5, 0]) rotate(45) cube([8, 8, 3]);
