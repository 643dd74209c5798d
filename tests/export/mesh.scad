// A mesh is exported as a mesh; the Boolean around it stays.
difference() {
    import("tetrahedron.stl");
    translate([6, 6, 6]) sphere(6, $fn = 64);
}
