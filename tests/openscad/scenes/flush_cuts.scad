// The cutters end exactly in the faces of what they cut.
$fn = 48;
difference() {
    cube([40, 30, 10]);
    translate([5, 5, 5]) cube([10, 20, 5]);          // open at the top
    translate([25, 10, 0]) cylinder(h = 10, r = 4);  // through, flush at both ends
    translate([0, 12, 2]) cube([5, 6, 4]);           // into the pocket, from the face
    translate([34, 0, 0]) cube([6, 8, 10]);          // a corner, three faces flush
    translate([32, 20, 6]) cylinder(h = 4, r1 = 2, r2 = 5);
}
