#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   export.sh CSGCAST PNGCMP SCENE [option...]
#
# The scene drawn by csgcast, and by POV-Ray from what `csgcast export` writes, compared as
# tests/openscad compares pictures: silhouettes may differ beside their edge only, colours in no
# block of 3x3 pixels but for the $MAX_BLOCKS (default 0) that coincident faces may cost.

set -euo pipefail
csgcast=$1
pngcmp=$2
scene=$3
shift 3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

if ! command -v povray >/dev/null; then
    echo "The export tests need povray (Debian: povray)" >&2
    exit 1
fi

size=(--imgsize=160,120)
"$csgcast" export "$scene" -q -o "$work/scene.pov" "${size[@]}" "$@"
if ! (cd "$work" && povray +W160 +H120 -D -GA +FP +WT2 +Iscene.pov +Otheirs.ppm) >"$work/log" 2>&1
then
    echo "POV-Ray does not take the scene:" >&2
    cat "$work/log" >&2
    exit 1
fi
"$csgcast" render "$scene" -q -o "$work/ours.ppm" "${size[@]}" "$@"
"$pngcmp" --blocks="${MAX_BLOCKS:-0}" "$work/ours.ppm" "$work/theirs.ppm" | tee "$work/sums"
grep -q 'covered [1-9]' "$work/sums" # a picture of nothing proves nothing
