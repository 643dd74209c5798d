// ! shows its subtree alone, without the maps around it.
$fn = 48;
translate([100, 0, 0]) rotate([30, 0, 0]) {
    sphere(r = 40);
    !difference() {
        cube([20, 12, 8]);
        translate([5, 6, 0]) cylinder(h = 8, r = 3);
    }
}
