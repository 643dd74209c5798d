#!/bin/sh
# SPDX-License-Identifier: MIT
#
#   exact.sh CACHE REFEREE SCENE.scad FN SAGITTA [MESH.scad]
#
# csgcast's exact surfaces against OpenSCAD's mesh with $fn = FN in place of the scene's own (with
# many an FN that is no multiple of 8 OpenSCAD 2025 loses hulls of spheres). SAGITTA: the largest
# radius times 1 - cos(pi / FN), and some more where circles meet. MESH.scad: the same solids, in
# nodes that take OpenSCAD less time.

set -eu
here=$(dirname "$0")
stl=$(node "$here/../openscad/mesh.mjs" "$1" "${6-$3}" "\$fn=$4")
"$2" --name="$(basename "$3" .scad)-exact" --facets=exact --sagitta="$5" --views=3 \
    --imgsize=256,192 "$3" "$stl"
