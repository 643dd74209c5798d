#!/bin/sh
# SPDX-License-Identifier: MIT
#
#   first_picture.sh SCENE.scad: tests/openscad/first_picture measures it; no figure is looked at.

set -eu
"$(dirname "$0")/first_picture" --rounds=1 "$1" | awk -F, '
    NR == 1 { next }
    NF == 7 && $2 > 0 && $3 > 0 && $4 > 0 && $5 > 0 && $6 > 0 && $7 > 0 { good++ }
    { print }
    END { exit good != 1 }'
