#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   options.sh CSGCAST: what the command line accepts and how it answers when it does not.

csgcast=$1
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$(readlink -f "$0")")/checks.sh"

echo 'cube(10);' >cube.csg

# Help and version go to standard output.
expect 0 "version" --version
prints "csgcast 0."
expect 0 "overview" help
prints "Exit codes"
expect 0 "overview as an option" --help
expect 0 "help of a command" help render
prints "--imgsize=W,H"
prints "Cornfield"
prints "Exit codes"
expect 0 "help as an option" render --help
prints "Examples"
prints "  -P SET "
expect 0 "help of export" help export
check "no variants where none can be chosen" test "$(grep -c '^Variants' out)" = 0
expect 0 "help of info" info -h
prints "--json"
is_silent

# Usage errors exit with 2 and name the remedy.
expect 2 "no command"
says "csgcast help"
expect 2 "unknown command" rendr cube.csg
says "did you mean render"
expect 2 "scene instead of a command" cube.csg
says "csgcast render cube.csg"
expect 2 "help of an unknown command" help nothing
expect 2 "no scene" render
says "which scene"
expect 2 "two scenes" info cube.csg cube.csg
says "more than one scene"
expect 2 "two scenes of one name" render cube.csg folder/cube.csg
says "several of the scenes would become cube.png"
expect 2 "two scenes, one image" render cube.csg other.csg -o x.png
says "-o names one file"
expect 2 "empty name" render ''
expect 2 "unknown option" render cube.csg --imgsiz=3,3
says "did you mean --imgsize"
expect 2 "unknown option, far from all" render cube.csg --xyzzy-plugh
says "csgcast help render"
expect 2 "unknown letter" render cube.csg -Z
says "unknown option -Z"
expect 2 "another command's option" render cube.csg --json
says "has no option --json"
expect 2 "value missing" render cube.csg --imgsize
says "needs a value"
expect 2 "value not wanted" render cube.csg --viewall=1
says "takes no value"
expect 2 "standard input needs -o" render -
says "-o"
expect 2 "-o twice" render cube.csg -o a.png -o b.png

# wrong OPTION VALUE...: each value is refused.
wrong()
{
    local option=$1
    shift
    for value in "$@"; do
        expect 2 "$option=$value" render cube.csg "$option=$value"
    done
}
wrong --antialias '' 0 9 -1 1.5 x
wrong --imgsize '' 5 0,5 -1,5 5,5,5 a,b 1.5,2 16385,1 1e99,1 '5,5 ' '5, x' nan,1 inf,1 ,
wrong --camera '' 1 1,2,3,4,5 1,2,3,4,5,6,7,8 1,2,3,4,5,x 1,2,3,4,5,nan 1,2,3,4,5,inf,1 1,,3,4,5,6
wrong --projection '' x perspectives
wrong --fov '' 0 -1 180 nan x 22.5,1
wrong --colorscheme '' cornfield None
wrong --variant '' nothing
wrong --backend '' gl
wrong --facets '' Exact 12
wrong --bits '' 0 7 12 32 x
wrong --aov '' z Z, Z,,N Z,N,ids ,
wrong --cut-color '' red
wrong -D '' width =3
holds_only cube.csg

# Both spellings, letters glued on, OpenSCAD's words, any order.
small=(--imgsize "16,16" --quiet)
expect 0 "values behind options" render cube.csg "${small[@]}" --camera 0,0,0,55,0,25,140 -o a.png
expect 0 "negative value" render cube.csg "${small[@]}" --camera -50,-40,30,0,0,0 -o a.png
expect 0 "options first" render "${small[@]}" -oa.png --projection=ortho cube.csg
expect 0 "OpenSCAD's --o" render "${small[@]}" --o a.png --projection=perspective cube.csg
expect 0 "-- ends the options" render "${small[@]}" -o a.png -- cube.csg
is_silent
for scheme in Cornfield Metallic Sunset Starnight BeforeDawn Nature DeepOcean Solarized Tomorrow \
    "Tomorrow Night" Monotone; do
    expect 0 "$scheme" render cube.csg "${small[@]}" -o a.png --colorscheme "$scheme"
done

# OpenSCAD's options that have no meaning here are accepted, with a warning.
expect 0 "OpenSCAD's options" render cube.csg --imgsize=16,16 -o a.png --preview --hardwarnings \
    --view=axes,edges --csglimit 1000 --check-parameters true --enable=manifold --render \
    --backend=Manifold
says "--preview has no effect"
says "--csglimit has no effect"
expect 0 "the same, quiet" render cube.csg "${small[@]}" -o a.png --hardwarnings -d deps
is_silent
expect 2 "OpenSCAD's STL files" render cube.csg -s cube.stl
says "writes images"

expect 0 "-D on a .csg" render cube.csg --imgsize=16,16 -o a.png -D width=3
says "-D width=3 has no effect"
expect 0 "-D on a .csg, info" info cube.csg --no-gl -D width=3
says "-D width=3 has no effect"
expect 0 "-p on a .csg" render cube.csg --imgsize=16,16 -o a.png -p sets.json -P large
says "-p sets.json has no effect"
expect 0 "-P without -p" render cube.csg --imgsize=16,16 -o a.png -P large
says "-P large has no effect"
expect 0 "-p without -P, quiet" render cube.csg "${small[@]}" -o a.png -p sets.json -q
is_silent

finish
