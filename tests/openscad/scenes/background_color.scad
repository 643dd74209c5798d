// % takes its own colour and alpha, and reaches beyond the solid.
%color("red") cube(20);
translate([30, 0, 0]) %color([0, 0, 1, 0.4]) cube(20);
translate([60, 0, 0]) %color("green") difference() {
    cube(20);
    translate([5, -1, 5]) cube([30, 30, 30]);
}
translate([26, -10, 0]) cube(5);
