// Arcs of offset with parts of steps: OpenSCAD 2021.01 joins the part to the last step, or not,
// where 2025 adds a step.
linear_extrude(4) offset(r=3, $fn=30) square([20, 10]);
translate([40, 0, 0]) linear_extrude(4) offset(r=3, $fn=7) polygon([[0, 0], [20, 3], [8, 15]]);
translate([0, 40, 0]) linear_extrude(4) offset(r=-2, $fn=22) difference() {
    square([30, 20]);
    translate([10, 5]) square([5, 8]);
}
translate([40, 40, 0]) linear_extrude(4) offset(r=5) rotate(17) square([9, 3]);
translate([-40, 0, 0]) linear_extrude(4) offset(r=1.5, $fn=50) circle(8, $fn=5);
