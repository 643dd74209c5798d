// SPDX-License-Identifier: MIT
//
// The tables of coverage.mjs: a CSV with every figure, a Markdown page with the sums.

import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";

const columns = ["project", "file", "mesh", "mesh_s", "draw", "leaves", "exact", "facetted",
    "kernel", "agree", "hits", "off", "depth", "dz_of_radius", "csgcast_ms", "openscad_ms",
    "reason"];

const round = (x, digits) => x === undefined || x === null ? "" : Number(x).toPrecision(digits);

function rowOf({ project, file, mesh = {}, draw = {}, agree = {}, time = {} }) {
    return {
        project, file, mesh: mesh.result, mesh_s: round(mesh.seconds, 3), draw: draw.result,
        leaves: draw.leaves, exact: draw.exact, facetted: draw.facetted, kernel: draw.kernel,
        agree: agree.result, hits: agree.hits, off: agree.off, depth: agree.depth,
        dz_of_radius: round(agree.error, 2), csgcast_ms: round(time.csgcast, 3),
        openscad_ms: round(time.openscad, 3),
        reason: draw.reason ?? agree.reason ?? draw.reasons?.join("; ") ?? mesh.reason,
    };
}

function csv(rows) {
    const quote = (value) => `"${String(value ?? "").replaceAll('"', '""')}"`;
    return [columns, ...rows.map((row) => columns.map((name) => row[name]))]
        .map((cells) => cells.map(quote).join(",")).join("\n") + "\n";
}

const percent = (part, whole) => whole ? `${(100 * part / whole).toFixed(1)} %` : "-";

function median(values) {
    const sorted = values.sort((a, b) => a - b);
    return sorted.length ? sorted[sorted.length >> 1] : NaN;
}

function summary(rows) {
    const meshed = rows.filter((row) => row.mesh === "ok");
    const drawn = meshed.filter((row) => row.draw === "ok");
    const native = drawn.filter((row) => !row.kernel);
    const compared = drawn.filter((row) => row.agree);
    const agreeing = compared.filter((row) => row.agree === "ok");
    const timed = native.filter((row) => row.csgcast_ms && row.openscad_ms);
    const sooner = timed.filter((row) => Number(row.csgcast_ms) < Number(row.openscad_ms));
    const ratio = median(timed.map((row) => row.openscad_ms / row.csgcast_ms));
    const without = (name) => rows.filter((row) => row.mesh === name).length;
    return `| | |
| --- | --- |
| files | ${rows.length} |
| without a mesh by OpenSCAD: empty, 2D, error, out of time, random | \
${without("empty")}, ${without("2d")}, ${without("error")}, ${without("timeout")}, \
${without("random")} |
| meshed by OpenSCAD | ${meshed.length} |
| of these drawn by csgcast | ${drawn.length} (${percent(drawn.length, meshed.length)}) |
| of these without OpenSCAD's kernel | ${native.length} \
(${percent(native.length, meshed.length)}) |
| agree with the mesh | ${agreeing.length} of ${compared.length} |
${timed.length === 0 ? "" : `| drawn without the kernel: first picture sooner than OpenSCAD's \
preview | ${sooner.length} of ${timed.length}; time of OpenSCAD / csgcast ${round(ratio, 3)} at the \
median |
`}`;
}

const fileColumns = ["file", "mesh_s", "draw", "leaves", "kernel", "agree", "off", "depth",
    "dz_of_radius", "csgcast_ms", "openscad_ms"];

function projectTable(project, rows) {
    const cell = (value) => String(value ?? "").replaceAll("|", "\\|");
    const lines = rows.filter((row) => row.project === project && row.mesh === "ok")
        .map((row) => `| ${fileColumns.map((name) => cell(row[name])).join(" | ")} |`);
    if (lines.length === 0)
        return "";
    return `### ${project}\n\n| ${fileColumns.join(" | ")} |\n|${" --- |".repeat(fileColumns.length)}
${lines.join("\n")}\n`;
}

function reasons(rows) {
    const count = new Map();
    for (const row of rows)
        if (row.mesh === "ok" && row.reason)
            count.set(`${row.draw === "ok" ? "kernel" : "not drawn"}: ${row.reason}`,
                (count.get(row.reason) ?? 0) + 1);
    return [...count].map(([text, number]) => `* ${number > 1 ? `${number} times ` : ""}${text}`)
        .join("\n");
}

function page(rows, options) {
    const said = spawnSync("openscad", ["--version"], { encoding: "utf8" });
    const version = `${said.stdout ?? ""}${said.stderr ?? ""}`.trim();
    const projects = [...new Set(rows.map((row) => row.project))];
    return `# ${options.title}

Made by \`tests/openscad/coverage.mjs\`, which says what is measured. ${version || "OpenSCAD"}; \
${options.seconds} s of CPU time for a mesh.

${summary(rows)}
Agreement is that of 4 random views of 256x192 rays with OpenSCAD's own mesh (float vertices) in
\`--facets=as-written\`: off silhouettes at most 2e-5 of the rays wrong; wrong is a hit instead of a
miss or a depth that is off by more than 1e-5 of the scene's radius (more only where a surface is
seen edge-on: 2e-6 of the largest coordinate along its normal). Times are medians of ${options.turns} whole processes in turns, 512x512 pixels, in ms.

${reasons(rows) ? `## What was not drawn, or needed OpenSCAD's kernel\n\n${reasons(rows)}\n` : ""}
## Files that OpenSCAD meshes

${projects.map((project) => projectTable(project, rows)).filter(Boolean).join("\n")}`;
}

export function writeTables(results, options) {
    const rows = results.map(rowOf);
    writeFileSync(join(options.out, "coverage.csv"), csv(rows));
    writeFileSync(join(options.out, "coverage.md"), page(rows, options));
    console.log(summary(rows));
}
