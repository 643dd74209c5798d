#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   warm.sh CSGCAST: after `csgcast warm` first pictures find all they need in the driver's cache.

csgcast=$1
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$(readlink -f "$0")")/checks.sh"
export MESA_SHADER_CACHE_DIR=$work/cache
unset MESA_SHADER_CACHE_DISABLE MESA_GLSL_CACHE_DISABLE
mkdir cache

programs()
{
    find cache -type f | wc -l
}

# A picture's process may end before the driver has written what it compiled: the second one has.
compiles_nothing()
{
    local before
    before=$(programs)
    for _ in 1 2; do
        "$csgcast" render "$1.csg" -q -o x.png "${@:2}"
    done
    [[ $(programs) -eq $before ]]
    report $? "$*: $(($(programs) - before)) programs compiled"
}

# scene NAME: of standard input.
scene()
{
    cat >"$1.csg"
}

# holes SIDE SOLID: a plate with so many holes a side.
holes()
{
    echo "difference() { cube([$((4 * $1)), $((4 * $1)), 2]);"
    local i
    for ((i = 0; i < $1 * $1; i++)); do
        echo "multmatrix([[1,0,0,$((i % $1 * 4 + 2))],[0,1,0,$((i / $1 * 4 + 2))],[0,0,1,-1],[0,0,0,1]]) $2"
    done
    echo "}"
}

far="multmatrix([[1, 0, 0, 40], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])"
twisted="linear_extrude(height = 20, twist = 90, slices = 20) square([10, 6], center = true);"
five="difference() { cube([20, 20, 20], center = true); sphere(r = 13);
    cylinder(h = 40, r = 6, center = true); cylinder(h = 50, r = 5, center = true); }"
scene cube <<<"cube([10, 10, 10]);"
scene cubes <<<"cube([10, 10, 10]); $far cube([10, 10, 10]);"
# By two programs in turns.
for i in 0 1 2 3 4 5 6 7; do
    echo "multmatrix([[1,0,0,$((20 * i))],[0,1,0,0],[0,0,1,0],[0,0,0,1]])"
    ((i % 2)) && echo "cube([9, 9, 9]);" || echo "sphere(r = 5);"
done | scene row
scene ball <<<"sphere(r = 10);"
scene prism <<<'cylinder($fn = 5, h = 10, r1 = 4, r2 = 4);'
scene glass <<<"color([1, 0, 0, 0.5]) cylinder(h = 10, r = 4);"
scene five <<<"$five"
scene fives <<<"$five $far $five"
scene twisted <<<"$twisted"
scene bored <<<"difference() { $twisted cylinder(h = 40, r = 2); }"
scene behind <<<"%cube([10, 10, 10]); $five"
holes 2 "cylinder(h = 9, r = 1);" | scene drilled
holes 40 "cylinder(h = 9, r = 1);" | scene many

# What a render of `five` says on a terminal.
on_terminal()
{
    script -qec "'$csgcast' render five.csg -o x.png $*" /dev/null
}

check "a terminal is told of warm" grep -q 'csgcast warm' <(on_terminal)
rm -r cache
mkdir cache
check "not with -q" test -z "$(on_terminal -q)"
timeout 250 "$csgcast" warm 2>err
report $? "warm"
is_silent
# A busy machine may take as long for what the driver's cache has, but not three times.
one_says_nothing()
{
    [[ -z $(on_terminal) || -z $(on_terminal) || -z $(on_terminal) ]]
}
check "nor after it" one_says_nothing
check "the driver has a cache" test "$(programs)" -gt 50
for name in cube cubes row ball prism glass five fives twisted bored behind drilled many; do
    compiles_nothing $name
done
compiles_nothing five --imgsize=500,300
compiles_nothing five --projection=o
before=$(programs)
"$csgcast" warm
check "nothing is left to compile" test "$(programs)" = "$before"
for _ in 1 2 3; do
    "$csgcast" render five.csg -q -o x.png --variant=algorithm4
done
check "but what nobody asks for" test "$(programs)" -gt "$before"

# Without OpenGL there is nothing to do.
expect 0 "the reference" warm --backend=reference
CSGCAST_EGL_DEVICE=4711 expect 1 "no such device" warm
says "4711"
expect 2 "a scene" warm five.csg
finish
