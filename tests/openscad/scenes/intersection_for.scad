$fn = 64;
intersection_for (a = [0 : 60 : 120])
    rotate([a, a / 2, 10]) cube([30, 16, 12], center = true);
translate([30, 0, 0]) intersection_for (p = [[0, 0, 0], [6, 0, 0], [3, 5, 0], [3, 2, 5]])
    translate(p) sphere(r = 7);
