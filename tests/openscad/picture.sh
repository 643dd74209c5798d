#!/bin/sh
# SPDX-License-Identifier: MIT
#
#   picture.sh CSGCAST PNGCMP NAME SCENE.scad [option...]
#
# OpenSCAD's PNG and csgcast's of the same scene with the same options, compared as OpenSCAD
# compares its own test pictures. CSGCAST is the tool. $PNGCMP_OPTIONS are for pngcmp. On failure
# NAME.out.png (csgcast), NAME.ref.png (OpenSCAD) and NAME.diff.png stay in the working directory.

set -eu
csgcast=$1
pngcmp=$2
name=$3
scene=$4
shift 4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

need()
{
    if ! command -v "$1" >/dev/null; then
        echo "The OpenSCAD tests need $1 (Debian: apt-get install $2)" >&2
        exit 1
    fi
}

need openscad openscad
need xvfb-run xvfb
need xauth xauth
need oiiotool openimageio-tools

xvfb-run -a -s '-screen 0 640x480x24' \
    openscad -o "$work/ref.png" "$@" "$scene" >"$work/log" 2>&1 || true
if [ ! -s "$work/ref.png" ]; then
    echo "OpenSCAD made no picture under Xvfb:" >&2
    cat "$work/log" >&2
    exit 1
fi
"$csgcast" render "$scene" -o "$work/out.png" --facets=as-written "$@"

oiiotool "$work/ref.png" --ch R,G,B -o "$work/ref.ppm"
oiiotool "$work/out.png" --ch R,G,B -o "$work/out.ppm"
printf '%s: ' "$name"
if "$pngcmp" ${PNGCMP_OPTIONS:-} "$work/out.ppm" "$work/ref.ppm"; then
    exit 0
fi
cp "$work/out.png" "$name.out.png"
cp "$work/ref.png" "$name.ref.png"
oiiotool "$work/out.ppm" "$work/ref.ppm" --absdiff -o "$name.diff.png"
echo "FAIL $name: see $PWD/$name.{out,ref,diff}.png" >&2
exit 1
