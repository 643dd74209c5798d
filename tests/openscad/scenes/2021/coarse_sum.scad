// Six digits bend the faces of a mesh apart: nothing may stick out of its sums.
minkowski() { import("coarse_mesh.off"); cube(0.5); }
translate([12, 0, 0]) minkowski() { difference() { import("coarse_mesh.off"); cube(1.5); } cube(0.4); }
