$fn = 64;
union() {
    cube([20, 20, 10]);
    translate([20, 20, 5]) sphere(r = 7);
    translate([0, 10, 5]) rotate([0, 90, 0]) cylinder(h = 35, r = 3, center = true);
}
