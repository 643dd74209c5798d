// # shows and still counts.
$fn = 48;
difference() {
    cube(20, center = true);
    #cylinder(h = 15, r = 6, center = true);
    translate([8, 8, 8]) #sphere(r = 6);
}
#translate([25, 0, 0]) cube(8, center = true);
