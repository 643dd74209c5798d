// Of what becomes several solids here, the far side shows through the near one.
%rotate_extrude($fn = 24) translate([8, 0]) circle(3, $fn = 12);
translate([20, 0, 0]) color("red", 0.4) linear_extrude(8, scale = [1, 0.5]) circle(6, $fn = 40);
translate([0, -20, 0]) %render() intersection() {
    cube(12, center = true);
    sphere(7, $fn = 12);
}
translate([-18, -14, 0]) #rotate_extrude($fn = 16) polygon([[0, 0], [5, 2], [6, 6], [4, 8], [0, 9]]);
cube(2);
