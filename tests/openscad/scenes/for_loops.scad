$fn = 32;
difference() {
    cube([52, 40, 6]);
    for (x = [6 : 8 : 46], y = [6 : 8 : 34])
        translate([x, y, -1]) cylinder(h = 8, r = 1 + (x + y) / 40);
}
for (a = [0 : 45 : 315])
    translate([26, 20, 12]) rotate(a) translate([12, 0, 0]) rotate([0, 60, 0]) cube([2, 4, 9]);
