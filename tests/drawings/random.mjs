// SPDX-License-Identifier: MIT
//
//   node random.mjs DIFFER COUNT SEED [NODE...]
//
// Random drawings of all nodes, or of those that are named, with odd arguments among the usual
// ones: whether they cover the same as the openscad in the path exports.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { random } from '../imports/random.mjs';

const [differ, count, seed, ...wanted] = process.argv.slice(2);
const r = random(Number(seed));

// Six digits are off by that part of the size, along the whole outline.
const rounding = 2e-5;

const odd = () => r.pick(['0', '-1', '0/0', '1/0', '"x"', 'true', '[1]', 'undef', '1e-9', '1e6']);
const length = (low, high) => r.chance(0.04) ? odd()
    : r.chance(0.5) ? String(r.integer(low, high)) : r.between(low, high).toFixed(3);
const pair = (low, high) => `[${length(low, high)}, ${length(low, high)}]`;
const fn = () => r.chance(0.6) ? `, $fn = ${r.chance(0.05) ? r.pick(['0/0', '1/0', '-1', '2', '"x"']) : r.integer(3, 24)}` : '';
const bool = () => r.pick(['true', 'false']);

function polygon() {
    const points = Array.from({ length: r.integer(3, 9) }, () => pair(-15, 15));
    const paths = r.chance(0.2) ? `, paths = [[0, 1, 2], [${r.shuffled(points.map((_, i) => i)).join(', ')}]]` : '';
    return `polygon([${points.join(', ')}]${paths});`;
}

const texts = ['A', 'Og8', 'a b', 'fi', '', 'Ä€', '\\n', '(.)', 'mW'];
const figures = {
    square: () => `square(${r.chance(0.3) ? length(1, 20) : pair(1, 20)}, center = ${bool()});`,
    circle: () => `circle(${r.pick(['r', 'd'])} = ${length(1, 12)}${fn()});`,
    polygon,
    text: () => `text("${r.pick(texts)}", size = ${length(3, 12)}, halign = "${
        r.pick(['left', 'center', 'right', 'x'])}", valign = "${
        r.pick(['top', 'center', 'bottom', 'baseline', ''])}", spacing = ${length(1, 2)}${fn()});`,
    projection: () => `projection(cut = ${bool()}) ${r.pick([
        () => `rotate([${length(0, 90)}, ${length(0, 90)}, 0]) cube([${length(1, 12)}, ${length(1, 12)}, 9], center = true);`,
        () => `translate([0, 0, ${length(-3, 3)}]) sphere(${length(2, 9)}, $fn = ${r.integer(3, 14)});`,
        () => `rotate([${length(0, 90)}, 0, 0]) cylinder(h = ${length(2, 9)}, r1 = ${length(1, 9)}, r2 = ${
            length(0, 9)}, $fn = ${r.integer(3, 12)}, center = true);`,
    ])()}`,
};

const nodes = {
    union: (inner) => `union() { ${inner(3)} }`,
    difference: (inner) => `difference() { ${inner(3)} }`,
    intersection: (inner) => `intersection() { ${inner(2)} }`,
    translate: (inner) => `translate(${pair(-10, 10)}) { ${inner(2)} }`,
    rotate: (inner) => `rotate(${length(-180, 180)}) { ${inner(2)} }`,
    scale: (inner) => `scale(${r.pick([pair(-2, 2), pair(1, 3), length(1, 2)])}) { ${inner(2)} }`,
    mirror: (inner) => `mirror(${pair(-2, 2)}) { ${inner(1)} }`,
    offset: (inner) => `offset(${r.pick([`r = ${length(-3, 5)}`, `delta = ${length(-3, 5)}`,
        `delta = ${length(-3, 5)}, chamfer = true`, length(1, 3)])}${fn()}) { ${inner(2)} }`,
    hull: (inner) => `hull() { ${inner(3)} }`,
    minkowski: (inner) => `minkowski() { ${inner(1)} ${inner(1)} }`,
    resize: (inner) => `resize(${r.pick([pair(0, 20), pair(-5, 20), `[${length(1, 20)}, 0]`])}${
        r.pick(['', ', auto = true', ', auto = [true, false]'])}) { ${inner(2)} }`,
};

const pickFrom = (table) => {
    const names = Object.keys(table).filter((name) => wanted.length === 0 || wanted.includes(name));
    return table[r.pick(names.length ? names : Object.keys(table))];
};

function drawing(depth) {
    const inner = (most) => Array.from({ length: r.integer(1, most) }, () => drawing(depth + 1)).join(' ');
    return depth < 3 && r.chance(depth === 0 ? 0.95 : 0.4) ? pickFrom(nodes)(inner) : pickFrom(figures)();
}

function run(program, args, input) {
    const done = spawnSync(program, args, { encoding: 'utf8', input, timeout: 20000, maxBuffer: 1 << 28 });
    if (done.error?.code === 'ENOENT')
        throw new Error(`${program} is missing (Debian: apt-get install openscad)`);
    return done;
}

const folder = mkdtempSync(join(tmpdir(), 'drawings-'));
let failed = 0, filled = 0, handed = 0;
for (let i = 0; i < Number(count); i++) {
    const at = (ending) => join(folder, `${i}.${ending}`);
    writeFileSync(at('scad'), `${drawing(0)}\n`);
    run('openscad', ['-o', at('csg'), at('scad')]);
    if (!existsSync(at('csg')))
        continue;
    const exported = run('openscad', ['-o', at('svg'), at('scad')]);
    if (exported.error) // out of time
        continue;
    const svg = existsSync(at('svg')) ? readFileSync(at('svg'), 'utf8') : '';
    const result = run(differ, [at('csg')], pointsOf(svg));
    const [ours, num, area, outline] = (result.stdout ?? '').trim().split(' ').map(Number);
    const size = Math.max(1, ...(svg.match(/-?[\d.]+(e[-+]?\d+)?(?=[ ,z])/g) ?? []).map((x) => Math.abs(Number(x))));
    if (result.stderr.includes('--skip-unsupported')) { // too many corners: openscad does it
        handed++;
        continue;
    }
    const ok = result.status === 0 && area <= rounding * size * outline + 1e-9;
    filled += num > 0;
    failed += !ok;
    if (!ok)
        console.log(`FAIL ${at('scad')}: ${readFileSync(at('scad'), 'utf8').trim()}\n     corners ${ours} ` +
            `${num}, area ${area} of outlines ${outline}; ${result.stderr.trim().slice(0, 300)}\n     ${
                exported.stderr.split('\n').filter((l) => /WARN|ERR/.test(l)).slice(0, 2).join(' | ')}`);
}

function pointsOf(svg) {
    return [...svg.matchAll(/([ML]) (\S+?),(\S+)/g)]
        .map(([, c, x, y]) => `${c === 'M' ? '\n' : ''}${x} ${-Number(y)}\n`).join('');
}

console.log(`${count} drawings, seed ${seed}: ${filled} not empty, ${handed} too large, ${failed} differ`);
if (failed === 0)
    rmSync(folder, { recursive: true });
process.exit(failed > 0 || filled < count / 3 ? 1 : 0);
