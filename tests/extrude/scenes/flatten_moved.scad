// What makes a new drawing of the one in it does so before the nodes around it move that.
$fn = 16;
linear_extrude(3) rotate(30) resize([20, 5]) square(3);
translate([30, 0]) linear_extrude(3) scale([2, 1]) offset(r = 1) square(3);
translate([0, 30]) linear_extrude(3) translate([4, 2]) minkowski() { square(8); circle(1); }
translate([30, 30]) linear_extrude(3) difference() {
    square(20, center = true);
    mirror([1, 0]) translate([3, 1]) rotate(20) minkowski() { square([5, 2]); polygon([[0, 0], [2, 0], [0, 1]]); }
    translate([-5, -5]) scale([1, 0.5]) offset(delta = 1) translate([1, 1]) resize([0, 6]) circle(2);
}
translate([0, -30]) rotate_extrude() translate([8, 0]) scale([0.5, 2]) offset(delta = 0.5, chamfer = true) square(2);
