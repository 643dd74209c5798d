#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# handoff.sh CSGCAST: subtrees that only openscad can evaluate, and the cache of what it made of
# them. The scenes use import_dxf(), an old name that is not native.

csgcast=$(readlink -f "$1")
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$0")/checks.sh"
unset OPENSCAD XDG_CACHE_HOME CSGCAST_CACHE_SIZE
export CSGCAST_CACHE=$work/cache
mkdir -p parts elsewhere

# dxf NAME SIZE: a drawing of a rectangle, [SIZE, 3] with a corner cut off.
dxf()
{
    echo "difference() { square([$2, 3]); square(1); }" >shape.scad
    openscad -o "$1" shape.scad >openscad.log 2>&1 || cat openscad.log
    rm -f shape.scad openscad.log
}

# scene NAME SIZE: a plate with a hole of that shape.
scene()
{
    dxf "shape$2.dxf" "$2"
    cat >"$1" <<END
difference() {
	cube(size = [10, 10, 2]);
	linear_extrude(height = 5) {
		import_dxf(file = "shape$2.dxf");
	}
}
END
}

# says_nothing_new: nothing but OpenSCAD's own warning that the node is an old one.
says_nothing_new()
{
    check "says nothing" test "$(grep -cv 'openscad: DEPRECATED: The import_dxf() module' err)" = 0
}

# prints_way TEXT: info has such a line about openscad.
prints_way()
{
    grep "^openscad" out | grep -qF -- "$1"
    report $? "info says \"$1\""
}

entries()
{
    find "$1" -name '*.csgcast' 2>/dev/null | wc -l
}

scene a.csg 4
expect 0 "a node is handed over" info a.csg --no-gl
prints_way "import_dxf, a.csg:4:3"
prints "by openscad        1"
says "warning: a.csg:4:3: openscad: DEPRECATED: The import_dxf() module"
check "one entry in the cache" test "$(entries cache)" = 1
expect 0 "again" info a.csg --no-gl
prints_way "from the cache"
expect 0 "without the cache" info a.csg --no-gl --no-cache
check "not from the cache" test "$(grep -c 'from the cache' out)" = 0

expect 0 "drawn" render a.csg -o a.png --imgsize=64,64 --camera=5,5,30,5,5,0
check "a picture" is_png a.png
expect 1 "not handed over" info a.csg --no-gl --no-handoff
says "a.csg:4:3: import_dxf is not supported yet; --skip-unsupported draws the rest"

# A polyhedron beside a Boolean.
cat >beside.csg <<END
hull() {
	polyhedron(points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]], faces = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]]);
	difference() { cube(size = 3); cube(size = 2); }
}
END
expect 0 "a hull is not handed over" info beside.csg --no-gl --no-handoff

# 5,000 and 968 corners.
echo 'minkowski() { sphere(r = 10, $fn = 100); sphere(r = 3, $fn = 44); }' >sum.csg
expect 0 "a large sum is not handed over" info sum.csg --no-gl --no-handoff --facets=as-written

OPENSCAD=/nowhere/openscad expect 1 "no openscad" info a.csg --no-gl
says "a.csg:4:3: import_dxf: only openscad can evaluate it, and '/nowhere/openscad' does not run"
OPENSCAD=/nowhere/openscad expect 0 "no openscad, but the rest" info a.csg --no-gl --skip-unsupported
says "warning: a.csg:4:3"

# What is imported may be a pipe that nobody writes to.
mkfifo pipe
echo 'import("pipe");' >pipe.csg
expect 0 "a pipe is not waited for" info pipe.csg --no-gl --no-cache
rm pipe pipe.csg

