resize([10, 20, 5]) cube([1, 2, 3]);
translate([30, 0, 0]) resize([15, 0, 0], auto = [true, true, false]) rotate([10, 20, 30])
    cylinder(r = 3, h = 8, $fn = 10);
translate([0, 30, 0]) resize([0, 0, 20]) difference() {
    sphere(r = 6, $fn = 12);
    translate([0, 0, -20]) cube([20, 20, 40]);
}
translate([30, 30, 0]) difference() {
    resize([12, 12, 12]) hull() { cube(3); translate([5, 0, 4]) cube(1); }
    translate([4, 4, -1]) cube([4, 4, 20]);
}
translate([-30, 0, 0]) resize([8, 8, 8], auto = true) group();
