#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# limits.sh CSGCAST: what is too much for the driver of narrow.c is an error that says what to do.

csgcast=$(readlink -f "$1")
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$(readlink -f "$0")")/../cli/checks.sh"

echo 'sphere(1);' >ball.csg
expect 0 "the largest image" render ball.csg -o a.png --imgsize=1024,2
for size in 1025,2 2,1025; do
    expect 1 "$size" render ball.csg -o b.png --imgsize=$size
    says "this driver allows 1024 each way: use --backend=reference, or a smaller image"
    check "one message" test "$(wc -l <err)" = 1
    check "no picture" test ! -e b.png
done
expect 0 "a large image without the driver" render ball.csg -o c.png --imgsize=1025,2 \
    --backend=reference

# Many single solids, side by side.
for ((i = 0; i < 100000; i++)); do
    echo "multmatrix([[1,0,0,$((i % 320))],[0,1,0,$((i / 320))],[0,0,1,0]]) sphere(r = 0.4);"
done >crowd.csg
expect 1 "a large scene" render crowd.csg -o d.png --imgsize=1000,1000 \
    --camera=160,156,0,0,0,0,850
says "texels and this driver allows 65536: use --backend=reference, or split the scene"
check "no picture" test ! -e d.png

finish
