#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   smoke.sh OUTDIR: the benchmark itself works: csgcast is measured in every case, and the peers
#   that are there show the same picture.

set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
rm -rf "$1"
"$here/run" --quick "$1" five plate blow flake edit curve
for name in five plate10 blow4 flake2 curve100; do
    grep -q "^$name,csgcast,frame_ms,[0-9]" "$1/results.csv" || {
        echo "FAIL: no time of $name"
        exit 1
    }
done
for row in five,hand-written flake2,mesh-16x8 five,povray flake2,embree flake2,tachyon; do
    awk -F, -v row="$row" '$1 "," $2 == row && $3 == "frame_ms" { found = 1; good = $8 > 0.9 }
        END { exit !(found && good) }' "$1/results.csv" || {
        echo "FAIL: $row was not measured, or shows something else"
        exit 1
    }
done
