// SPDX-License-Identifier: MIT
//
// Measures one scene for coverage.mjs. Each step has a result and what it was measured with; a step
// is repeated when that has changed.

import { createHash } from "node:crypto";
import { spawn } from "node:child_process";
import { existsSync, readFileSync, renameSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { performance } from "node:perf_hooks";

// Views of the referee: the bar of 2e-5 needs some 10^5 rays.
const views = ["--views=4", "--imgsize=256,192"];
const numRays = 4 * 256 * 192;
const depthBar = 1e-5; // of the scene's radius
const wrongBar = 2e-5; // of the rays
const cpuToWall = 8; // the machine may be busy with other things

const digest = (data) => createHash("sha256").update(data).digest("hex").slice(0, 16);

function run(program, args, { seconds, cwd, display } = {}) {
    return new Promise((done) => {
        const limited = ["--core=0", `--cpu=${seconds}`, program, ...args];
        const begun = performance.now();
        const child = spawn("prlimit", limited, {
            cwd, stdio: ["ignore", "pipe", "pipe"],
            env: { ...process.env, ...(display ? { DISPLAY: display } : {}) },
        });
        let out = "", err = "";
        child.stdout.on("data", (data) => { out = (out + data).slice(-200000); });
        child.stderr.on("data", (data) => { err = (err + data).slice(-200000); });
        const timer = setTimeout(() => child.kill("SIGKILL"), seconds * cpuToWall * 1000);
        child.on("close", (status, signal) => {
            clearTimeout(timer);
            done({ status, signal, out, err, ms: performance.now() - begun });
        });
    });
}

// ---- OpenSCAD's mesh -----------------------------------------------------------------------

// OpenSCAD 2021.01 leaves the normal out where two corners of a triangle are equal as floats: its
// record is 38 bytes long instead of 50. A true record's first three floats are a unit normal or
// zero, and its corners differ.
function readTriangle(data, at) {
    const corner = (i) => [0, 4, 8].map((k) => data.readFloatLE(at + 12 * i + k));
    const same = (p, q) => p.every((x, i) => x === q[i]);
    const isDegenerate = (p) => same(p[0], p[1]) || same(p[0], p[2]) || same(p[1], p[2]);
    if (at + 50 <= data.length) {
        const normal = corner(0), p = [corner(1), corner(2), corner(3)];
        const length = Math.hypot(...normal);
        if ((length === 0 || Math.abs(length - 1) < 1e-4) && !isDegenerate(p))
            return { size: 50, corners: p };
    }
    return { size: 38, corners: null };
}

function asciiFromBinary(data) {
    const lines = ["solid mesh"];
    for (let at = 84; at + 38 <= data.length;) {
        const { size, corners } = readTriangle(data, at);
        for (const p of corners ?? [])
            lines.push(`vertex ${p.map((x) => x.toPrecision(9)).join(" ")}`);
        at += size;
    }
    return lines.concat("endsolid mesh", "").join("\n");
}

function judgeMesh(result, stl) {
    if (result.signal || result.status === 137 || result.status === 152)
        return "timeout";
    if (/not a 3D object/.test(result.err))
        return "2d";
    if (/^ERROR:|CGAL error/m.test(result.err))
        return "error";
    if (/top level object is empty/i.test(result.err))
        return "empty";
    if (result.status !== 0 || !existsSync(stl))
        return "error";
    return "ok";
}

// Whether two readings of the file differ: it uses rands() without a seed.
async function isRandom(scene, stem, options) {
    const texts = [];
    for (let i = 0; i < 2; i++) {
        const csg = `${stem}.${i}.csg`;
        await run("openscad", ["-o", csg, scene.file],
            { seconds: options.seconds, cwd: dirname(scene.file) });
        texts.push(existsSync(csg) ? digest(readFileSync(csg)) : "");
        rmSync(csg, { force: true });
    }
    return texts[0] !== texts[1];
}

async function makeMesh(scene, stem, options) {
    const stl = `${stem}.stl`, binary = `${stl}.binary`;
    rmSync(binary, { force: true });
    const result = await run("openscad", ["-o", binary, "--export-format=binstl", scene.file],
        { seconds: options.seconds, cwd: dirname(scene.file) });
    const mesh = { result: judgeMesh(result, binary), seconds: result.ms / 1000 };
    if (mesh.result === "ok")
        writeFileSync(stl, asciiFromBinary(readFileSync(binary)));
    rmSync(binary, { force: true });
    if (mesh.result === "ok" && await isRandom(scene, stem, options)) {
        mesh.result = "random";
    } else if (mesh.result === "empty") {
        writeFileSync(stl, "solid empty\nendsolid empty\n");
    } else if (mesh.result === "error") {
        mesh.reason = result.err.split("\n").find((line) => /ERROR|CGAL|rror/.test(line)) ?? "";
    }
    return mesh;
}

// ---- csgcast -------------------------------------------------------------------------------

const firstError = (text) => text.split("\n").find((line) => /error/.test(line)) ?? "";

async function draw(scene, stem, options) {
    const limits = { seconds: options.seconds, cwd: dirname(scene.file) };
    const picture = await run(options.csgcast, ["render", scene.file, "-o", `${stem}.png`, "-q",
        "--render"], limits);
    if (picture.status !== 0)
        return {
            result: picture.signal || picture.status === null ? "timeout" : "error",
            reason: firstError(picture.err).replaceAll(`${scene.root}/`, ""),
        };
    const info = await run(options.csgcast, ["info", scene.file, "--json", "--no-gl", "-q",
        "--render"], limits);
    if (info.status !== 0)
        return { result: "error", reason: `csgcast info: ${firstError(info.err)}` };
    const counts = JSON.parse(info.out);
    return {
        result: "ok", leaves: counts.leaves, exact: counts.exact, facetted: counts.facetted,
        kernel: counts.handed_off ?? 0, reasons: [...new Set((counts.ways ?? [])
            .filter((way) => way.way === "openscad").map((way) => way.reason))],
    };
}

function sumViews(text) {
    const sum = { hits: 0, off: 0, depth: 0, edge: 0, edges: 0, thin: 0, error: 0, views: 0 };
    for (const line of text.split("\n")) {
        const match = /hits (\d+) edge (\d+)\/(\d+) thin (\d+) off (\d+) depth (\d+).*dz\/r (\S+)/
            .exec(line);
        if (!match)
            continue;
        const [hits, edge, edges, thin, off, depth, error] = match.slice(1).map(Number);
        sum.hits += hits;
        sum.edge += edge;
        sum.edges += edges;
        sum.thin += thin;
        sum.off += off;
        sum.depth += depth;
        sum.error = Math.max(sum.error, error);
        sum.views++;
    }
    return sum;
}

async function agree(scene, stem, options) {
    const seed = parseInt(digest(relative(scene.root, scene.file)).slice(0, 4), 16);
    const result = await run(options.referee, ["--name=" + stem, "--facets=as-written", "--render",
        `--depth-of-radius=${depthBar}`, `--seed=${seed}`, ...views, scene.file, `${stem}.stl`],
    { seconds: 4 * options.seconds, cwd: dirname(scene.file) });
    const sum = sumViews(result.out);
    const wrong = sum.off + sum.depth;
    if (sum.views < 4)
        return { result: "error", reason: firstError(result.err) || `exit status ${result.status}` };
    return { result: wrong <= wrongBar * numRays ? "ok" : "differs", ...sum };
}

// ---- the first picture ---------------------------------------------------------------------

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

// In turns, so that whatever else the machine does meets both alike. One run of each warms caches.
async function time(scene, stem, options, display) {
    const ours = [], theirs = [];
    const limits = { seconds: options.seconds, cwd: dirname(scene.file), display };
    for (let i = 0; i <= options.turns; i++) {
        const a = await run(options.csgcast, ["render", scene.file, "-o", `${stem}.png`, "-q"],
            limits);
        const b = await run("openscad", ["-o", `${stem}.openscad.png`, scene.file], limits);
        if (a.status !== 0)
            return { result: "error" };
        if (i > 0) {
            ours.push(a.ms);
            theirs.push(b.status === 0 ? b.ms : Infinity);
        }
    }
    const theirMedian = median(theirs);
    return {
        result: "ok", csgcast: median(ours),
        openscad: Number.isFinite(theirMedian) ? theirMedian : null,
    };
}

// ---- all of it -----------------------------------------------------------------------------

function stampOf(program) {
    const info = existsSync(program) ? statSync(program) : { size: 0, mtimeMs: 0 };
    return `${info.size} ${info.mtimeMs}`;
}

function load(path, scene) {
    const fresh = { file: relative(scene.root, scene.file), project: scene.project };
    const known = existsSync(path) ? JSON.parse(readFileSync(path)) : {};
    return { ...known, ...fresh };
}

function save(path, result) {
    writeFileSync(`${path}.unfinished`, JSON.stringify(result));
    renameSync(`${path}.unfinished`, path);
}

// display: of the X server for the step "time". options.empty: also draw what has no mesh because it
// is empty.
export async function measure(scene, options, display) {
    const stem = join(options.out, "scenes", digest(scene.file));
    const content = digest(readFileSync(scene.file));
    const programs = digest(stampOf(options.csgcast) + stampOf(options.referee));
    const result = load(`${stem}.json`, scene);
    const step = async (name, key, action) => {
        if (!options.steps.includes(name) || result[name]?.key === key)
            return;
        result[name] = { ...(await action()), key };
        save(`${stem}.json`, result);
    };
    await step("mesh", content, () => makeMesh(scene, stem, options));
    if (result.mesh?.result !== "ok" && !(options.empty && result.mesh?.result === "empty"))
        return result;
    await step("draw", content + programs, () => draw(scene, stem, options));
    if (result.draw?.result !== "ok")
        return result;
    await step("agree", content + programs, () => agree(scene, stem, options));
    if (options.turns > 0)
        await step("time", content + programs, () => time(scene, stem, options, display));
    return result;
}
