#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# scad.sh CSGCAST: what a .scad file and openscad's options for it say besides geometry: the
# viewpoint ($vpr and its like), parameter sets, fonts, animations.

csgcast=$(readlink -f "$1")
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$0")/checks.sh"
unset OPENSCAD
small=(--imgsize=48,32)

# picture NAME ARGS...: the scene's pixels alone in NAME.ppm.
picture()
{
    local name=$1
    shift
    expect 0 "$name" render "$@" "${small[@]}" -o "$name.ppm"
}

same()
{
    check "$1 and $2 are the same" cmp -s "$1.ppm" "$2.ppm"
}

different()
{
    check "$1 and $2 differ" test -n "$(cmp "$1.ppm" "$2.ppm" 2>&1)"
}

# viewed NAME ASSIGNMENTS CAMERA: the assignments give the camera. Nothing is said about it.
viewed()
{
    printf '%s\ncube([3, 2, 1]);\n' "$2" >"$1.scad"
    picture "$1" "$1.scad"
    is_silent
    picture "asked-$1" "$1.scad" "${@:3}"
    same "$1" "asked-$1"
}

# ---- the viewpoint. What is not assigned has the numbers of OpenSCAD's camera: 140 away. ----
viewed all '$vpt = [1, 1, 0.5]; $vpr = [70, 0, 30]; $vpd = 12; $vpf = 30;' \
    --camera=1,1,0.5,70,0,30,12 --fov=30
viewed rotated '$vpr = [-20.5, 1e1, 30];' --camera=0,0,0,-20.5,10,30,140
viewed flat '$vpt = [1, 2]; $vpd = 2.5e1;' --camera=1,2,0,55,0,25,25
viewed zero '$vpr = [0, 0, 0]; $vpd = 20;' --camera=0,0,0,0,0,0,20
viewed far '$vpd = 500; $vpt = [1, 0, 0];' --camera=1,0,0,55,0,25,500
viewed nan '$vpt = [0 / 0, 0, 0]; $vpd = 20;' --camera=0,0,0,55,0,25,20
viewed remark '/* $vpr = [0, 0, 0]; */ $vpd = 20; // $vpt == 0' --camera=0,0,0,55,0,25,20
viewed none 'x = $vpr; y = "$vpd = 3;";' --autocenter --viewall
picture fov all.scad --fov=10
different all fov
picture ortho all.scad --projection=o
different all ortho
picture asked rotated.scad --camera=0,0,0,55,0,25,10
different asked rotated
printf '$vpr = "up"; $vpd = 20; cube(3);\n' >text.scad
picture text text.scad
says 'Unable to convert $vpr="up"'
picture plain text.scad --camera=0,0,0,55,0,25,20
same text plain

# ---- parameter sets ----
echo 'size = 1; /* [sizes] */ height = 1; cube([size, size, height]);' >box.scad
echo '{"parameterSets": {"large": {"size": "3", "height": "2"}}, "fileFormatVersion": "1"}' >box.json
camera=(--camera=0,0,0,55,0,25,20)
picture set box.scad -p box.json -P large "${camera[@]}"
picture defined box.scad -D size=3 -D height=2 "${camera[@]}"
same set defined
picture unset box.scad "${camera[@]}"
different unset set
expect 1 "no file of parameters" render box.scad -p none.json -P large -o a.png
says "cannot read none.json: No such file or directory"
expect 1 "a folder of parameters" render box.scad -p . -P large -o a.png
says "cannot read .: Is a directory"
expect 0 "no such set" render box.scad -p box.json -P huge "${small[@]}" -o a.png
says "box.json has no set of parameters 'huge'"
expect 0 "half a pair" render box.scad -p box.json "${small[@]}" -o a.png
says "-p box.json has no effect"

# ---- fonts that come with the file, on a machine that has Liberation Sans only ----
mkdir machine fonts
cp "$(find /usr/share/fonts -name LiberationSans-Regular.ttf | head -n 1)" machine/
cp "$(find /usr/share/fonts -name LiberationSerif-Bold.ttf | head -n 1)" fonts/bold.ttf
echo "<fontconfig><dir>$work/machine</dir><cachedir>$work/fonts</cachedir></fontconfig>" >fonts.conf
export FONTCONFIG_FILE=$work/fonts.conf
text='text("ag", font = "Liberation Serif:style=Bold");'
echo "$text" >bare.csg
echo "include <letters.scad>" >text.scad
printf 'use <fonts/bold.ttf>\n%s' "$text" >letters.scad
echo "minkowski() { $text import_dxf(file = \"dot.dxf\"); }" >sum.csg
camera=(--camera=5,5,0,0,0,0,40)
picture none bare.csg "${camera[@]}"
picture font bare.csg --font=fonts/bold.ttf "${camera[@]}"
different none font
picture used text.scad "${camera[@]}"
same font used
echo 'square(0.01);' >dot.scad
openscad -o dot.dxf dot.scad >openscad.log 2>&1 || cat openscad.log
picture sum-none sum.csg --no-cache "${camera[@]}"
picture sum sum.csg --no-cache --font=fonts/bold.ttf "${camera[@]}"
different sum-none sum
expect 0 "a font that is none" render bare.csg --font=bare.csg "${small[@]}" -o bare.png
says "cannot read the font bare.csg"
unset FONTCONFIG_FILE