# A stand-in that fails, one that dies, one that writes nonsense, two for whom the disk is full.
printf '#!/bin/sh\n[ "$1" = --version ] && exit 0\necho "ERROR: no such thing"; exit 1\n' >fails
printf '#!/bin/sh\n[ "$1" = --version ] && exit 0\nkill -9 $$\n' >dies
printf '#!/bin/sh\n[ "$1" = --version ] && exit 0\necho nonsense >"$2"\n' >nonsense
printf '#!/bin/sh\nopenscad "$@"; [ "$1" = --version ] || : >"$2"\n' >full
printf '#!/bin/sh\nopenscad "$@"; [ "$1" = --version ] || truncate -s -50 "$2"\n' >short
chmod +x fails dies nonsense full short
OPENSCAD=./fails expect 1 "openscad fails" info a.csg --no-gl
says "error: a.csg:4:3: openscad: ERROR: no such thing"
says "openscad reports an error (exit status 1)"
OPENSCAD=./dies expect 1 "openscad is killed" info a.csg --no-gl
says "openscad was killed by signal 9"
OPENSCAD=./nonsense expect 1 "openscad writes nonsense" info a.csg --no-gl
says "its STL file cannot be read"
OPENSCAD=./full expect 1 "openscad writes nothing" info a.csg --no-gl --cache=other
OPENSCAD=./short expect 1 "openscad writes one triangle less" info a.csg --no-gl --cache=other
says "its STL file cannot be read"
check "none of these is in a cache" test "$(entries cache) $(entries other)" = "1 0"

# What openscad may take. Starting it takes less than a second.
printf '#!/bin/sh\n[ "$1" = --version ] && exit 0\nwhile :; do :; done\n' >never
printf '#!/bin/sh\n[ "$1" = --version ] && exit 0\nawk "BEGIN { for (;;) a[++i] = i }" || { echo "std::bad_alloc"; exit 1; }\n' >eats
printf '#!/bin/sh\n[ "$1" = --version ] && exit 0\necho "ERROR: $(ulimit -d)"; exit 1\n' >bound
echo 'cube(1);' >never.scad
chmod +x never eats bound
OPENSCAD=./never expect 1 "openscad does not end" info a.csg --no-gl --cache=other --openscad-time=1
says "a.csg:4:3: import_dxf: only openscad can evaluate it, and openscad needs more than 1 s of processor time (--openscad-time)"
OPENSCAD=./eats expect 1 "openscad takes all memory" info a.csg --no-gl --cache=other --openscad-memory=100
says "needs more than 100 MiB of memory (--openscad-memory)"
OPENSCAD=./never expect 1 "flattening does not end" info never.scad --no-gl --openscad-time=1
says "cannot flatten never.scad: ./never needs more than 1 s of processor time"
OPENSCAD=./bound expect 1 "half of the memory" info a.csg --no-gl --cache=other
half=$(($(getconf _PHYS_PAGES) / 2 * $(getconf PAGESIZE) / 1024))
check "is the bound" test "$(sed -n 's/.*openscad: ERROR: \([0-9]*\)$/\1/p' err)" = "$half"
expect 2 "no memory" info a.csg --no-gl --openscad-memory=0
expect 2 "no time" info a.csg --no-gl --openscad-time=0.5

