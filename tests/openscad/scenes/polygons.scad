// A $fn of 3 to 12 means the polygon.
for (n = [3 : 8])
    translate([(n - 3) * 14, 0, 0]) cylinder(h = 8, r = 6, $fn = n);
for (n = [3 : 8])
    translate([(n - 3) * 14, 18, 4]) sphere(r = 6, $fn = n);
for (n = [4 : 2 : 12])
    translate([(n - 4) * 7, 36, 0]) cylinder(h = 10, r1 = 6, r2 = (n - 4) / 2, $fn = n);
difference() {
    translate([-10, 50, 0]) cube([80, 16, 6]);
    for (i = [0 : 4])
        translate([i * 15, 58, 1]) cylinder(h = 5, r = 6, $fn = 6);
}