# ---- animations. $t is there from the file's first line on. ----
rm -rf ./*
echo 'x = 10 * $t; $vpr = [60, 0, 90 * $t]; $vpd = 50; translate([x, 0, 0]) cube(2); echo(x);' >turn.scad
expect 0 "four frames" render turn.scad --animate=4 "${small[@]}" -o frame.ppm
says "ECHO: 7.5"
holds_only turn.scad frame00000.ppm frame00001.ppm frame00002.ppm frame00003.ppm
echo 'translate([5, 0, 0]) cube(2);' >moved.scad
picture moved moved.scad --camera=0,0,0,60,0,45,50
cp frame00002.ppm frame.ppm
same moved frame
rm -f ./*.ppm
expect 0 "a name in a folder with a dot" render turn.scad --animate=1 "${small[@]}" -o ./name --format=png
check "it is named" is_png ./name00000
expect 2 "frames to a stream" render turn.scad --animate=3 -o -
expect 2 "frames of a .csg" render moved.csg --animate=3
says "has no \$t"
expect 2 "no frames" render turn.scad --animate=0
says "a number from 1 to 100000"
echo 'cube(1); assert($t < 0.4, "too late");' >late.scad
expect 1 "an animation that fails" render late.scad --animate=4 "${small[@]}" -o late.png
says "too late"
check "no file is left" test ! -e late00000.png

# ---- files for a newer OpenSCAD ----
cat >old <<'EOF'
#!/bin/sh
echo "WARNING: Ignoring unknown function 'textmetrics' in file x.scad, line 1" >&2
while [ "$1" != -o ]; do shift; done
echo 'cube(2);' >"$2"
EOF
printf '#!/bin/sh\necho "ERROR: Parser error: syntax error in file x.scad, line 1" >&2\nexit 1\n' >older
chmod +x old older
echo 'cube(2);' >newer.scad
expect 0 "a word of a newer OpenSCAD" info newer.scad --no-gl --openscad=./old
says "textmetrics() is of a newer OpenSCAD"
expect 1 "its grammar" info newer.scad --no-gl --openscad=./older
says "may be written for a newer one"

# ---- folders of those that were killed: the next call removes them, and no other one. ----
rm -rf ./*
mkdir tmp
export TMPDIR=$work/tmp
printf '#!/bin/sh\necho >>started\nexec sleep 60\n' >sleeps
chmod +x sleeps
echo 'cube(1);' >cube.scad

# start VARIABLE: a csgcast that waits for an openscad that sleeps.
start()
{
    local num
    num=$(find tmp -mindepth 1 -type d | wc -l)
    OPENSCAD=./sleeps setsid "$csgcast" render cube.scad -o never.png &
    printf -v "$1" %s $!
    while [[ $(find tmp -mindepth 1 -type d | wc -l) -eq $num ]]; do
        sleep 0.02
    done
}

start killed
start living
while [[ ! -e started || $(wc -l <started) -lt 2 ]]; do
    sleep 0.02
done
for folder in tmp/csgcast-run-*; do
    touch "$folder/scene.csg"
done
touch tmp/csgcast-run-abcde tmp/other-abcdef
mkdir tmp/csgcast-run-secret
chmod 755 tmp/csgcast-run-secret
mktemp -d tmp/csgcast-XXXXXX >/dev/null
# ended GROUP: no process of this group runs any more, those that are not yet waited for aside.
ended()
{
    for _ in {1..100}; do
        awk -v group="$1" '$5 == group && $3 != "Z" { runs = 1 } END { exit runs }' \
            /proc/[0-9]*/stat 2>/dev/null && return 0
        sleep 0.05
    done
    return 1
}

kill -KILL "$killed"
wait "$killed" 2>/dev/null
check "a killed call takes its openscad with it" ended "$killed"
expect 0 "a call after one that was killed" info cube.scad --no-gl
check "its folder is gone, the other's and what is not ours stays" \
    test "$(find tmp -mindepth 1 ! -type l -printf . | wc -c)" -eq 6
kill -TERM "$living"
wait "$living" 2>/dev/null
check "SIGTERM gives 143" test $? -eq 143
check "an ended call takes its openscad with it" ended "$living"
check "and its folder" test "$(find tmp -mindepth 1 -printf . | wc -c)" -eq 4

finish
