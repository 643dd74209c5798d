// Differences within differences, eight levels.
$fn = 64;
difference() {
    cube(40, center = true);
    difference() {
        sphere(r = 24);
        union() {
            cube([12, 12, 60], center = true);
            intersection() {
                rotate([0, 90, 0]) cylinder(h = 60, r = 9, center = true);
                difference() {
                    cube([60, 14, 14], center = true);
                    union() {
                        rotate([0, 90, 0]) cylinder(h = 70, r = 4, center = true);
                        intersection() {
                            translate([15, 0, 5]) sphere(r = 6);
                            translate([15, 0, 5]) cube([20, 5, 9], center = true);
                        }
                    }
                }
            }
        }
    }
}
