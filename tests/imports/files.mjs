// SPDX-License-Identifier: MIT
//
//   node files.mjs dxf|svg OUTLINE COUNT SEED
//   node files.mjs dxf|svg|amf OUTLINE COUNT SEED broken
//
// Random files: whether csgcast and OpenSCAD read the same from them. broken: of files with bytes
// changed, cut out or repeated, whether csgcast reads them or says no, soon.

import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { agrees } from './agree.mjs';
import { random } from './random.mjs';

const [kind, outline, count, seed, mode] = process.argv.slice(2);
const { make } = await import(`./${kind}_file.mjs`);
const r = random(Number(seed));
const longestRun = 20000; // ms, on a busy machine with sanitizers

function breakIn(bytes) {
    const at = r.integer(0, bytes.length - 1), num = r.integer(1, 40);
    const rest = [bytes.subarray(0, at), bytes.subarray(at)];
    return r.pick([
        () => rest[0],
        () => Buffer.concat([rest[0], rest[1].subarray(num)]),
        () => Buffer.concat([rest[0], rest[1].subarray(0, num), rest[1]]),
        () => Buffer.concat([rest[0], Buffer.from([r.integer(0, 255)]), rest[1].subarray(1)]),
        () => Buffer.concat([rest[0], Buffer.from(r.pick(['-', 'e', '9999999999', '.', '\0', '\n',
            '<g>', '</g>', '&#0;', 'INSERT', 'nan', '1e308', '"', 'M'])), rest[1]]),
    ])();
}

function isRead(path, options) {
    const run = spawnSync(outline, [path, ...options], { timeout: longestRun, maxBuffer: 1 << 28 });
    const ok = run.status === 0 || run.status === 1;
    if (!ok || String(run.stderr).includes('runtime error'))
        console.log(`FAIL ${path} ${options.join(' ')}: ${run.signal ?? run.status}\n${run.stderr}`);
    return { ok, num: run.stdout?.length ?? 0 };
}

const folder = mkdtempSync(join(tmpdir(), `${kind}-`));
let failed = 0, filled = 0;
for (let i = 0; i < Number(count); i++) {
    const path = join(folder, `${i}.${kind}`);
    const { text, options } = make(r);
    let bytes = Buffer.from(text);
    for (let k = mode === 'broken' ? r.integer(1, 3) : 0; k > 0 && bytes.length > 0; k--)
        bytes = breakIn(bytes);
    writeFileSync(path, bytes);
    const { ok, num } = mode === 'broken' ? isRead(path, options) : agrees(outline, path, options);
    failed += !ok;
    filled += num > 0;
}
console.log(`${count} files, seed ${seed}: ${filled} not empty, ${failed} fail`);
if (failed === 0)
    rmSync(folder, { recursive: true });
process.exit(failed > 0 || filled < (mode === 'broken' ? count / 20 : count / 2) ? 1 : 0);
