#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   info.sh CSGCAST: the report about a scene, for people and for machines.

csgcast=$1
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$(readlink -f "$0")")/checks.sh"

echo 'difference() { cube(10); sphere(r = 6); sphere(r = 2); }' \
    >'a "quoted" name.csg'
echo 'difference() { cube(10); sphere(r = 6); sphere(r = 2); }' >part.csg

expect 0 "for people" info part.csg
prints "sphere 2"
prints "leaves             3"
prints "sagitta            0.396"
prints "variants"
prints "texture bytes"
expect 0 "without a frame" info part.csg --no-gl
prints "crossings at most"
check "no renderer is named" bash -c '! grep -q renderer out'
expect 0 "without OpenGL" info part.csg --backend=reference

expect 0 "for machines" info part.csg --json
if command -v node >/dev/null; then
    node -e '
        const report = JSON.parse(require("fs").readFileSync("out", "utf8"));
        process.exit(report.kinds.sphere === 2 && report.leaves === 3 && report.hi[0] === 10 &&
                     report.texture_bytes > 0 && report.scene === "part.csg" ? 0 : 1);'
    report $? "the JSON says what the scene holds"
    "$csgcast" info 'a "quoted" name.csg' --json --no-gl >out 2>err
    node -e 'JSON.parse(require("fs").readFileSync("out", "utf8"))'
    report $? "strings are escaped"
fi

# By itself a ring of flat segments is one surface.
echo 'resize([10, 0, 5]) rotate_extrude($fn = 12) translate([5, 0]) circle(2, $fn = 9);' >ring.csg
expect 0 "what is resized" info ring.csg --facets=as-written --no-gl
check "one leaf" grep -qx "leaves *1" out

expect 0 "what a frame costs" info part.csg --stats --variant=straight
prints "draw ms"
prints "tests a pixel      3.000"
prints "tiles, mixed       0"
# A disc in its square: 21.5 % (Toledo and Levy 2004, table 1), less where perspective stretches it.
echo "sphere(10);" >ball.csg
expect 0 "waste" info ball.csg --stats
prints "waste              21."
prints "  sphere           21."
cat >kinds.csg <<EOF
sphere(5); translate([20, 0, 0]) cube(8); translate([40, 0, 0]) cylinder(h = 9, r = 3);
translate([60, 0, 0]) difference() { cube(8); sphere(3); }
EOF
expect 0 "waste by kind" info kinds.csg --stats
for kind in sphere cube cylinder; do
    grep -q "^  $kind  .* % of [1-9][0-9]*, 1 drawn by themselves" out
    report $? "waste of each $kind"
done
expect 0 "one thread" render kinds.csg --threads=1 --imgsize=99,99 -o one.png
expect 0 "three threads" render kinds.csg --threads=3 --imgsize=99,99 -o three.png
cmp -s one.png three.png
report $? "the picture does not depend on the threads"
expect 2 "threads" render kinds.csg --threads=many -o one.png
says "0 to 64"
expect 0 "what is not counted" render ball.csg --stats -o ball.png
says "hit pixels         not counted"
if command -v node >/dev/null; then
    "$csgcast" info part.csg --stats --variant=straight --json >out 2>err
    node -e '
        const report = JSON.parse(require("fs").readFileSync("out", "utf8"));
        process.exit(report.tests_per_pixel === 3 && report.hit_pixels > 1000 && report.draw_ms > 0 &&
                     report.overflowed_objects === 0 && Array.isArray(report.waste_by_kind) ? 0 : 1);'
    report $? "the cost as JSON"
fi

expect 1 "no such scene" info nothing.csg
expect 2 "render's options are not info's" info part.csg -o x.png
says "has no option"
expect 2 "no scene" info
"$csgcast" info - --no-gl <part.csg >out 2>err
report $? "standard input"
prints "cube 1"

# Bench.
small=(--imgsize=32,24 --frames=2)
expect 0 "bench" bench part.csg part.csg "${small[@]}"
check "one line a scene" test "$(grep -c '^part.csg ' out)" -eq 2
expect 0 "bench for machines" bench part.csg "${small[@]}" --orbit --edit=0 --json
check "a list of objects" grep -q '^\[' out
for key in first_image_ms first_stages_ms frame_ms median cpu_ms stages_ms programs compile_ms \
    bytes_uploaded peak_rss; do
    prints "\"$key\":"
done
prints '"programs_after_first": 0'
expect 1 "bench of nothing" bench nothing.csg part.csg "${small[@]}"
check "the others are measured" grep -q '^part.csg ' out
expect 1 "bench of nothing, for machines" bench part.csg nothing.csg "${small[@]}" --edit --json
check "an object a file, and stages that are parts of their frame" node -e '
    const [part, nothing] = JSON.parse(require("fs").readFileSync("out", "utf8"));
    const sum = stages => Object.values(stages).reduce((a, b) => a + b, 0);
    const { csg, ...stages } = part.stages_ms;
    process.exit(nothing.failed && nothing.scene === "nothing.csg" && !part.failed &&
        part.edit_ms >= csg && csg > 0 && stages.draw > 0 &&
        part.edit_ms + sum(stages) < 1.01 * part.frame_ms.max &&
        sum(part.first_stages_ms) < part.first_image_ms ? 0 : 1);'
expect 0 "bench of more rays" bench part.csg --imgsize=32,24 --frames=2 --antialias=4 --json
check "pixels are those asked for" grep -q '"width": 32' out
prints '"height": 24'
expect 1 "bench of too many rays" bench part.csg --imgsize=9000,2 --antialias=2
says "the largest --imgsize with it is 8192"
expect 0 "bench of channels" bench part.csg "${small[@]}" --aov=Z,N,id --bits=16
expect 2 "bench of channels and more rays" bench part.csg "${small[@]}" --aov=Z --antialias=2
says "--antialias is for colours"
expect 0 "bench of parameters" bench part.csg "${small[@]}" --edit=0 --edit-what=parameters
expect 0 "bench of colours" bench part.csg "${small[@]}" --edit-what=color
expect 2 "bench of nothing that changes" bench part.csg "${small[@]}" --edit-what=size
expect 1 "no such leaf" bench part.csg "${small[@]}" --edit=7
expect 2 "no frames" bench part.csg --frames=0
expect 2 "bench of no scene" bench

# GLU's sweep does not return from coordinates that are no numbers.
for number in nan inf 1e300; do
    cat >bent.csg <<END
multmatrix([[1, $number, 0, 0], [0, 1, $number, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {
	polyhedron(points = [[0, 0, 0], [9, 0, 0], [9, 9, 1], [0, 9, 0], [5, 12, 0], [4, 4, 9]],
		faces = [[4, 3, 2, 1, 0], [0, 1, 5], [1, 2, 5], [2, 3, 5], [3, 4, 5], [4, 0, 5]]);
}
END
    expect 0 "a bent face under a matrix of $number" info bent.csg --no-gl
    check "messages have a place" bash -c '! grep -q "(null)" err'
done

finish
