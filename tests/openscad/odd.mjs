// SPDX-License-Identifier: MIT
//
// Random scenes of every kind of node that OpenSCAD 2021.01 has but files, with odd arguments among
// the usual ones: oddScene(seed) is the text, the same for the same seed. Few facets, so that
// OpenSCAD is done soon.

let state = 0;

function random() { // mulberry32
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
}

const chance = (p) => random() < p;
const integer = (lo, hi) => lo + Math.floor(random() * (hi - lo + 1));
const pick = (...choices) => choices[integer(0, choices.length - 1)];
const choose = (...makers) => pick(...makers)();
const list = (num, make) => Array.from({ length: num }, make);
const vector = (num, make) => `[${list(num, () => make()).join(", ")}]`;
const indent = (text) => text.replace(/^/gm, "    ");
const block = (head, children) => `${head} {\n${indent(children.join("\n"))}\n}`;

// Whole numbers make faces coincide; two digits do not.
let gridded = false;
const real = (lo, hi) => gridded ? integer(Math.ceil(lo), Math.floor(hi))
    : Number((lo + random() * (hi - lo)).toFixed(2));

// ---- arguments -----------------------------------------------------------------------------

const oddShare = 0.03;
const odd = () => pick("0", "-1", "0/0", "1/0", "-1/0", "undef", '"a"', "true", "[]", "[1]",
    "[2, 3]", "[1, 2, 3, 4]", "1e-3", "1e-9", "300", "[undef, 2, 3]", "[0/0, 1, 2]");
const or = (value) => chance(oddShare) ? odd() : value;
const size = (lo = 1, hi = 9) => or(real(lo, hi));
const flag = () => or(pick("true", "false"));
const facets = () => choose(
    ...list(6, () => () => `$fn = ${integer(3, 9)}`),
    () => `$fn = ${pick(-2, 0, 1, 2, 0.5, 3.9, 4.2, "0/0", "1/0", "undef", 13)}`,
    () => `$fa = ${pick(40, 60, 90, 180, 361)}, $fs = ${pick(1, 3, 20)}`,
    () => `$fa = ${pick(45, 72)}`);
const some = (...args) => args.filter((arg) => arg !== "").join(", ");
const maybe = (p, text) => chance(p) ? text() : "";

// ---- drawings ------------------------------------------------------------------------------

function star(num, lo, hi) {
    const turn = real(0, 6);
    return list(num, (_, i) => {
        const angle = turn + 2 * Math.PI * i / num, radius = lo + random() * (hi - lo);
        return [radius * Math.cos(angle), radius * Math.sin(angle)].map((x) => x.toFixed(
            gridded ? 0 : 2));
    });
}

const pointText = (points) => `[${points.map((p) => `[${p.join(", ")}]`).join(", ")}]`;

function polygonWithHole() {
    const outer = star(integer(4, 7), 5, 8), inner = star(integer(3, 5), 1, 3);
    const indices = (from, num) => vector(num, () => from++);
    return `polygon(points = ${pointText([...outer, ...inner])}, paths = [` +
        `${indices(0, outer.length)}, ${indices(outer.length, inner.length)}]);`;
}

const figure = () => choose(
    () => `square(${vector(2, size)}, center = ${flag()});`,
    () => `square(${size()});`,
    () => `circle(r = ${size(1, 6)}, ${facets()});`,
    () => `circle(d = ${size(2, 10)}, ${facets()});`,
    () => `polygon(${pointText(star(integer(3, 8), 2, 7))});`,
    () => `polygon(${vector(integer(3, 6), () => vector(2, () => or(real(-6, 6))))});`,
    polygonWithHole,
    () => `text("${pick("a", "Bo", "8", "i", "%", "")}", size = ${size(4, 10)}, ` +
        `halign = "${pick("left", "center", "right")}", $fn = ${integer(2, 9)});`);

const plane = (depth) => choose(
    () => block(`offset(${some(`r = ${or(real(-2, 2))}`, facets())})`, drawings(depth)),
    () => block(`offset(delta = ${or(real(-2, 2))}, chamfer = ${flag()})`, drawings(depth)),
    () => block("hull()", drawings(depth)),
    () => block("minkowski()", drawings(depth)),
    () => block(`resize(${vector(2, () => or(real(0, 12)))}, auto = ${pick("true", "false",
        "[true, false]")})`, drawings(depth)),
    () => block(`projection(cut = ${flag()})`, solids(depth)));

const drawing = (depth) => depth <= 0 || chance(0.25) ? figure() : choose(
    () => block(boolean(), drawings(depth)),
    () => block(boolean(), drawings(depth)),
    () => block(map(), [drawing(depth - 1)]),
    () => plane(depth - 1));

const drawings = (depth) => children(depth, drawing, solid);

// ---- solids --------------------------------------------------------------------------------

