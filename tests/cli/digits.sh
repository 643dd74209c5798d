#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# digits.sh CSGCAST: the numbers of .scad files, with all their digits or with OpenSCAD's six.

csgcast=$(readlink -f "$1")
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$(readlink -f "$0")")/checks.sh"
unset OPENSCAD LD_PRELOAD CSGCAST_DIGITS CSGCAST_DIGITS_MODULE
openscad=$(command -v openscad) || { echo "FAIL openscad is not installed"; exit 1; }

# number KEY [INDEX]: from the last info --json.
number()
{
    node -e '
        const value = JSON.parse(require("fs").readFileSync("out", "utf8"))[process.argv[1]];
        console.log(process.argv[2] === undefined ? value : value[process.argv[2]]);' "$@"
}

is()
{
    local found
    found=$(number "${@:2}")
    [[ $found == "$1" ]]
    report $? "${*:2} is $found, not $1"
}

# info NAME FILE: the same six or all digits, for machines.
all()
{
    expect 0 "$1: all digits" info --json --no-gl "$2"
}

six()
{
    CSGCAST_DIGITS_MODULE=none expect 0 "$1: six digits" info --json --no-gl "$2"
}

# Both of OpenSCAD's ways to print a number: a size and a matrix.
cat >far.scad <<END
echo(str(1 / 3), 1 / 3, 2.0000001);
assert(str(2 / 3) == "0.666667");
translate([100000 / 3, 1 / 7, 0]) cube([1 / 3, 1, 1.23456789]);
END
all "far" far.scad
says 'ECHO: "0.333333", 0.333333, 2'
is 0 rounded
is 33333.333333333336 lo 0
is 1.23456789 hi 2
six "far" far.scad
is 33333.3 lo 0
is 4 rounded

# A scene that one of the two ways prints, without a size or a matrix.
cat >points.scad <<END
polyhedron([[0, 0, 0], [1 / 3, 0, 0], [0, 1e7 + 1 / 3, 0], [0, 0, 0.1]],
           [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]);
END
all "points" points.scad
is 0 rounded
is 0.3333333333333333 hi 0
is 10000000.333333334 hi 1
is 0.1 hi 2

# Thirds are flush, as they were; what is a gap stays one where no number is rounded.
cat >flush.scad <<END
difference() { cube([1, 1, 1 / 3]); translate([0.25, 0.25, -1]) cube([0.5, 0.5, 4 / 3]); }
END
cat >gap.scad <<END
difference() { cube([1, 1, 1 / 3]); translate([0.25, 0.25, -1]) cube([0.5, 0.5, 4 / 3 - 1e-8]); }
END
cat >typed.scad <<END
difference() { cube([1, 1, 0.33333]); translate([0.25, 0.25, -1]) cube([0.5, 0.5, 1.333332]); }
END
for scene in flush gap typed; do
    all $scene $scene.scad
    is "$([[ $scene == flush ]] && echo 1 || echo 0)" shared
    six $scene $scene.scad
    is 1 shared
done

# What differs by the rounding of its computation only is the same: cylinders, even scales, no twist.
cat >same.scad <<END
a = 0.1 + 0.2;
difference() { cylinder(r = 0.3, h = 1); translate([0, 0, -1]) cylinder(r1 = 0.3, r2 = a, h = 3); }
translate([9, 0]) linear_extrude(1, scale = [a / 0.3, 1], twist = a - 0.3) circle(1);
translate([18, 0]) linear_extrude(1, scale = [a, 0.3]) circle(1);
END
all same same.scad
is 4 leaves
is 4 exact
is 3 quadrics
is 0 facetted
is 0 triangles

# Right angles are exact, others as good as a double.
echo 'rotate([90, 0, 90]) cube([1 / 3, 2, 3]); rotate([0, 0, 30]) cube([0.1, 0.1, 1 / 3]);' >turned.scad
all "turned" turned.scad
is 3 hi 0
is 0.3333333333333333 hi 1
is 2 hi 2