# Corrupt entries are as good as none.
for file in cache/*.csgcast; do
    printf x | dd of="$file" bs=1 seek=100 conv=notrunc 2>dd.log
done
expect 0 "a corrupt entry" info a.csg --no-gl
check "is not used" test "$(grep -c 'from the cache' out)" = 0
for file in cache/*.csgcast; do
    truncate -s 30 "$file"
done
expect 0 "a short entry" info a.csg --no-gl
says_nothing_new
rm -f dd.log

# The bound: what was not used for the longest time goes.
rm -rf cache
expect 0 "first" info a.csg --no-gl
size=$(stat -c %s cache/*.csgcast)
touch -d '1 hour ago' cache/*.csgcast
scene b.csg 5
scene c.csg 6
expect 0 "second" info b.csg --no-gl
touch -d '30 minutes ago' "$(find cache -name '*.csgcast' -newermt '10 minutes ago')"
expect 0 "the first is used" info a.csg --no-gl
expect 0 "third, with room for two" info c.csg --no-gl \
    --cache-size="$(awk "BEGIN { print 2.5 * $size / 1048576 }")"
check "two entries are left" test "$(entries cache)" = 2
expect 0 "the first" info a.csg --no-gl
prints_way "from the cache"
expect 0 "the second" info b.csg --no-gl
check "had to go" test "$(grep -c 'from the cache' out)" = 0

# Imported files belong to the key, found from the scene's folder.
echo 'linear_extrude(height = 1) import_dxf(file = "block.dxf");' >parts/cut.csg
dxf parts/block.dxf 3
(cd elsewhere && "$csgcast" info ../parts/cut.csg --no-gl >../out 2>../err)
report $? "an import in another folder"
prints "bounds             0 0 0 to 3 3 1"
dxf parts/block.dxf 5
expect 0 "the file has changed" info parts/cut.csg --no-gl
prints "bounds             0 0 0 to 5 3 1"
rm parts/block.dxf
expect 0 "the file is gone" info parts/cut.csg --no-gl
says "parts/cut.csg:1:28: openscad: WARNING: Can't open"
prints "bounds             empty"

# A solid, and the same subtree twice: openscad is asked once.
cat >solid.csg <<'END'
dxf_linear_extrude(file = "shape4.dxf", height = 2);
translate([0, 5, 0]) dxf_linear_extrude(file = "shape4.dxf", height = 2);
END
expect 0 "solids" info solid.csg --no-gl
prints "by openscad        2"
prints "bounds             0 0 0 to 4 8 2"
prints "kinds              openscad"

# Nowhere to write: no word about it.
rm -rf cache
CSGCAST_CACHE='' XDG_CACHE_HOME='' HOME=/nowhere expect 0 "an empty \$CSGCAST_CACHE" info a.csg --no-gl
says_nothing_new
(unset CSGCAST_CACHE HOME XDG_CACHE_HOME && "$csgcast" info a.csg --no-gl >out 2>err)
report $? "no home"
says_nothing_new
CSGCAST_CACHE=/proc/nowhere expect 0 "a folder that cannot be made" info a.csg --no-gl
says_nothing_new
(unset CSGCAST_CACHE && XDG_CACHE_HOME=$work/xdg "$csgcast" info a.csg --no-gl >out 2>err)
check "the XDG folder" test "$(entries xdg/csgcast)" = 1
(unset CSGCAST_CACHE && HOME=$work/home "$csgcast" info a.csg --no-gl >out 2>err)
check "the home folder" test "$(entries home/.cache/csgcast)" = 1

# Another font may be another outline; of what has no text it is not.
printf 'dxf_linear_extrude(file = "shape4.dxf", height = 2) { text(text = "A"); }\n' >text.csg
mkdir -p fonts
font=$(find /usr/share/fonts -name LiberationSans-Regular.ttf -print -quit)
expect 0 "no text" info a.csg --no-gl
expect 0 "a text" info text.csg --no-gl
expect 0 "the same text" info text.csg --no-gl
prints_way "from the cache"
cp "$font" fonts/mine.ttf
export OPENSCAD_FONT_PATH=$work/fonts
expect 0 "a text with another font about" info text.csg --no-gl
check "is not taken from the cache" test "$(grep -c 'from the cache' out)" = 0
expect 0 "the same text once more" info text.csg --no-gl
prints_way "from the cache"
touch -d '1 hour ago' fonts/mine.ttf
expect 0 "a text, the font another one" info text.csg --no-gl
check "is not taken from the cache either" test "$(grep -c 'from the cache' out)" = 0
expect 0 "no text, with these fonts" info a.csg --no-gl
prints_way "from the cache"
unset OPENSCAD_FONT_PATH
rm -rf cache

# csgcast cache
expect 0 "info fills it" info a.csg --no-gl
echo mine >cache/notes.txt
expect 0 "cache" cache
prints "path               $work/cache"
prints "entries            1"
expect 0 "cache for machines" cache --json
prints '"entries": 1'
expect 0 "another cache" cache --cache="$work/xdg/csgcast"
prints "entries            1"
expect 0 "clear" cache --clear
check "nothing of ours is left" test "$(entries cache)" = 0
check "what is not ours is" test -f cache/notes.txt
expect 0 "clear an empty one" cache --clear
expect 2 "a scene" cache a.csg
says "takes no scene"
finish
