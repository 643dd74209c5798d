// Flush cuts whose six-digit matrices in the .csg no longer are.
$fn = 32;
rotate([17, 23, 31]) difference() {
    cube([30, 20, 12]);
    translate([6, 0, 6]) cube([8, 20, 6]);
    rotate([0, 0, 0]) translate([22, 10, 0]) cylinder(h = 12, r = 5);
}
translate([0, 40, 0]) difference() {
    rotate([17, 23, 31]) cube([30, 20, 12]);
    rotate([17, 23, 31]) translate([6, 0, 6]) cube([8, 20, 6]);
    rotate([17, 23, 31]) translate([20, 6, 4]) cube([10, 14, 8]);
}
