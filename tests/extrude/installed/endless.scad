// Cuts that are meant to go on for ever.
difference() {
    linear_extrude(10) difference() {
        square([60, 40]);
        translate([20, 25]) square([12, 1e11]);
    }
    translate([40, -1e11, 5]) linear_extrude(20) square([8, 1e11 + 10]);
}
translate([0, 60]) linear_extrude(5) offset(delta = 1) difference() {
    square([60, 40]);
    translate([-1e9, 12]) square([1e9 + 20, 3]);
}
