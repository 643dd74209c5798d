// The cube of 20 with a sphere of 13 and three cylinders of 6 taken away.
difference() {
    cube(20, center = true);
    sphere(13, $fn = fn);
    cylinder(h = 30, r = 6, center = true, $fn = fn);
    rotate([90, 0, 0]) cylinder(h = 30, r = 6, center = true, $fn = fn);
    rotate([0, 90, 0]) cylinder(h = 30, r = 6, center = true, $fn = fn);
}

fn = 64; // facets, where facets are drawn
