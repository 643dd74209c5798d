#!/bin/sh
# SPDX-License-Identifier: MIT
#
#   case.sh CACHE REFEREE SCENE.scad as-written|exact|auto [referee option...]
#   case.sh CACHE REFEREE SCENE.scad cgal [referee option...]
#   case.sh CACHE REFEREE SCENE.scad converge [referee option...]
#
# One case of the referee. The mesh comes from OpenSCAD 2025 (Manifold), for cgal from the openscad
# in the path. converge makes meshes of $fn = 32, 64, 128 and 256.

set -eu
here=$(dirname "$0")
cache=$1
referee=$2
scene=$3
mode=$4
shift 4

need()
{
    if ! command -v "$1" >/dev/null; then
        echo "The OpenSCAD tests need $1 (Debian: apt-get install $2)" >&2
        exit 1
    fi
}

need node nodejs
need openscad openscad
case=$(basename "$scene" .scad)-$mode
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# What OpenSCAD 2021.01 exports, quietly; $1 is where to, the rest are options.
export_to()
{
    out=$1
    shift
    openscad -o "$out" "$@" "$scene" >"$work/log" 2>&1 || {
        cat "$work/log" >&2
        exit 1
    }
}

sagitta()
{
    export_to "$work/scene.csg" "$@"
    node "$here/sagitta.mjs" "$facets" "$work/scene.csg"
}

mesh()
{
    node "$here/mesh.mjs" "$cache" "$scene" "$@"
}

case $mode in
as-written)
    stl=$(mesh)
    "$referee" --name="$case" --facets=as-written "$@" "$scene" "$stl"
    ;;
exact | auto)
    facets=$mode
    stl=$(mesh)
    "$referee" --name="$case" --facets="$facets" --sagitta="$(sagitta)" "$@" "$scene" "$stl"
    ;;
cgal)
    # Six digits in its STL: depths and normals are only as good as that.
    export_to "$work/mesh.stl"
    "$referee" --name="$case" --facets=as-written --depth=3e-5 --normal=1 "$@" "$scene" \
        "$work/mesh.stl"
    ;;
converge)
    facets=exact
    first=$(sagitta -D '$fn=32')
    a=$(mesh '$fn=32')
    b=$(mesh '$fn=64')
    c=$(mesh '$fn=128')
    d=$(mesh '$fn=256')
    "$referee" --converge --name="$case" --facets=exact --sagitta="$first" "$@" "$scene" \
        "$a" "$b" "$c" "$d"
    ;;
*)
    echo "case.sh: unknown mode $mode" >&2
    exit 2
    ;;
esac
