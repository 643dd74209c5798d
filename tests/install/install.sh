#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   install.sh CMAKE BUILD EXAMPLES CC LIBDIR GENERATOR: installs BUILD into a folder of its own,
#   then builds and runs the programs in EXAMPLES against that, with CMake and with pkg-config.

set -u
cmake=$1 build=$2 examples=$3 cc=$4 libdir=$5 generator=$6
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix
num_failed=0

# check NAME COMMAND...: its output matters only when it fails.
check()
{
    local name=$1
    shift
    if "$@" >"$work/log" 2>&1; then
        echo "ok $name"
    else
        echo "FAIL $name"
        cat "$work/log"
        num_failed=$((num_failed + 1))
    fi
}

with_cmake()
{
    "$cmake" -S "$examples" -B "$work/examples" -G "$generator" -DCMAKE_PREFIX_PATH="$prefix" \
        -DCMAKE_C_COMPILER="$cc" -DCMAKE_C_FLAGS="-Wall -Wextra -Wconversion -Werror" &&
        "$cmake" --build "$work/examples" &&
        "$work/examples/picture" "$work/cmake.png" && [[ -s $work/cmake.png ]]
}

# What is picked is the face on top of the plate.
preview()
{
    "$work/examples/preview" | tee "$work/picked" &&
        grep -q '^cube(\[20, 20, 6\], center = true), line 2, at .* 3\.000$' "$work/picked"
}

with_pkg_config()
{
    local flags
    export PKG_CONFIG_PATH=$prefix/$libdir/pkgconfig
    [[ csgcast\ $(pkg-config --modversion csgcast) == $("$prefix/bin/csgcast" --version) ]] &&
        read -ra flags <<<"$(pkg-config --cflags --libs csgcast)" &&
        "$cc" -std=c11 -Wall -Wextra -Werror "$examples/picture.c" "${flags[@]}" -lm \
            -o "$work/with-pkg-config" &&
        LD_LIBRARY_PATH=$prefix/$libdir "$work/with-pkg-config" "$work/pkg-config.png" &&
        [[ -s $work/pkg-config.png ]]
}

# Only csgcast_* is the library's; anything else could clash with the program's own names.
exports_only_csgcast()
{
    local others
    others=$(nm -D --defined-only "$prefix/$libdir/libcsgcast.so" | awk '{print $3}' |
        grep -v '^csgcast_')
    echo "$others"
    [[ -z $others ]]
}

man_page()
{
    local page=$prefix/share/man/man1/csgcast.1 said
    [[ -s $page ]] || return 1
    if command -v mandoc >/dev/null; then
        mandoc -T lint -W warning "$page" || return 1
    fi
    if command -v man >/dev/null; then
        said=$(MANWIDTH=80 LC_ALL=C.UTF-8 man --warnings -l "$page" 2>&1 >/dev/null)
        echo "$said"
        [[ -z $said ]] || return 1
    fi
    # Each option of the help has its place in the page.
    for command in render info export compare bench report; do
        "$prefix/bin/csgcast" help "$command"
    done >"$work/help"
    grep -oE '^  (-., )?--[a-z-]+' "$work/help" | grep -oE -- '--[a-z-]+' | sort -u |
        while read -r option; do
            grep -qF -- "${option//-/\\-}" "$page" || { echo "man page lacks $option"; exit 1; }
        done
}

shipped_scene()
{
    local scene
    scene=$(find "$prefix/share/csgcast/scenes" -name '*.csg' | sort | head -n 1)
    [[ -n $scene ]] && "$prefix/bin/csgcast" render "$scene" --imgsize=16,16 -o "$work/scene.png" &&
        [[ -s $work/scene.png ]]
}

check "install" "$cmake" --install "$build" --prefix "$prefix"
check "the module is in place" test -e "$prefix/$libdir/csgcast/csgcast-image.so"
check "the one for text as well" test -e "$prefix/$libdir/csgcast/csgcast-text.so"
check "the one for XML as well" test -e "$prefix/$libdir/csgcast/csgcast-xml.so"
check "the one for 3MF as well" test -e "$prefix/$libdir/csgcast/csgcast-3mf.so"
check "the one for drawings as well" test -e "$prefix/$libdir/csgcast/csgcast-clip.so"
check "the one for bent faces as well" test -e "$prefix/$libdir/csgcast/csgcast-tess.so"
check "the one for digits as well" test -e "$prefix/$libdir/csgcast/csgcast-digits.so"
# The build folder must not be needed any more: no run path may lead there.
check "the installed tool runs" "$prefix/bin/csgcast" --version
check "no file names the build folder" bash -c "! grep -rlI '$build' '$prefix'"
check "a program with CMake" with_cmake
check "an example with edits and picking" preview
check "an example with threads" "$work/examples/threads"
check "the same with OSMesa" "$work/examples/threads" osmesa
check "the same without OpenGL" "$work/examples/threads" reference
check "an example with OpenGL of its own" "$work/examples/host"
check "a program with pkg-config" with_pkg_config
check "exported names" exports_only_csgcast
check "man page" man_page
check "a shipped scene" shipped_scene

[[ $num_failed -eq 0 ]]
