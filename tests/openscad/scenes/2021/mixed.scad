// A figure comes first: all is shown, figures as slabs, those under % too.
translate([8, 0, 0]) difference() {
    square(12, center = true);
    circle(4);
}
cube([4, 6, 8]);
%translate([-8, 0, 0]) circle(5);
union() {
    translate([0, -14, 0]) cube(5);
    translate([8, -16, 0]) %square([12, 3]);
}
