// A hydraulic manifold: crossing bores, ports with countersinks, chamfered edges, bolt holes.
$fn = 64;

size = [90, 50, 40];
gallery = 14;
port = 10;
thread = 16;
chamfer = 2;

module port_at(where, turn) {
    translate(where) rotate(turn) {
        cylinder(d = port, h = 30);
        cylinder(d = thread, h = 12);
        cylinder(d1 = thread + 4, d2 = thread, h = 2);   // flush with the face
        translate([0, 0, 12]) cylinder(d1 = thread, d2 = port, h = 3);
    }
}

// Takes the edge of length l along x off, at the origin.
module edge(l) rotate([45, 0, 0])
    translate([0, -chamfer / sqrt(2), -chamfer / sqrt(2)])
        cube([l, chamfer * sqrt(2), chamfer * sqrt(2)]);

module block() difference() {
    cube(size);
    for (y = [0, size[1]], z = [0, size[2]]) translate([0, y, z]) edge(size[0]);
    for (x = [0, size[0]], z = [0, size[2]])
        translate([x, 0, z]) rotate([0, 0, 90]) edge(size[1]);
}

module along_gallery() translate([0, size[1] / 2, size[2] / 2]) rotate([0, 90, 0]) children();

color("silver") difference() {
    block();
    // the gallery goes right through and is plugged at one end
    along_gallery() cylinder(d = gallery, h = size[0]);
    for (x = [20, 45, 70]) port_at([x, size[1] / 2, size[2]], [180, 0, 0]);
    for (x = [32, 58]) port_at([x, 0, size[2] / 2], [-90, 0, 0]);
    for (x = [10, size[0] - 10], y = [9, size[1] - 9])
        translate([x, y, 0]) {
            cylinder(d = 6.5, h = size[2]);
            translate([0, 0, size[2] - 6]) cylinder(d = 11, h = 6);
        }
}
// A hex socket plug closes the gallery.
color("goldenrod") difference() {
    along_gallery() cylinder(d = gallery, h = 8);
    along_gallery() cylinder(d = 8, h = 5, $fn = 6);
}
