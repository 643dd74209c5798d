#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   compare.sh CSGCAST: the exact surface against meshes, thresholds, exit codes, pictures.

csgcast=$1
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$(readlink -f "$0")")/checks.sh"

# stl SIZE: a cube from the origin as ASCII STL.
stl()
{
    awk -v s="$1" '
        function corner(i) { return (i % 2) * s " " (int(i / 2) % 2) * s " " int(i / 4) * s }
        function facet(a, b, c) {
            print "facet normal 0 0 0\nouter loop"
            print "vertex " corner(a) "\nvertex " corner(b) "\nvertex " corner(c)
            print "endloop\nendfacet"
        }
        function side(a, b, c, d) { facet(a, b, c); facet(a, c, d) }
        BEGIN {
            print "solid cube"
            side(0, 2, 3, 1); side(4, 5, 7, 6); side(0, 1, 5, 4)
            side(2, 6, 7, 3); side(0, 4, 6, 2); side(1, 3, 7, 5)
            print "endsolid cube"
        }'
}

small=("--imgsize=64,48")
echo 'cube(10);' >cube.csg
echo 'sphere(r = 10, $fn = 24);' >ball.scad
echo 'ellipsoid(r = [3, 2, 1]);' >ellipsoid.csg
echo 'hull() { sphere(4, $fn = 24); translate([10, 0, 0]) sphere(2, $fn = 24); }' >hull.scad
stl 10 >cube.stl
stl 10.1 >larger.stl
head -n 20 cube.stl >half.stl
printf 'v 0 0 0\nv 10 0 0\nv 0 10 0\nv 10 10 0\nv 0 0 10\nv 10 0 10\nv 0 10 10\nv 10 10 10\n%s\n' \
    'f 1 3 4 2
f 5 6 8 7
f 1 2 6 5
f 3 7 8 4
f 1 5 7 3
f 2 4 8 6' >cube.obj

# The same solid, whatever the format.
for mesh in cube.stl cube.obj; do
    expect 0 "$mesh" compare cube.csg --mesh=$mesh "${small[@]}" --no-picture
    prints "IoU 1.000000"
    prints "within --max-wrong"
    is_silent
done

# One per cent larger: wrong, unless that is allowed.
expect 1 "larger" compare cube.csg --mesh=larger.stl "${small[@]}" --no-picture
prints "BEYOND --max-wrong"
expect 0 "larger, allowed" compare cube.csg --mesh=larger.stl "${small[@]}" --no-picture \
    --max-wrong=1 --min-iou=0.9 --max-depth-error=1 --max-normal-p99=1
expect 0 "larger, within the sagitta" compare cube.csg --mesh=larger.stl "${small[@]}" \
    --no-picture --sagitta=0.11
expect 1 "beyond a depth" compare cube.csg --mesh=larger.stl "${small[@]}" --no-picture \
    --max-wrong=1 --max-depth-p99=0.001
prints "BEYOND --max-depth-p99"
expect 1 "beyond an IoU" compare cube.csg --mesh=larger.stl "${small[@]}" --no-picture \
    --max-wrong=1 --min-iou=1
holds_only cube.csg ball.scad hull.scad ellipsoid.csg cube.stl larger.stl half.stl cube.obj

# What openscad makes, and its facets.
expect 0 "openscad's mesh" compare ball.scad "${small[@]}"
prints "at most 0.171 scene units"
check "ball.compare.png is a PNG" is_png ball.compare.png
rm ball.compare.png
expect 1 "facets are far off an exact ball" compare ball.scad "${small[@]}" --no-picture \
    --max-depth-p99=0.001
expect 0 "but not off themselves" compare ball.scad "${small[@]}" --no-picture \
    --facets=as-written --max-depth-p99=0.001 --min-iou=1
expect 0 "exact and facetted scenes with other bounds" compare hull.scad "${small[@]}" --no-picture
prints "wrong           0 pixels, 0 of the mesh's"
expect 2 "openscad lacks the node" compare ellipsoid.csg "${small[@]}"
says "--mesh=FILE"
expect 2 "no time for openscad" compare ball.scad "${small[@]}" --limit=0.001
says "--limit"
expect 2 "openscad is missing" compare ball.scad --openscad=/nowhere/openscad
says "openscad"

# JSON and pictures.
expect 0 "JSON" compare cube.csg --mesh=cube.stl "${small[@]}" --json -o all.png \
    --side-by-side=both.png --difference=difference.png
for image in all both difference; do
    check "$image.png is a PNG" is_png $image.png
    rm $image.png
done
if command -v node >/dev/null; then
    node -e '
        const report = JSON.parse(require("fs").readFileSync("out", "utf8"));
        const view = report.views[0];
        process.exit(report.verdict === "within" && report.views.length === 4 && report.iou === 1 &&
                     report.triangles === 12 && view.depth.max < 1e-3 && view.wrong === 0 &&
                     view.camera.eye.length === 3 ? 0 : 1);'
    report $? "the JSON says what was compared"
fi
expect 0 "one view" compare cube.csg --mesh=cube.stl "${small[@]}" --no-picture \
    --camera=0,0,0,55,0,25,80
[[ $(grep -c 'silhouette' out) -eq 2 ]]
report $? "prints one view and the sum"
"$csgcast" compare - --mesh=cube.stl "${small[@]}" --no-picture <cube.csg >out 2>err
report $? "standard input"

# Failures are 2, whatever fails: 1 means beyond.
expect 2 "no such scene" compare nothing.csg --mesh=cube.stl
expect 2 "no such mesh" compare cube.csg --mesh=nothing.stl
says "nothing.stl"
expect 2 "half a mesh" compare cube.csg --mesh=half.stl
says "half.stl"
expect 2 "the scene is no mesh" compare cube.csg --mesh=ball.scad
expect 2 "no folder for the picture" compare cube.csg --mesh=cube.stl "${small[@]}" -o nowhere/x.png
expect 2 "standard input without a mesh" compare -
CSGCAST_COMPARE_MODULE=/nowhere/module.so expect 2 "no module" compare cube.csg --mesh=cube.stl
says "libassimp5"
for option in --min-iou=2 --min-iou=x --max-wrong=-1 --sagitta=-1 --sagitta=nan --max-depth-error= \
    --max-normal-p99=200; do
    expect 2 "$option" compare cube.csg --mesh=cube.stl $option
done
holds_only cube.csg ball.scad hull.scad ellipsoid.csg cube.stl larger.stl half.stl cube.obj

finish
