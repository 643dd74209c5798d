// A pillow block: base plate with slots, a split bearing seat, ribs and an oil hole.
// Cuts end flush with the faces they cut, as people write them.
$fn = 96;

base = [128, 40, 12];
axis = 45;         // height of the bore's axis
bore = 30;
seat = [38, 8];    // counterbore for the bearing: diameter, depth
housing = 56;      // outer diameter
slot = [9, 14];    // width, length between centres

module slot_hole(at) {
    translate(at) {
        for (x = [-slot[1] / 2, slot[1] / 2])
            translate([x, 0, 0]) cylinder(d = slot[0], h = base[2]);
        translate([-slot[1] / 2, -slot[0] / 2, 0]) cube([slot[1], slot[0], base[2]]);
    }
}

module lying(d, h) rotate([90, 0, 0]) cylinder(d = d, h = h, center = true);

module body() {
    translate([-base[0] / 2, -base[1] / 2, 0]) cube(base);
    translate([0, 0, axis]) lying(housing, base[1] - 6);
    translate([-housing / 2, -(base[1] - 6) / 2, base[2]])
        cube([housing, base[1] - 6, axis - base[2]]);
    // oil cup
    translate([0, 0, axis + housing / 2 - 3]) cylinder(d = 12, h = 9);
}

module rib() translate([housing / 2, -4, base[2]]) difference() {
    cube([12, 8, 24]);
    translate([12, 0, 0]) rotate([0, -26.565, 0]) cube([30, 8, 30]);
}

color("steelblue") difference() {
    union() {
        body();
        rib();
        mirror([1, 0, 0]) rib();
    }
    translate([0, 0, axis]) lying(bore, base[1] - 6);
    for (side = [-1, 1])
        translate([0, side * ((base[1] - 6) / 2 - seat[1] / 2), axis]) lying(seat[0], seat[1]);
    slot_hole([-50, 0, 0]);
    slot_hole([50, 0, 0]);
    // oil hole with a countersink, flush with the cup's rim
    translate([0, 0, axis]) cylinder(d = 4, h = housing / 2 + 6);
    translate([0, 0, axis + housing / 2 + 3]) cylinder(d1 = 4, d2 = 10, h = 3);
    // a shallow relief under the base
    translate([-20, -base[1] / 2, 0]) cube([40, base[1], 2]);
}
