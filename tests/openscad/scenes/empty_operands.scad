$fn = 32;
union() {}
difference() {
    cube(10);
    union() {}
    group() {}
}
difference() {
    group() {}
    translate([15, 0, 0]) cube(10);
}
intersection() {
    translate([30, 0, 0]) cube(10);
    group() {}
}
intersection() {
    translate([15, 0, 0]) cube(10);
    union() {
        translate([15, 0, 0]) sphere(r = 6);
        group() {}
        translate([25, 10, 10]) sphere(r = 7);
    }
}
for (i = []) sphere(r = 50);
