// What viewall looks at: positive solids, not what is subtracted, and no product that is empty.
difference() {
    cube([20, 16, 12]);
    translate([4, 4, -40]) cube([6, 6, 90]);
}
intersection() {
    translate([30, 0, 0]) cube([10, 10, 20]);
    translate([28, -3, 5]) cube([9, 30, 6]);
}
intersection() {
    translate([200, 0, 0]) cube(10);
    translate([-200, 0, 0]) cube(10);
}
rotate([0, 30, 10]) translate([-20, 0, 0]) sphere(r = 6, $fn = 24);