# What is no usual number is as it was.
cat >odd.scad <<END
x = [1e300, 1e-320, -0, 5e-324, 1.7976931348623157e308, 123456789, 1e21, 1e22, 0.1 + 0.2, 1e-7];
for (i = x) cube([1, 1, 1 + 1 / (1 + abs(i))]);
multmatrix([[1, 0, 0, -0], [0, 1, 0, 1e-320], [0, 0, 1, 1e-7]]) cylinder(r = 1e22, h = 1e300);
translate([0 / 0, 1, 1]) cube(1);
translate([1, 2, 3]) { cube(1 / 0); sphere(0 / 0); cylinder(h = -1 / 0); linear_extrude(1 / 0) square(1); }
multmatrix([[0 / 0, 0, 0, 1]]) cube(1);
END
all "odd" odd.scad
cp err err.all
cp out out.all
six "odd" odd.scad
check "the same messages" cmp err err.all
for key in leaves dropped; do
    is "$(node -p "JSON.parse(fs.readFileSync('out.all')).$key")" $key
done

# The module may be anywhere, with a blank or a colon in its name.
mkdir -p "with blank" with:colon broken
for folder in "with blank" with:colon; do
    cp "$(dirname "$csgcast")/csgcast-digits.so" "$folder/"
    CSGCAST_DIGITS_MODULE=$work/$folder/csgcast-digits.so all "$folder" gap.scad
    is 0 rounded
done

# Without it, where nothing can stand for such a name, and with what cannot be loaded, all is as
# OpenSCAD has it, without a word.
TMPDIR="$work/with blank" CSGCAST_DIGITS_MODULE="$work/with blank/csgcast-digits.so" \
    expect 0 "blanks everywhere" info --json --no-gl gap.scad
is_silent
is 2 rounded
echo "no library" >broken/csgcast-digits.so
for module in broken/csgcast-digits.so missing.so; do
    CSGCAST_DIGITS_MODULE=$work/$module expect 0 "$module" info --json --no-gl gap.scad
    is_silent
    is 2 rounded
done

# What is preloaded already still is; an openscad that does not stand ours gets none.
cat >tells <<END
#!/bin/sh
echo "ECHO: \$LD_PRELOAD"
exec env LD_PRELOAD= "$openscad" "\$@"
END
cat >dies <<END
#!/bin/sh
[ -z "\$LD_PRELOAD" ] || kill -SEGV \$\$
exec "$openscad" "\$@"
END
cat >refuses <<END
#!/bin/sh
case \$LD_PRELOAD in *csgcast-digits.so) echo "no \$LD_PRELOAD" >&2; exit 1;; esac
exec "$openscad" "\$@"
END
chmod +x tells dies refuses
libm=$(ldd "$openscad" | sed -n 's/.*=> \(.*libm\.so[^ ]*\).*/\1/p')
LD_PRELOAD=$libm expect 0 "something preloaded" info --json --no-gl --openscad=./tells gap.scad
says "ECHO: $libm:/"
for wrapper in dies refuses; do
    expect 0 "a wrapper that $wrapper" info --json --no-gl --openscad=./$wrapper gap.scad
    is_silent
    is 2 rounded
done

# The frames of an animation are evaluated and written in turns.
cat >turning.scad <<'END'
rotate([0, 0, 100 / 3 * $t]) cube([1 / 3, 1, str(1 / 3 + $t) == "0.666667" ? 7 : 1]);
END
mkdir frames
CSGCAST_DIGITS=$work/frames LD_LIBRARY_PATH=$(dirname "$csgcast") LD_PRELOAD=csgcast-digits.so \
    openscad --animate 3 -o "$work/frames/x.csg" turning.scad >/dev/null 2>&1
check "three frames" test "$(cat frames/*.csg | grep -c "^// all digits")" = 3
check "str() in the second" grep -q "size = \[0.3333333333333333[0-9]*, 1, 7\]" frames/x00001.csg

# The last line of a text says that its numbers are as they stand, in edits too.
cat >marked.csg <<END
difference() {
	cube(size = [1, 1, 0.333334]);
	multmatrix([[1, 0, 0, 0.25], [0, 1, 0, 0.25], [0, 0, 1, -1]]) cube(size = [0.5, 0.5, 1.33333]);
}
// all digits
END
expect 0 "a marked text" info --json --no-gl marked.csg
is 0 rounded
is 0 shared
sed '$d' marked.csg >unmarked.csg
expect 0 "without the mark" info --json --no-gl unmarked.csg
is 2 rounded
is 1 shared

finish
