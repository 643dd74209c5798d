// Corner cases, each as 2021.01 has it.

// A negative newsize mirrors a Boolean, and nothing else.
resize([-6, 0, 9], auto = [false, true, false]) difference() { cube([2, 3, 4]); cube([1, 1, 9]); }
translate([0, 8, 0]) resize([-6, 0, 9]) cube([2, 3, 4]);

// One segment for more than half a turn: the prism between its ends.
translate([16, 0, 0]) rotate_extrude(angle = 200, $fn = 2) translate([2, 0]) square([3, 2]);

// What is subtracted takes its boundary with it: the pocket's floor is not in the section.
translate([0, -9, 0]) linear_extrude(2) projection(cut = true) difference() {
    translate([0, 0, -2]) cube(4);
    translate([1, 1, 0]) cube(1);
    translate([2.5, 2.5, -1]) cube(1);
}

// A point without z, a path that is none.
translate([8, -9, 0]) polyhedron([[0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]],
    [[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]]);
translate([16, -9, 0]) linear_extrude(2) polygon([[0, 0], [4, 0], [0, 4]], [0, 1, 2]);
translate([16, -9, 0]) cube(1);

// Only circles, spheres and cylinders have a least $fa.
translate([30, -9, 0]) rotate_extrude($fa = -1, $fs = 2) translate([4, 0]) square([3, 2]);

// A solid in a drawing is the empty set.
translate([40, -9, 0]) linear_extrude(2) {
    square(2);
    intersection() { square(4); cube(2); }
    difference() { translate([3, 0]) square(2); cube(9); }
}
