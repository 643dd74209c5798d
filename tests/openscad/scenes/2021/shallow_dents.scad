// Of a solid whose dents are bent by less than 0.1 degrees, where it is put, OpenSCAD takes the hull
// where it meets others, and its faces where it stands alone. One that is inside out keeps its dents.

module dented(depth)
    polyhedron([[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0],
                [-9, -9, 5], [9, -9, 5], [9, 9, 5], [-9, 9, 5], [0, 0, 5 - depth]],
               [[0, 1, 2, 3], [5, 4, 8], [6, 5, 8], [7, 6, 8], [4, 7, 8],
                [1, 0, 4, 5], [2, 1, 5, 6], [3, 2, 6, 7], [0, 3, 7, 4]]);

difference() { dented(0.01); translate([3, -9, -1]) cube([2, 12, 9]); }
translate([20, 0, 0]) intersection() { dented(0.02); translate([0, 0, 4]) cube([30, 30, 9], center = true); }
translate([40, 0, 0]) minkowski() { dented(0.01); cube(1); }
translate([0, 20, 0]) scale([1, 1, 0.01]) difference() { scale([1, 1, 100]) dented(0.01); sphere(2, $fn = 6); }
translate([20, 20, 0]) scale([1, 1, 100]) difference() { scale([1, 1, 0.01]) dented(0.3); sphere(0.02, $fn = 6); }

module inside_out(depth)
    polyhedron([[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0],
                [-9, -9, 5], [9, -9, 5], [9, 9, 5], [-9, 9, 5], [0, 0, 5 - depth]],
               [[3, 2, 1, 0], [8, 4, 5], [8, 5, 6], [8, 6, 7], [8, 7, 4],
                [5, 4, 0, 1], [6, 5, 1, 2], [7, 6, 2, 3], [4, 7, 3, 0]]);

translate([0, 40, 0]) difference() { inside_out(0.01); translate([3, -9, -1]) cube([2, 12, 9]); }
translate([20, 40, 0]) mirror([0, 0, 1]) intersection() { mirror([1, 0, 0]) inside_out(0.01); cube(30, center = true); }

// An operand of minkowski is its hull where the planes that fit its faces best are a convex solid's.
module bent(h)
    polyhedron([[0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 9, 0], [0, 0, 5 - h], [9, 0, 5 + h], [9, 9, 5 - h], [0, 9, 5 + h]],
               [[0, 1, 2, 3], [7, 6, 5, 4], [1, 0, 4, 5], [2, 1, 5, 6], [3, 2, 6, 7], [0, 3, 7, 4]]);

translate([40, 40, 0]) minkowski() { bent(0.5); cube(1); }
translate([55, 40, 0]) minkowski() { mirror([0, 0, 1]) render() bent(0.5); sphere(1, $fn = 6); }
translate([70, 40, 0]) minkowski() { union() { bent(0.5); cube(1); } cube(1); }
translate([70, 20, 0]) difference() { bent(0.5); cube(1); }

translate([40, 20, 0]) rotate([90, 0, 0]) linear_extrude(1) projection(cut = true) rotate([90, 0, 0]) dented(0.01);

// So of a turn whose profile reaches out from the axis: a waist of many shallow bends is lost.
module turned(angle = 360, bend = 0.08)
    rotate_extrude(angle = angle, $fn = 8)
        polygon([[0, -3], for (i = [-15:15]) [9 + i * i / 4 * bend * PI / 180, 5 + i / 2], [0, 14]]);

translate([90, 0, 0]) difference() { turned(); cube([12, 12, 4]); }
translate([90, 25, 0]) intersection() { turned(130); translate([-15, 0, 2]) cube(30); }
translate([90, 50, 0]) difference() { turned(bend = 0.2); cube([12, 12, 4]); }
translate([115, 0, 0]) turned();
translate([115, 25, 0]) minkowski() { mirror([1, 0, 0]) turned(-90); cube(1); }
translate([115, 50, 0]) difference() { turned(270); cube([12, 12, 4]); }
