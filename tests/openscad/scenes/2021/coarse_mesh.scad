// Six digits bend the faces of a mesh apart: nothing may stick out where they meet.
difference() { import("coarse_mesh.off"); cube(0.5); }