const cylinder = () => `cylinder(${some(`h = ${size()}`, ...choose(
    () => [`r = ${size(1, 6)}`], () => [`d = ${size(2, 9)}`],
    () => [`r1 = ${size(0, 6)}`, `r2 = ${size(0, 6)}`],
    () => [`d1 = ${size(1, 8)}`, `r = ${size(1, 6)}`]),
maybe(0.5, () => `center = ${flag()}`), facets())});`;

// A prism whose corners are moved: its faces are not plane.
function warped() {
    const num = integer(3, 6), by = chance(0.5) ? 0 : 1.5, [bottom, top] = [star(num, 4, 7), []];
    for (const [x, y] of bottom)
        top.push([Number(x) + real(-by, by), Number(y) + real(-by, by), real(5, 5 + by)]);
    const ring = list(num, (_, i) => i);
    const sides = ring.map((i) => `[${[i, (i + 1) % num, (i + 1) % num + num, i + num]}]`);
    const faces = [`[${[...ring].reverse()}]`, `[${ring.map((i) => i + num)}]`, ...sides];
    return `polyhedron(${pointText([...bottom.map((p) => [...p, 0]), ...top])}, [${faces}]);`;
}

const extrusion = (depth) => block(`linear_extrude(${some(`height = ${size()}`,
    maybe(0.3, () => `center = ${flag()}`), maybe(0.4, () => `twist = ${or(real(-150, 150))}`),
    maybe(0.4, () => `scale = ${or(pick(0, 0.5, 2, "[0.5, 2]", "[0, 1]", "[2, 0]"))}`),
    maybe(0.4, () => `slices = ${or(integer(4, 6))}`), maybe(0.5, facets))})`, drawings(depth));

const revolution = (depth) => block(`rotate_extrude(${some(
    maybe(0.6, () => `angle = ${or(real(-400, 400))}`), facets())})`,
[`translate([${or(real(8, 12))}, ${real(-3, 3)}]) ${drawing(depth - 1)}`]);

const body = () => choose(
    () => `cube(${vector(3, size)}, center = ${flag()});`,
    () => `cube(${size()});`,
    () => `sphere(${pick("r", "d")} = ${size(2, 7)}, ${facets()});`,
    cylinder, cylinder, warped);

const compound = (depth) => choose(
    () => extrusion(depth), () => extrusion(depth), () => revolution(depth),
    () => block("hull()", solids(depth)),
    () => block("minkowski()", [solid(depth - 1), body()]),
    () => block(`resize(${vector(3, () => or(real(0, 12)))}, auto = ${pick("true", "false",
        "[true, false, true]")})`, solids(depth)),
    () => block("render()", solids(depth)));

const map = () => choose(
    () => `translate(${or(vector(3, () => or(real(-6, 6))))})`,
    () => `translate(${vector(2, () => real(-6, 6))})`,
    () => `rotate(${vector(3, () => or(gridded ? 90 * integer(-1, 3) : integer(0, 359)))})`,
    () => `rotate(${or(integer(0, 359))})`,
    () => `rotate(${or(integer(0, 359))}, ${or(vector(3, () => integer(-1, 1)))})`,
    () => `mirror(${or(vector(3, () => integer(-1, 1)))})`,
    () => `scale(${or(vector(3, () => or(real(0.5, 2) * pick(1, 1, -1))))})`,
    () => `scale(${size(1, 2)})`,
    () => `multmatrix([[1, ${or(real(-1, 1))}, 0, ${real(-3, 3)}], [0, 1, ${real(-1, 1)}, 0], ` +
        `[0, ${gridded ? 0 : real(-1, 1)}, 1, 0]${maybe(0.3, () => `, [0, 0, ${pick(0, 0.1)}, ${pick(1, 2)}]`)}])`,
    () => pick('color("red")', "color([0, 1, 0, 0.5])", "group()", "for (i = [0:1])"),
    () => pick("#", "union()", "render()", "intersection_for(i = [1:2]) rotate(20 * i)"));

const boolean = () => pick("union()", "union()", "difference()", "difference()", "difference()",
    "intersection()", "group()");

const solid = (depth) => depth <= 0 || chance(0.2) ? body() : choose(
    () => block(boolean(), solids(depth)),
    () => block(boolean(), solids(depth)),
    () => block(map(), [solid(depth - 1)]),
    () => compound(depth - 1));

const solids = (depth) => children(depth, solid, drawing);

// One to three, now and then nothing, an empty node, one that does not count, or one of the other
// dimension.
function children(depth, own, other) {
    const num = chance(0.03) ? 0 : integer(1, 3);
    return list(num, () => chance(0.03) ? choose(() => "group();", () => `%${body()}`,
        () => `*${body()}`, () => other(0), () => "cube(0);")
        : chance(0.5) ? `${map()} ${own(depth - 1)}` : own(depth - 1));
}

export function oddScene(seed) {
    state = (seed * 2654435761 + 12345) >>> 0;
    gridded = seed % 2 === 0;
    return `// odd.mjs ${seed}\n${solids(4).join("\n")}\n`;
}
