#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   files.sh CSGCAST: scenes in, images out, and nothing left behind when something fails.

csgcast=$1
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$(readlink -f "$0")")/checks.sh"

small=("--imgsize=32,24")
echo 'difference() { cube(10, center = true); sphere(r = 6); }' >part.csg
echo 'difference() { cube(10' >broken.csg
printf 'cube(1);\nmagic(3);\n' >unknown.csg
printf 'size = 2;\ncube(size);\n' >model.scad
mkdir folder

# Where images go.
expect 0 "default output" render part.csg "${small[@]}"
is_silent
check "part.png is a PNG" is_png part.png
rm part.png
expect 0 "default output goes to the current directory" render ./folder/../part.csg "${small[@]}"
rm part.png
expect 0 "file name" render part.csg "${small[@]}" -o folder/x.png
check "folder/x.png is a PNG" is_png folder/x.png
expect 0 "float image" render part.csg "${small[@]}" -o folder/x.exr --aov=Z,N,id
expect 0 "16 bits" render part.csg "${small[@]}" -o folder/x.tif --bits=16
rm folder/x.*
expect 0 "format against extension" render part.csg "${small[@]}" -o folder/x --format png
check "folder/x is a PNG" is_png folder/x
rm folder/x

# Several scenes in one process, each as if it were the only one. One that fails stops no other.
echo 'sphere(r = 4);' >ball.csg
for name in part ball; do
    expect 0 "$name alone" render "$name.csg" "${small[@]}"
    mv "$name.png" "folder/$name.png"
