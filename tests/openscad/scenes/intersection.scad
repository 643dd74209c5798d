$fn = 64;
intersection() {
    cube(20, center = true);
    sphere(r = 13);
    rotate([20, 10, 0]) cylinder(h = 40, r1 = 14, r2 = 5, center = true);
}
