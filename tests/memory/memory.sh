#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   memory.sh CSGCAST FAIL: an allocation fails, a different one in each run. Either csgcast says
#   that memory is out, or it does without and the result is the same.

csgcast=$(readlink -f "$1")
fail=$(readlink -f "$2")
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$(readlink -f "$0")")/../cli/checks.sh"
num_runs=15

cat >small.csg <<'END'
difference() {
    cube([20, 20, 6], center = true);
    cylinder(h = 20, r = 4, center = true);
}
END
for ((i = 0; i < 400; i++)); do
    echo "multmatrix([[1,0,0,$((i % 20 * 3))],[0,1,0,$((i / 20 * 3))],[0,0,1,0],[0,0,0,1]]) sphere(r = 2);"
done >crowd.csg
{
    echo 'difference() { cube([100, 100, 5]);'
    for ((i = 0; i < 64; i++)); do
        echo "multmatrix([[1,0,0,$((i % 8 * 12 + 6))],[0,1,0,$((i / 8 * 12 + 6))],[0,0,1,-1],[0,0,0,1]])"
        echo 'cylinder(h = 10, r = 4);'
    done
    echo '}'
} >plate.csg
cat >mixed.csg <<'END'
linear_extrude(height = 3, twist = 40, slices = 9) difference() { square(4, center = true); circle(1); }
rotate_extrude() polygon(points = [[7, 0], [9, 0], [9, 3]], paths = undef);
hull() { sphere(r = 1); multmatrix([[1,0,0,-9],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) cube(2); }
color([1, 0, 0, 0.5]) minkowski() { cube([2, 3, 4]); sphere(r = 1); }
linear_extrude(height = 1) offset(r = 1) polygon(points = [[0, 0], [9, 0], [0, 9]], paths = undef);
polyhedron(points = [[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9]],
           faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]);
resize(newsize = [10, 0, 0]) cylinder(h = 3, r1 = 1, r2 = 2, $fn = 9);
END

# call NUMBER ARGS...: the allocation of that number fails; 0: none does.
call()
{
    local number=$1
    shift
    rm -f result
    FAIL_AT=$number FAIL_COUNT=$work/count LD_LIBRARY_PATH=$(dirname "$fail") \
        LD_PRELOAD=$(basename "$fail") "$csgcast" "$@" >out 2>err
}

# holds STATUS: what may happen has happened.
holds()
{
    if [[ $1 -eq 0 ]]; then
        cmp -s result expected && cmp -s out expected.out
    else
        [[ $1 -le 3 && ! -e result ]] && grep -q 'csgcast: error: .*memory' err
    fi
}

# try NAME ARGS...
try()
{
    local name=$1 total status wrong=0
    shift
    call 0 "$@" || cat err
    total=$(<count)
    touch result
    cp result expected
    cp out expected.out
    for ((i = 0; i < num_runs; i++)); do
        call $((1 + i * total / num_runs)) "$@"
        status=$?
        [[ $status -ne 0 || -e result ]] || touch result
        if ! holds "$status"; then
            echo "allocation $((1 + i * total / num_runs)) of $total: exit $status"
            cat err
            wrong=$((wrong + 1))
        fi
    done
    check "$name: $total allocations" test "$total" -gt "$num_runs" -a "$wrong" -eq 0
}

picture=(-o result --format=png --imgsize=32,32)
try "small" render small.csg "${picture[@]}" --backend=egl
try "small, without OpenGL" render small.csg "${picture[@]}" --backend=reference
try "crowd" render crowd.csg "${picture[@]}" --backend=egl
try "plate" render plate.csg "${picture[@]}" --backend=egl
try "mixed" info mixed.csg --no-gl
try "mixed, as written" info mixed.csg --no-gl --facets=as-written
try "export" export mixed.csg -o result --format=pov

finish
