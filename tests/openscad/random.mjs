// SPDX-License-Identifier: MIT
//
//     node random.mjs SEED >SCENE.scad
//
// A random tree of cubes, spheres, cylinders and cones, Booleans and maps, the same for the same
// seed. Even seeds keep to whole numbers and right angles, so that many faces coincide; odd ones
// rotate, scale and shear at will.

const seed = Number(process.argv[2]);
const gridded = seed % 2 === 0;
let state = (seed * 2654435761 + 12345) >>> 0;

function random() { // mulberry32
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
}

const integer = (lo, hi) => lo + Math.floor(random() * (hi - lo + 1));
const real = (lo, hi) => Number((lo + random() * (hi - lo)).toFixed(2));
const length = (lo, hi) => gridded ? integer(lo, hi) : real(lo, hi);
const pick = (...choices) => choices[integer(0, choices.length - 1)];
const triple = (make) => `[${make()}, ${make()}, ${make()}]`;

function leaf() {
    const fn = pick(3, 4, 6, 8, 17, 24);
    const center = pick("true", "false");
    return pick(
        () => `cube(${triple(() => length(2, 12))}, center = ${center});`,
        () => `cube(${length(3, 12)});`,
        () => `sphere(r = ${length(3, 8)}, $fn = ${Math.max(fn, 5)});`,
        () => `cylinder(h = ${length(2, 14)}, r = ${length(2, 6)}, center = ${center}, ` +
            `$fn = ${fn});`,
        () => `cylinder(h = ${length(2, 12)}, r1 = ${length(1, 6)}, r2 = ${length(0, 5)}, ` +
            `$fn = ${fn});`,
    )();
}

function map() {
    const free = [
        () => `rotate(${triple(() => integer(0, 359))})`,
        () => `scale(${triple(() => length(0.4, 1.6))})`,
        () => `multmatrix([[1, ${real(-1, 1)}, ${real(-1, 1)}, 0], [0, 1, ${real(-1, 1)}, 0], ` +
            "[0, 0, 1, 0]])",
    ];
    const aligned = [
        () => `translate(${triple(() => length(-6, 6))})`,
        () => `rotate(${triple(() => 90 * integer(0, 3))})`,
        () => `mirror(${pick("[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]", "[1, 1, 0]")})`,
    ];
    return pick(...aligned, ...(gridded ? [] : free))();
}

function node(depth) {
    if (depth === 0 || random() < 0.15)
        return `${map()} ${leaf()}`;
    const children = Array.from({ length: integer(2, 4) }, () => node(depth - 1));
    const op = pick("union", "union", "difference", "difference", "intersection");
    const text = children.map((child) => child.replace(/^/gm, "    ")).join("\n");
    return `${random() < 0.5 ? map() + " " : ""}${op}() {\n${text}\n}`;
}

console.log(`// node random.mjs ${seed}\n${node(3)}`);
