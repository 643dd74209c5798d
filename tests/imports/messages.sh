#!/bin/sh
# SPDX-License-Identifier: MIT
#
#   messages.sh CSGCAST
#
# What csgcast says of files that are broken, or that want too much: with the place in the scene and
# in the file, soon, and without reading any other file.

set -eu
csgcast=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
failed=0

# says FILE TEXT: what info says of a scene that imports the file. It may not ask openscad.
says()
{
    case $1 in
    *.dat) node=surface ;;
    *) node=import ;;
    esac
    echo "$node(file = \"$1\");" >scene.csg
    CSGCAST_CACHE= timeout 60 "$csgcast" info --no-handoff scene.csg >out 2>&1 || true
    if ! grep -qF "$2" out; then
        echo "FAIL $1: no '$2' in"
        cat out
        failed=1
    fi
}

# A block that is inserted in itself 40 times: 2^40 lines.
dxf_bomb()
{
    printf '0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nA\n0\nLINE\n10\n0\n20\n0\n11\n1\n21\n1\n'
    for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 \
        31 32 33 34 35 36 37 38 39 40; do
        printf '0\nINSERT\n2\nA\n10\n%s\n20\n1\n' "$i"
    done
    printf '0\nENDBLK\n0\nENDSEC\n0\nEOF\n'
}

# Entities that stand for ten of the one before.
xml_bomb()
{
    printf '<!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa">'
    for pair in ba cb dc ed fe gf hg; do
        one="&${pair#?};"
        printf '<!ENTITY %s "%s">' "${pair%?}" "$one$one$one$one$one$one$one$one$one$one"
    done
    printf ']><svg><path d="&h;"/></svg>'
}

place='scene.csg:1:1: import:'

printf '0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n1,5\n0\nENDSEC\n' >comma.dxf
says comma.dxf "warning: $place comma.dxf:8: '1,5' is no number; it is left out"
says comma.dxf "warning: $place comma.dxf:10: 'ENDSEC': the entity before has too few points"
stl_loop()
{
    printf 'facet normal 0 0 1\nouter loop\n'
    printf 'vertex %s\n' "$@"
    printf 'endloop\nendfacet\n'
}
{
    echo solid
    stl_loop '0 0 0' '0 1 0' '1 0 0' '2 0 0'
} >four.stl
says four.stl "warning: $place four.stl:7: malformed; nothing is drawn"
# A loop of two is none, and takes no corner of the next one.
{
    echo solid
    stl_loop '9 9 9' '8 8 8'
    stl_loop '0 0 0' '0 1 0' '1 0 0'
    stl_loop '0 0 0' '1 0 0' '0 0 1'
    stl_loop '0 0 0' '0 0 1' '0 1 0'
    stl_loop '1 0 0' '0 1 0' '0 0 1'
} >two.stl
says two.stl 'bounds             0 0 0 to 1 1 1'
# A triangle with a corner that is not finite is left out, the others are there.
tetrahedron()
{
    stl_loop '0 0 0' '0 1 0' '1 0 0'
    stl_loop '0 0 0' '1 0 0' '0 0 1'
    stl_loop '0 0 0' '0 0 1' '0 1 0'
    stl_loop '1 0 0' '0 1 0' '0 0 1'
}
{
    echo solid
    stl_loop '0 0 0' '0 -NaN 0' '1 0 0'
    tetrahedron
    stl_loop '0 0 0' '0 inf 0' '1 0 -Infinity'
} >nan.stl
says nan.stl "warning: $place nan.stl:5: a corner is not finite; such triangles are left out"
says nan.stl 'bounds             0 0 0 to 1 1 1'
says nan.stl 'planes             4'
{
    echo solid
    stl_loop '0 0 0' '0 nano 0' '1 0 0'
} >nano.stl
says nano.stl "warning: $place nano.stl:5: malformed; nothing is drawn"
# One triangle of zeroes and nan, in binary.
{
    head -c 80 /dev/zero
    printf '\001\000\000\000'
    head -c 24 /dev/zero
    printf '\000\000\300\177'
    head -c 22 /dev/zero
} >binary.stl
says binary.stl "warning: $place binary.stl: a corner is not finite; such triangles are left out"
says binary.stl "warning: $place binary.stl: no face in it; nothing is drawn"

printf '0\nSECTION\nx\ny\n0\nEOF\n' >code.dxf
says code.dxf "warning: $place code.dxf:3: 'x' is no group code; the rest is left out"
printf '0\nSECTION\n2\nENTITIES\n0\nSPLINE\n0\nENDSEC\n' >spline.dxf
says spline.dxf "warning: $place spline.dxf:8: unsupported DXF entity 'SPLINE'; it is left out"
dxf_bomb >bomb.dxf
says bomb.dxf 'error: scene.csg:1:1: bomb.dxf: blocks and curves of more than 5000000 lines'

printf '<svg>\n<rect width="9"' >short.svg
says short.svg "warning: $place short.svg:2: "
printf '<svg><rect id="\377"/></svg>' >encoding.svg
says encoding.svg "warning: $place encoding.svg:1: Input is not proper UTF-8"
xml_bomb >bomb.svg
says bomb.svg "warning: $place bomb.svg:1: "
echo secret >other.txt
printf '<!DOCTYPE svg [<!ENTITY x SYSTEM "other.txt">]>\n<svg><text>&x;</text></svg>' >other.svg
says other.svg "error: $place other.svg:2: the entity 'x' is not read"
printf '<!DOCTYPE svg [<!ENTITY x SYSTEM "other.txt">]>\n<svg id="&x;"/>' >attribute.svg
says attribute.svg "warning: $place attribute.svg:2: Attribute references external entity 'x'"

printf '<amf><object><mesh><vertices><vertex><coordinates>\n<x>a</x></coordinates></vertex></vertices></mesh></object></amf>' >letter.amf
says letter.amf "warning: $place letter.amf:2: 'a' is no number; nothing is drawn"
printf '<amf><object><mesh><volume><triangle>\n<v1>7</v1></triangle>' >corner.amf
says corner.amf "warning: $place corner.amf:2: a triangle has no point"
printf 'PK' >short.3mf
says short.3mf "warning: $place short.3mf: "
says missing.3mf "warning: $place ./missing.3mf: No such file or directory; nothing is drawn"
printf 'solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n' >cut.stl
says cut.stl "warning: $place cut.stl: no face in it; nothing is drawn"
printf 'OFF\n0 0 0\n' >none.off
says none.off "warning: $place none.off: no face in it; nothing is drawn"
echo '<amf/>' >none.amf
says none.amf "warning: $place none.amf: no face in it; nothing is drawn"
printf '0\nEOF\n' >none.dxf
says none.dxf "warning: $place none.dxf: no line in it; nothing is drawn"
echo '<svg><g/></svg>' >none.svg
says none.svg "warning: $place none.svg: no shape in it; nothing is drawn"
echo '1 2 3' >row.dat
says row.dat 'warning: scene.csg:1:1: surface: row.dat: less than two rows or columns'
says other.obj 'import is not supported yet'

exit "$failed"
