#!/usr/bin/env node
// SPDX-License-Identifier: MIT
//
//     node coverage.mjs --out=DIR [option...] FOLDER_OR_FILE.scad...
//
// What of real files csgcast draws, whether it needs OpenSCAD's kernel for it, whether it agrees
// with OpenSCAD's mesh, and how soon the first picture is there. Every argument is a project; a
// folder's .scad files are found recursively. What was measured is kept in DIR, one file for each
// scene, and is not measured again while the scene and csgcast are the same: call it again to go
// on. Writes DIR/coverage.csv and DIR/coverage.md.
//
//   --csgcast=PROGRAM  --referee=PROGRAM   ./build/csgcast and ./build/tests/openscad/referee
//   --sample=N     at most N files of each folder, chosen by --seed=S (all; 1)
//   --seconds=N    CPU time that OpenSCAD's mesh may take, and csgcast's picture (60)
//   --jobs=N       scenes at a time (2)
//   --turns=N      pairs of timed runs; 0: none (3)
//   --steps=mesh,draw,agree,time  only these (all)
//   --table        only write the tables of what was measured before
//   --title=TEXT   heading of the Markdown page
//
// Needs openscad, xvfb, prlimit (util-linux).

import { spawn } from "node:child_process";
import { existsSync, mkdirSync, readdirSync, statSync } from "node:fs";
import { basename, join, resolve } from "node:path";
import { measure } from "./coverage_scene.mjs";
import { writeTables } from "./coverage_table.mjs";

const defaults = {
    out: null, csgcast: "build/csgcast", referee: "build/tests/openscad/referee", sample: Infinity,
    seed: 1, seconds: 60, jobs: 2, turns: 3, steps: "mesh,draw,agree,time", table: false,
    title: "Coverage of OpenSCAD files",
};

function parse(argv) {
    const options = { ...defaults, projects: [] };
    for (const word of argv) {
        const match = /^--([a-z]+)(?:=(.*))?$/s.exec(word);
        if (!match)
            options.projects.push(resolve(word));
        else if (!(match[1] in defaults))
            throw new Error(`unknown option ${word}`);
        else if (typeof defaults[match[1]] === "number")
            options[match[1]] = Number(match[2]);
        else
            options[match[1]] = match[2] ?? true;
    }
    if (!options.out || options.projects.length === 0)
        throw new Error("usage: node coverage.mjs --out=DIR [option...] FOLDER_OR_FILE.scad...");
    options.out = resolve(options.out);
    options.csgcast = resolve(options.csgcast);
    options.referee = resolve(options.referee);
    options.steps = options.steps.split(",");
    return options;
}

function findScenes(path) {
    const isScene = (name) => name.toLowerCase().endsWith(".scad");
    if (!statSync(path).isDirectory())
        return [path];
    return readdirSync(path, { recursive: true }).filter(isScene).map((name) => join(path, name))
        .filter((file) => statSync(file, { throwIfNoEntry: false })?.isFile()).sort();
}

// The splitmix32 sequence: the same sample on every machine.
function shuffle(items, seed) {
    let state = seed >>> 0;
    const next = () => {
        let z = (state = (state + 0x9e3779b9) >>> 0);
        z = Math.imul(z ^ (z >>> 16), 0x21f0aaad);
        z = Math.imul(z ^ (z >>> 15), 0x735a2d97);
        return ((z ^ (z >>> 15)) >>> 0) / 2 ** 32;
    };
    for (let i = items.length - 1; i > 0; i--) {
        const j = Math.floor(next() * (i + 1));
        [items[i], items[j]] = [items[j], items[i]];
    }
    return items;
}

function listScenes(options) {
    return options.projects.flatMap((path) => {
        const files = findScenes(path);
        const chosen = files.length > options.sample
            ? shuffle(files, options.seed).slice(0, options.sample).sort() : files;
        const root = statSync(path).isDirectory() ? path : resolve(path, "..");
        return chosen.map((file) => ({ file, project: basename(root), root }));
    });
}

// One X server for all of OpenSCAD's pictures; the first free number from 90 on.
async function startDisplay() {
    let number = 90;
    while (existsSync(`/tmp/.X11-unix/X${number}`) || existsSync(`/tmp/.X${number}-lock`))
        number++;
    const server = spawn("Xvfb", [`:${number}`, "-screen", "0", "1024x768x24"],
        { stdio: "ignore" });
    server.on("error", () => { throw new Error("Xvfb does not run (Debian: xvfb)"); });
    for (let i = 0; i < 100 && !existsSync(`/tmp/.X11-unix/X${number}`); i++)
        await new Promise((done) => setTimeout(done, 50));
    return { name: `:${number}`, stop: () => server.kill() };
}

async function measureAll(scenes, options) {
    const display = options.steps.includes("time") ? await startDisplay() : null;
    const queue = [...scenes.entries()];
    const results = [];
    const work = async () => {
        for (let next = queue.shift(); next; next = queue.shift()) {
            const [i, scene] = next;
            results[i] = await measure(scene, options, display?.name);
            const { mesh, draw, agree } = results[i];
            console.log(`${i + 1}/${scenes.length} ${scene.file}: mesh ${mesh?.result ?? "-"}, ` +
                `draw ${draw?.result ?? "-"}, agree ${agree?.result ?? "-"}`);
        }
    };
    await Promise.all(Array.from({ length: options.jobs }, work));
    display?.stop();
    return results;
}

async function main() {
    const options = parse(process.argv.slice(2));
    mkdirSync(join(options.out, "scenes"), { recursive: true });
    if (options.table)
        options.steps = [];
    const scenes = listScenes(options);
    const results = await measureAll(scenes, options);
    writeTables(results, options);
}

main().catch((error) => {
    console.error(`coverage.mjs: ${error.message}`);
    process.exitCode = 1;
});
