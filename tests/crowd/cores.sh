#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   tests/crowd/cores.sh CSGCAST SOURCE
#
# A crowd, and many objects that are drawn in tiles, between others that are not: the picture is the
# same to the last bit whether the threads run side by side or in turns, however many there are.

set -u
csgcast=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

awk -f "$source/scenes/bench/crowd.awk" -v kind=molecule -v n=2000 >crowd.csg
awk 'BEGIN {
    srand(5)
    for (i = 0; i < 60; i++) {
        if (i % 3 == 0)
            printf "sphere(%g);\n", 1 + i / 10
        printf "multmatrix([[1,0,0,%g],[0,1,0,%g],[0,0,1,%g],[0,0,0,1]]) difference() {", \
            i % 8 * 7, int(i / 8) * 8, i % 5
        printf "cube(size = [10, 10, 3]);"
        for (j = 0; j < 25; j++)
            printf "multmatrix([[1,0,0,%g],[0,1,0,%g],[0,0,1,-1],[0,0,0,1]]) cylinder(h = 5, r = %g);", \
                1 + 2 * (j % 5), 1 + 2 * int(j / 5), 0.3 + 0.7 * rand()
        print "}"
    }
}' >parts.csg

failed=0
for scene in crowd parts; do
    for run in side turns one five; do
        along=() threads=0
        case $run in
        turns) along=(taskset -c 0) ;;
        one) threads=1 ;;
        five) threads=5 ;;
        esac
        "${along[@]}" "$csgcast" render $scene.csg -q --imgsize=300,300 --aov=Z,N,id \
            --threads=$threads -o $run.exr || failed=1
        if ! cmp side.exr $run.exr; then
            echo "FAIL $scene: threads ($run) give another picture"
            failed=1
        fi
    done
done
"$csgcast" render parts.csg -q --imgsize=300,300 -o side.exr --stats 2>stats || failed=1
grep -q "tiles, mixed       [1-9]" stats || { echo "FAIL parts: no tiles"; failed=1; }
exit $failed
