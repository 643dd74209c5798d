// A small part far from the origin.
$fn = 64;
translate([5000, -3000, 1000]) difference() {
    cube([20, 20, 20], center = true);
    sphere(r = 11.5);
    translate([0, 0, 10]) cylinder(h = 6, r = 4, center = true);
}
