// # on all of the scene: the solids show through.
#color("green") cube(20);
color("blue") translate([30, 0, 0]) #cube(12);
#translate([0, 30, 0]) difference() {
    cube(12);
    translate([6, 6, 6]) cube(12);
}
