// An assembly: copies of a part of 30 solids side by side.
copies = 200;
fn = 48;

module foot() difference() {
    cylinder(h = 3, r = 4, $fn = fn);
    translate([0, 0, -1]) cylinder(h = 5, r = 1.6, $fn = fn);
    translate([0, 0, 2]) cylinder(h = 2, r1 = 1.6, r2 = 2.8, $fn = fn);
}

module part() { // 4 feet of 3 solids, a housing of 18
    for (x = [5, 35], y = [5, 25]) translate([x, y, 0]) foot();
    difference() {
        translate([4, 4, 2]) cube([32, 22, 20]);
        translate([6, 6, 4]) cube([28, 18, 19]);
        for (i = [0 : 4]) translate([8 + 6 * i, 3, 12]) rotate([-90, 0, 0])
            cylinder(h = 24, r = 2, $fn = fn);
        for (i = [0 : 2]) translate([3, 9 + 6 * i, 12]) rotate([0, 90, 0])
            cylinder(h = 34, r = 2, $fn = fn);
        for (x = [5, 35], y = [5, 25]) translate([x, y, 16]) sphere(2.5, $fn = fn);
        for (i = [0 : 3]) translate([10 + 6 * i, 10, 1]) cube([2, 10, 4]);
    }
}

columns = ceil(sqrt(copies));
for (i = [0 : copies - 1])
    translate([45 * (i % columns), 35 * floor(i / columns), 0]) part();