done
expect 0 "two scenes" render part.csg ball.csg "${small[@]}"
is_silent
check "the first is drawn" cmp part.png folder/part.png
check "the second is drawn" cmp ball.png folder/ball.png
rm part.png ball.png
expect 1 "three scenes, one of which fails" render part.csg broken.csg ball.csg "${small[@]}"
says "broken.csg:1:14"
check "the one before is drawn" cmp part.png folder/part.png
check "the one after is drawn" cmp ball.png folder/ball.png
check "the broken one is not" test ! -e broken.png
rm part.png ball.png folder/*.png ball.csg

# A pixel of --antialias=2 is the mean of four of a picture of twice the size.
# pixels PPM: a line a channel of a pixel.
pixels()
{
    tail -c "$2" "$1" | od -An -v -tu1 -w1
}
expect 0 "twice the size" render part.csg --imgsize=64,48 --bits=8 -o large.ppm
expect 0 "smooth edges" render part.csg "${small[@]}" --antialias=2 --bits=8 -o smooth.ppm
pixels large.ppm $((64 * 48 * 3)) | awk '
    { i = NR - 1; x = int(i / 3) % 64; sum[int(int(x / 2)) + 32 * int(int(i / 192) / 2), i % 3] += $1 }
    END { for (p = 0; p < 32 * 24; p++) for (c = 0; c < 3; c++) print int((sum[p, c] + 2) / 4) }' >means
pixels smooth.ppm $((32 * 24 * 3)) | awk '{ print int($1) }' >smooth
check "they are means" cmp means smooth
expect 0 "one ray" render part.csg "${small[@]}" --antialias=1 -o one.ppm
expect 0 "no antialiasing" render part.csg "${small[@]}" -o none.ppm
check "it is the same" cmp one.ppm none.ppm
expect 0 "smooth floats" render part.csg "${small[@]}" --antialias=2 -o x.exr
expect 2 "smooth distances" render part.csg "${small[@]}" --antialias=2 --aov=Z -o y.exr
says "--antialias is for colours"
expect 1 "too many rays" render part.csg --imgsize=9000,2 --antialias=2 -o y.png
says "the largest --imgsize with it is 8192"
check "nothing is written" test ! -e y.png
rm ./*.ppm x.exr means smooth

# A PNG does without OpenImageIO, whose libraries take longer to load than the picture.
LD_DEBUG=files "$csgcast" render part.csg "${small[@]}" -o x.png 2>loaded
check "a PNG loads libpng" grep -q libpng loaded
check "a PNG loads no OpenImageIO" test "$(grep -c OpenImageIO loaded)" = 0
LD_DEBUG=files "$csgcast" render part.csg "${small[@]}" -o x.tif 2>loaded
check "a TIFF does" grep -q OpenImageIO loaded
rm x.png x.tif loaded

# What is no text. openscad says nothing of a zero and takes what is before it.
printf '\xff\xfec\0u\0b\0e\0(\0)\0;\0' >utf16.scad
printf 'c\0u\0b\0e\0(\0)\0;\0' >unmarked.scad
printf 'cube(1);\n\0\1' >zero.scad
{
    head -c 80 /dev/zero
    printf '\1\0\0\0'
    head -c 50 /dev/zero
} >mesh.scad
for name in utf16 unmarked zero mesh; do
    expect 1 "$name.scad" render "$name.scad" -o x.png
    says "$name.scad: no scene's text"
    expect 1 "$name.scad as .csg" render - -o x.png <"$name.scad"
    says "<stdin>: no scene's text"
done
expect 1 "UTF-16" info utf16.scad
says "byte 4 is zero; it seems to be text in UTF-16"
expect 1 "UTF-16 without a mark" info unmarked.scad
says "UTF-16"
expect 1 "a binary STL" info mesh.scad
says "STL"
expect 1 "something else" info zero.scad
says "byte 10 is zero; it seems to be binary data"
rm utf16.scad unmarked.scad zero.scad mesh.scad

# Streams.
"$csgcast" render - -o - "${small[@]}" <part.csg >piped.png 2>err
report $? "standard input to standard output"
is_silent
check "the output is a PNG" is_png piped.png
"$csgcast" render part.csg -o named.png "${small[@]}"
"$csgcast" render part.csg -o again.png "${small[@]}"
check "the same call gives the same bytes" cmp -s named.png again.png
rm ./*.png
expect 0 "statistics" render part.csg "${small[@]}" -o - --stats
says "texture bytes"
check "statistics stay out of the image" is_png out

# Scenes that need openscad. A .scad from a folder of its own, as editors start us.
expect 0 ".scad" render model.scad "${small[@]}" -D size=5 -o x.png
check "x.png is a PNG" is_png x.png
expect 1 "openscad is missing" render model.scad "${small[@]}" -o y.png --openscad=/nowhere/openscad
says "openscad"
OPENSCAD=/nowhere/else expect 1 "the same by the environment" render model.scad -o y.png
TMPDIR=/nowhere expect 1 "no temporary folder" render model.scad "${small[@]}" -o y.png
says "environment variable TMPDIR"
printf '#!/bin/sh\nexit 0\n' >idle
chmod +x idle
expect 1 "an openscad that does nothing" render model.scad "${small[@]}" -o y.png --openscad="$work/idle"
says "has written nothing"
rm idle
expect 1 "openscad fails" render model.scad "${small[@]}" -o y.png --openscad=/bin/false
rm x.png

# Failures: the right exit code, a message with the place, no file, no leftover.
before=(part.csg broken.csg unknown.csg model.scad folder)
expect 1 "no such scene" render nothing.csg -o x.png
says "nothing.csg"
expect 1 "the scene is a folder" render folder -o x.png
expect 1 "syntax error" render broken.csg -o x.png
says "broken.csg:"
expect 1 "unknown node" render unknown.csg -o x.png
says "unknown.csg:2:1"
holds_only "${before[@]}"
expect 2 "image over scene" render part.csg -o ./part.csg --format=png
expect 3 "no such folder" render part.csg "${small[@]}" -o nowhere/x.png
says "nowhere/x.png"
expect 3 "the image is a folder" render part.csg "${small[@]}" -o folder
expect 3 "unknown extension" render part.csg "${small[@]}" -o x.unknown
expect 3 "no extension" render part.csg "${small[@]}" -o x
expect 3 "depth in a PNG" render part.csg "${small[@]}" -o x.png --aov=Z
holds_only "${before[@]}"

# Export.
expect 0 "export" export part.csg
check "part.pov is a scene" grep -q '^difference {' part.pov
expect 0 "export to standard output" export part.csg -o -
prints "camera {"
expect 3 "export to an image" export part.csg -o x.png
says "must end with .pov"
expect 1 "export of nothing" export nothing.csg -o x.pov
expect 1 "export of a broken scene" export broken.csg -o part.pov
check "the older export is untouched" grep -q '^difference {' part.pov
expect 3 "export to nowhere" export part.csg -o nowhere/x.pov
expect 2 "export over the scene" export part.csg -o part.csg --format=pov
expect 2 "an option of render" export part.csg --aov=Z
rm part.pov
holds_only "${before[@]}"

# An older image survives a failure.
echo old >x.png
expect 1 "failure over an older image" render broken.csg -o x.png
check "the older image is untouched" grep -qx old x.png
rm x.png

if [[ -w /dev/full ]]; then
    timeout 60 "$csgcast" render part.csg "${small[@]}" -o - >/dev/full 2>err
    report $(($? != 3)) "standard output is full"
    timeout 60 "$csgcast" info part.csg --no-gl >/dev/full 2>err
    report $(($? != 3)) "standard output is full, info"
fi

# Streams that are closed are no files of something else.
timeout 60 "$csgcast" render part.csg "${small[@]}" -o - >&- 2>err
report $(($? != 3)) "standard output is closed"
says "Bad file descriptor"
timeout 60 "$csgcast" export part.csg -o - >&- 2>err
report $(($? != 3)) "standard output is closed, export"
timeout 60 "$csgcast" info part.csg --no-gl >&- 2>err
report $(($? != 3)) "standard output is closed, info"
timeout 60 "$csgcast" render - -o x.png <&- 2>err
report $(($? != 1)) "standard input is closed"
timeout 60 "$csgcast" render part.csg "${small[@]}" -o x.png >&- 2>&-
report $? "a file does without them"
check "x.png is a PNG" is_png x.png
rm x.png

# An empty scene is a picture of the background.
expect 0 "empty scene" render - -o empty.png "${small[@]}" </dev/null
says "nothing to draw"
check "empty.png is a PNG" is_png empty.png

# A large object is tiled by all cores: the same picture by one.
{
    echo 'difference() { cube([100, 100, 5]);'
    for ((i = 0; i < 81; i++)); do
        echo "translate([$((i % 9 * 10 + 10)), $((i / 9 * 10 + 10)), -1]) cylinder(h = 7, r = 3);"
    done
    echo '}'
} >plate.csg
expect 0 "all cores" render plate.csg -o all.png --imgsize=256,256
taskset -c 0 "$csgcast" render plate.csg -o one.png --imgsize=256,256 >out 2>err
report $? "one core"
check "both pictures are equal" cmp all.png one.png

# Nodes with the same text are read once or twice and copied; with other digits each by itself.
row()
{
    local i
    echo "difference() { cube([100, 20, 5]);"
    for i in 1 2 3 4 5; do
        echo "multmatrix([[1, 0, 0, $((15 * i))], [0, 1, 0.$i, 10], [0, 0, 1.$i, 2], [0, 0, 0, 1]])"
        echo "  hull() { sphere(r = 4$1, \$fn = 20); minkowski() { cube(5$1); sphere(1, \$fn = 8); }"
        echo "    %cylinder(h = 9, r = 9); }"
        [[ $2 = same ]] || set -- "${1}0" other
    done
    echo "}"
}
expect 0 "equal nodes" render - -o same.png --imgsize=256,256 < <(row .0 same)
expect 0 "nodes with other digits" render - -o other.png --imgsize=256,256 < <(row .0 other)
check "both pictures are equal" cmp same.png other.png
check "and show something" test "$(wc -c <same.png)" -gt 3000

finish
