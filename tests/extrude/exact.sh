#!/bin/sh
# SPDX-License-Identifier: MIT
#
#   exact.sh CACHE REFEREE SCENE.scad
#
# csgcast's exact surfaces against OpenSCAD's mesh with $fn = 720 in place of the scene's own: the
# largest radius, 15, times 1 - cos(pi / 720) is less than 2e-4.

set -eu
here=$(dirname "$0")
stl=$(node "$here/../openscad/mesh.mjs" "$1" "$3" '$fn=720')
"$2" --name=extrude-exact --facets=exact --sagitta=2e-4 --views=3 --imgsize=256,192 "$3" "$stl"
