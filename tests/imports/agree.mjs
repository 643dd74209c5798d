// SPDX-License-Identifier: MIT
//
//   node agree.mjs OUTLINE FILE... [OPTION...]
//
// Whether a drawing in a file has the same corners in csgcast (outline.c, whose options these are)
// and in the openscad in the path, to the six digits that it writes.

import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync, existsSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const names = { x: null, y: null, scale: 'scale', fn: '$fn', fa: '$fa', fs: '$fs', dpi: 'dpi' };

function scadArguments(options) {
    const at = { x: 0, y: 0 };
    const list = [];
    for (const option of options) {
        const [name, value] = option.split('=');
        if (name === 'center')
            list.push('center = true');
        else if (name === 'layer')
            list.push(`layer = ${JSON.stringify(value)}`);
        else if (name in at)
            at[name] = value;
        else
            list.push(`${names[name]} = ${value}`);
    }
    return [`origin = [${at.x}, ${at.y}]`, ...list].join(', ');
}

// Corners that OpenSCAD 2021.01 exports.
function openscadPoints(file, options) {
    const folder = mkdtempSync(join(tmpdir(), 'agree-'));
    const scad = join(folder, 'a.scad'), svg = join(folder, 'a.svg');
    writeFileSync(scad, `import(${JSON.stringify(resolve(file))}, ${scadArguments(options)});\n`);
    const run = spawnSync('openscad', ['-o', svg, scad], { encoding: 'utf8' });
    const text = existsSync(svg) ? readFileSync(svg, 'utf8') : '';
    rmSync(folder, { recursive: true });
    if (run.error)
        throw new Error(`openscad: ${run.error.message} (Debian: apt-get install openscad)`);
    if (process.env.VERBOSE)
        process.stderr.write(run.stderr);
    return [...text.matchAll(/[ML] (\S+?),(\S+)/g)].map(([, x, y]) => [Number(x), -Number(y)]);
}

function csgcastPoints(outline, file, options) {
    const text = execFileSync(outline, [file, ...options],
        { encoding: 'utf8', maxBuffer: 1 << 28,
            stdio: ['ignore', 'pipe', process.env.VERBOSE ? 'inherit' : 'ignore'] });
    return text.split('\n').filter((line) => line).map((line) => line.split(' ').map(Number));
}

// What of a has no partner in b, each of which is taken once.
function unmatched(a, b) {
    const size = [...a, ...b].reduce((most, [x, y]) => Math.max(most, Math.abs(x), Math.abs(y)), 1e-3);
    const tolerance = 6e-6 * size;
    const left = [...b].sort((p, q) => p[0] - q[0]);
    const used = new Array(left.length).fill(false);
    const rest = [];
    for (const [x, y] of a) {
        let low = 0, high = left.length;
        while (low < high) {
            const middle = (low + high) >> 1;
            if (left[middle][0] < x - tolerance) low = middle + 1; else high = middle;
        }
        let best = -1, bestDistance = tolerance;
        for (let i = low; i < left.length && left[i][0] <= x + tolerance; i++) {
            const distance = Math.max(Math.abs(left[i][0] - x), Math.abs(left[i][1] - y));
            if (!used[i] && distance <= bestDistance) {
                best = i;
                bestDistance = distance;
            }
        }
        if (best >= 0) used[best] = true; else rest.push([x, y]);
    }
    return rest;
}

// Prints what differs and returns whether nothing does.
export function agrees(outline, file, options, label = file) {
    const theirs = openscadPoints(file, options), ours = csgcastPoints(outline, file, options);
    const missing = unmatched(theirs, ours);
    const ok = missing.length === 0 && theirs.length === ours.length;
    if (!ok || process.env.VERBOSE)
        console.log(`${ok ? 'ok  ' : 'FAIL'} ${[label, ...options].join(' ')}: ${theirs.length} ` +
            `corners by OpenSCAD, ${ours.length} by csgcast, ${missing.length} differ ` +
            missing.slice(0, 3).join(' | '));
    return { ok, num: theirs.length };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    const [outline, ...rest] = process.argv.slice(2);
    const files = rest.filter((word) => existsSync(word));
    const options = rest.filter((word) => !existsSync(word));
    const results = files.map((file) => agrees(outline, file, options));
    const num = results.filter((result) => result.ok).length;
    console.log(`${num} of ${files.length} files agree`);
    process.exit(num === files.length && num > 0 ? 0 : 1);
}
