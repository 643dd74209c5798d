// What sum.scad is, without minkowski, which takes OpenSCAD minutes.
$fn = 24;
module rounded(lo, hi, r)
    hull() for (x = [lo[0], hi[0]], y = [lo[1], hi[1]], z = [lo[2], hi[2]])
        translate([x, y, z]) sphere(r);
translate([1, 2, 3]) rotate(30) hull()
    for (x = [0, 15], y = [0, 10], z = [0, 5]) translate([x, y, z]) sphere(2);
translate([30, 0, 0]) {
    rounded([0, 0, 0], [4, 12, 12], 1);
    rounded([8, 0, 0], [12, 12, 12], 1);
    rounded([0, 6, 0], [12, 12, 12], 1);
}
translate([3, 30, 0]) sphere(3);
