// % is not part of the solid: the next child is the minuend.
$fn = 48;
difference() {
    %translate([0, 0, 4]) cube(30, center = true);
    cube(20, center = true);
    cylinder(h = 40, r = 6, center = true);
}
%translate([52, 0, 0]) sphere(r = 10);
intersection() {
    translate([30, 0, 0]) cube(12, center = true);
    %translate([30, 0, 0]) sphere(r = 7);
}
