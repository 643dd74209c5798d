// Meshes in files with other solids; several objects in a file are united.
difference() {
    import("objects.amf");
    translate([5, 5, -1]) cylinder(h = 30, r = 2, $fn = 12);
}
translate([40, 0, 0]) intersection() {
    import("objects.3mf");
    translate([0, 0, 2]) cube([22, 20, 9]);
}
translate([0, 40, 0]) import("archived.amf");
