// $fn = 0: the number of facets follows the radius through $fa and $fs.
sphere(r = 12);
translate([30, 0, 0]) cylinder(h = 20, r1 = 10, r2 = 6, center = true);
translate([0, 30, 0]) difference() {
    cube(18, center = true);
    cylinder(h = 30, r = 6.5, center = true);
}
