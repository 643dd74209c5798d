// SPDX-License-Identifier: MIT
//
//     node sagitta.mjs exact|auto SCENE.csg
//
// Prints how far OpenSCAD's facets may be from the true surface anywhere in the scene: the largest
// r (1 - cos(pi / n)) of its cylinders, circles and spheres, times the stretch of the maps around
// them. A sphere's quads are curved both ways and count twice. With auto, solids with an explicit
// $fn of at most 12 are polygons and do not count. Prints 0 when there is nothing round.

import { readFileSync } from "node:fs";

function fragments(r, fn, fa, fs) {
    if (fn > 0)
        return Math.max(Math.trunc(fn), 3);
    return Math.ceil(Math.max(Math.min(360 / fa, 2 * Math.PI * r / fs), 5));
}

function argument(line, name) {
    const match = line.match(new RegExp(`[(, ]\\$?${name} = ([-+.0-9e]+)`));
    return match ? Number(match[1]) : 0;
}

// At least the largest singular value: the Frobenius norm would count a mere rotation as sqrt 3.
function stretch(matrix) {
    const gram = [0, 1, 2].map((i) => [0, 1, 2].map((j) =>
        matrix[0][i] * matrix[0][j] + matrix[1][i] * matrix[1][j] + matrix[2][i] * matrix[2][j]));
    return Math.sqrt(Math.max(...gram.map((row) =>
        row.reduce((sum, value) => sum + Math.abs(value), 0))));
}

function sagittaOf(line, facets) {
    const [, name] = line.match(/^[%#\s]*(\w+)\(/) ?? [];
    if (!["sphere", "cylinder", "circle"].includes(name))
        return 0;
    const r = Math.max(argument(line, "r"), argument(line, "r1"), argument(line, "r2"), 0);
    const fn = argument(line, "fn");
    if (facets === "auto" && fn > 0 && fn < 13)
        return 0;
    const n = fragments(r, fn, argument(line, "fa"), argument(line, "fs"));
    return (name === "sphere" ? 2 : 1) * r * (1 - Math.cos(Math.PI / n));
}

function main(facets, path) {
    const scales = [1]; // of the blocks around the line
    let sagitta = 0;
    for (const line of readFileSync(path, "utf8").split("\n")) {
        const matrix = line.match(/multmatrix\((.*)\)/);
        const around = scales[scales.length - 1];
        if (line.endsWith("{"))
            scales.push(matrix ? around * stretch(JSON.parse(matrix[1])) : around);
        else if (line.trim() === "}")
            scales.pop();
        else
            sagitta = Math.max(sagitta, around * sagittaOf(line, facets));
    }
    console.log(sagitta.toPrecision(6));
}

main(...process.argv.slice(2));
