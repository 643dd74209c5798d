#!/usr/bin/env node
// SPDX-License-Identifier: MIT
//
//     node fuzz.mjs --out=DIR [option...] COUNT SEED
//
// COUNT random scenes (odd.mjs) from SEED on against OpenSCAD's meshes, as coverage.mjs compares
// them. Where OpenSCAD has nothing csgcast must show nothing. Scenes that differ or are not drawn
// are named and kept in DIR; exit status 1 if there is one.
//
//   --csgcast=PROGRAM  --referee=PROGRAM   ./build/csgcast and ./build/tests/openscad/referee
//   --seconds=N    CPU time that OpenSCAD's mesh may take, and csgcast's picture (20)
//   --jobs=N       scenes at a time (2)

import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { measure } from "./coverage_scene.mjs";
import { oddScene } from "./odd.mjs";

const defaults = {
    out: null, csgcast: "build/csgcast", referee: "build/tests/openscad/referee", seconds: 20,
    jobs: 2,
};

function parse(argv) {
    const options = { ...defaults, numbers: [], turns: 0, empty: true, steps: ["mesh", "draw", "agree"] };
    for (const word of argv) {
        const match = /^--([a-z]+)=(.*)$/s.exec(word);
        if (!match)
            options.numbers.push(Number(word));
        else if (match[1] in defaults)
            options[match[1]] = typeof defaults[match[1]] === "number" ? Number(match[2])
                : resolve(match[2]);
        else
            throw new Error(`unknown option ${word}`);
    }
    if (!options.out || options.numbers.length !== 2 || options.numbers.some(Number.isNaN))
        throw new Error("usage: node fuzz.mjs --out=DIR [option...] COUNT SEED");
    return options;
}

// What is wrong with a scene, or null.
function verdict({ mesh, draw, agree }) {
    if (mesh.result !== "ok" && mesh.result !== "empty")
        return null; // OpenSCAD has no mesh to compare with
    if (draw.result !== "ok")
        return `not drawn (${draw.result}): ${draw.reason ?? ""}`;
    if (agree.result !== "ok")
        return `${agree.result}: off ${agree.off}, depth ${agree.depth}, dz/r ${agree.error} ` +
            `${agree.reason ?? ""}`;
    return null;
}

async function main() {
    const options = parse(process.argv.slice(2));
    const [count, first] = options.numbers;
    const scenes = join(options.out, "odd");
    const sum = { ok: 0, empty: 0, other: 0, kernel: 0, wrong: 0 };
    mkdirSync(scenes, { recursive: true });
    mkdirSync(join(options.out, "scenes"), { recursive: true });
    let next = first;
    const work = async () => {
        while (next < first + count) {
            const seed = next++, file = join(scenes, `odd${seed}.scad`);
            writeFileSync(file, oddScene(seed));
            const result = await measure({ file, project: "odd", root: scenes }, options);
            const wrong = verdict(result);
            sum[result.mesh.result in sum ? result.mesh.result : "other"]++;
            sum.kernel += result.draw?.kernel > 0 ? 1 : 0;
            sum.wrong += wrong ? 1 : 0;
            if (wrong)
                console.log(`${file}: ${wrong}`);
            else
                rmSync(file);
        }
    };
    await Promise.all(Array.from({ length: options.jobs }, work));
    console.log(`${count} scenes: ${sum.ok} with a mesh, ${sum.empty} empty, ${sum.other} without ` +
        `a mesh; ${sum.kernel} needed OpenSCAD's kernel; ${sum.wrong} wrong`);
    process.exitCode = sum.wrong > 0 ? 1 : 0;
}

main().catch((error) => {
    console.error(`fuzz.mjs: ${error.message}`);
    process.exitCode = 1;
});
