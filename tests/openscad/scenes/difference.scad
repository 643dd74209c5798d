$fn = 64;
difference() {
    cube(20, center = true);
    sphere(r = 12);
    translate([8, 8, 0]) cylinder(h = 30, r = 3, center = true);
}
