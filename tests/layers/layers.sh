#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   layers.sh SOURCE_DIR
#
# A folder of src needs those above it in the table of docs/pipeline.md and its neighbours in a row.
# Tells each include that goes the other way, each folder that the table does not have, and each
# GL header outside of gl.

set -euo pipefail
cd "$1"

# "folder row" for each folder of the table.
rows()
{
    awk -F'|' '/^## / { in_table = ($0 == "## Folders") }
               in_table && NF > 3 {
                   row++
                   while (match($2, /`[a-z]+`/)) {
                       print substr($2, RSTART + 1, RLENGTH - 2), row
                       $2 = substr($2, RSTART + RLENGTH)
                   }
               }' docs/pipeline.md
}

# "src/folder/file:line header" for each include.
includes()
{
    grep -rnoE --include='*.c' --include='*.h' --include='*.cpp' '#include ["<][^">]+' src |
        sed -E 's/:#include ["<]/ /'
}

# Words of an include are file and header, those of a row folder and number.
awk 'FNR == NR { row[$1] = $2; next }
     { split($1, from, "/"); split($2, to, "/"); num++ }
     from[2] == "include" { next }
     !(from[2] in row) { print $1 ": the table has no " from[2]; bad++ }
     row[to[1]] > row[from[2]] { print $1 ": " from[2] " is below " to[1] ", not above"; bad++ }
     to[1] ~ /^(E?GL|KHR)$/ && from[2] != "gl" && $2 != "GL/glu.h" {
         print $1 ": only gl has a GL header"; bad++
     }
     END {
         print num " includes, " bad + 0 " against the table of docs/pipeline.md"
         exit bad || num < 1000
     }' <(rows) <(includes)
