$fn = 48;
difference() {
    *sphere(r = 40);
    cube(20, center = true);
    *cube([50, 50, 5], center = true);
    cylinder(h = 30, r1 = 3, r2 = 8, center = true);
}
*translate([30, 0, 0]) cube(5);
