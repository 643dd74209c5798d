// A welding-neck flange with a raised face, a ring groove, eight bolt holes and two hex bolts.
$fn = 120;

outer = 90;
bore = 32;
circle_d = 68;

module bolt() {
    cylinder(d = 14, h = 6, $fn = 6);
    intersection() {                       // the head's rounded corners
        translate([0, 0, 6]) cylinder(d = 14, h = 2, $fn = 6);
        translate([0, 0, -3]) sphere(r = 11.2);
    }
    translate([0, 0, -22]) cylinder(d = 8, h = 22);
}

module flange() difference() {
    union() {
        cylinder(d = outer, h = 12);
        translate([0, 0, -2]) cylinder(d = 50, h = 2);          // raised face
        translate([0, 0, 12]) cylinder(d1 = 56, d2 = 42, h = 18); // neck
        translate([0, 0, 30]) cylinder(d = 42, h = 8);
    }
    translate([0, 0, -2]) cylinder(d = bore, h = 40);
    translate([0, 0, 36]) cylinder(d1 = bore, d2 = 40, h = 2);  // weld bevel
    translate([0, 0, -2]) difference() {                        // ring groove
        cylinder(d = 44, h = 1);
        cylinder(d = 40, h = 1);
    }
    for (i = [0 : 7]) rotate(45 * i + 22.5) translate([circle_d / 2, 0, 0]) cylinder(d = 9, h = 12);
    rotate(-90) translate([0, 0, -2]) cube([50, 50, 40]);       // show the section
}

color("lightsteelblue") flange();
for (i = [2, 5]) color("dimgray") rotate(45 * i + 22.5) translate([circle_d / 2, 0, 12]) bolt();
