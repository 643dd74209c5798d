$fn = 48;
module hook() {
    difference() {
        cube([12, 6, 20]);
        translate([4, -1, 5]) cube([9, 8, 10]);
        translate([6, 3, 14]) cylinder(h = 10, r1 = 1, r2 = 3);
    }
}
hook();
mirror([1, 0, 0]) translate([3, 0, 0]) hook();
mirror([1, 1, 0]) translate([14, 0, 2]) hook();
mirror([1, 2, 3]) translate([18, 2, 0]) hook();
