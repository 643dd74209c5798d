# SPDX-License-Identifier: MIT
#
#   pymol -cqk pymol_peer.py -- LIST ex,ey,ez,cx,cy,cz W,H OUT.png
#
# crowd.awk's lists by PyMOL's ray tracer, without shadows; prints "ray ms TIME" and "work
# ms TIME", processor time of all cores.

import math
import sys
import time

from pymol import cgo, cmd

path, camera, size, out = sys.argv[-4:]
numbers = [float(x) for x in camera.split(",")]
eye, center = numbers[:3], numbers[3:]
width, height = (int(x) for x in size.split(","))

scene = [cgo.COLOR, 0.976, 0.843, 0.173]
color = [0.976, 0.843, 0.173]
with open(path, encoding="ascii") as lines:
    for line in lines:
        kind, *values = line.split()
        values = [float(x) for x in values]
        if kind == "sphere":
            scene += [cgo.SPHERE] + values
        else:
            scene += [cgo.CYLINDER] + values + color + color
cmd.load_cgo(scene, "scene")

back = [e - c for e, c in zip(eye, center)]
distance = math.sqrt(sum(x * x for x in back))
back = [x / distance for x in back]
across = math.hypot(back[0], back[1])
right = [-back[1] / across, back[0] / across, 0]
up = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2],
      back[0] * right[1] - back[1] * right[0]]
rotation = [v[i] for i in range(3) for v in (right, up, back)]
cmd.set("field_of_view", 22.5)
cmd.set_view(rotation + [0, 0, -distance] + center + [0.3 * distance, 3 * distance, -22.5])
for name in ("ray_shadows", "antialias", "specular", "ray_opaque_background", "depth_cue"):
    cmd.set(name, name == "ray_opaque_background")
cmd.bg_color("white")
begun, worked = time.monotonic(), time.process_time()
cmd.ray(width, height)
print("ray ms", 1e3 * (time.monotonic() - begun))
print("work ms", 1e3 * (time.process_time() - worked))
cmd.png(out)
