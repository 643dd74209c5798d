// SPDX-License-Identifier: MIT
//
// Random DXF files: shapes of all kinds, on two layers and in blocks, their ends near each other
// or not, and groups that make no sense.


let r; // of random.mjs

// Ends meet often, exactly or within the grid's step.
function coordinate() {
    const nudge = r.chance(0.15) ? r.between(-0.0015, 0.0015) : 0;
    return (r.chance(0.8) ? r.integer(0, 4) * 10 + nudge : r.between(-5, 45)).toFixed(r.pick([1, 4, 9]));
}

const angle = () => r.pick([0, 30, 45, 90, 270, 359, -30, 400, r.between(0, 360).toFixed(3)]);
const layer = () => [8, r.pick(['0', 'a'])];

const shapes = {
    LINE: () => [layer(), [10, coordinate()], [20, coordinate()], [11, coordinate()], [21, coordinate()]],
    CIRCLE: () => [layer(), [10, coordinate()], [20, coordinate()], [40, r.between(0.1, 20).toFixed(2)]],
    ARC: () => [layer(), [10, coordinate()], [20, coordinate()], [40, r.integer(1, 20)],
        [50, angle()], [51, angle()]],
    ELLIPSE: () => [layer(), [10, coordinate()], [20, coordinate()], [11, coordinate()],
        [21, coordinate()], [40, r.between(0.1, 1).toFixed(2)], [41, r.between(0, 7).toFixed(3)],
        [42, r.between(0, 7).toFixed(3)]],
    LWPOLYLINE: () => {
        const groups = [layer(), [70, r.integer(0, 1)]];
        for (let i = r.integer(1, 6); i > 0; i--)
            groups.push([10, coordinate()], [20, coordinate()]);
        return groups;
    },
    INSERT: () => [layer(), [2, r.pick(['A', 'B', 'C'])], [10, coordinate()], [20, coordinate()],
        ...(r.chance(0.5) ? [[41, r.pick([1, 2, -1])], [42, r.pick([1, 0.5])]] : []),
        ...(r.chance(0.5) ? [[50, angle()]] : [])],
    POINT: () => [layer(), [10, coordinate()], [20, coordinate()]],
};

function shape(types) {
    const type = r.pick(types);
    const groups = shapes[type]();
    if (r.chance(0.05))
        groups.splice(r.integer(0, groups.length - 1), 1);
    if (r.chance(0.03))
        groups.push([r.pick([10, 40, 70]), r.pick(['x', '1,5', '', '1e999'])]);
    return [[0, type], ...groups];
}

// Lines that go round, so that something is filled.
function ring() {
    const n = r.integer(3, 7), cx = r.integer(0, 40), cy = r.integer(0, 40), radius = r.between(2, 15);
    const at = (i) => [cx + radius * Math.cos(i % n * 2 * Math.PI / n),
        cy + radius * Math.sin(i % n * 2 * Math.PI / n)];
    const lines = [];
    for (let i = 0; i < n; i++) {
        const [a, b] = r.chance(0.5) ? [at(i), at(i + 1)] : [at(i + 1), at(i)];
        lines.push([[0, 'LINE'], layer(), [10, a[0]], [20, a[1]], [11, b[0]], [21, b[1]]]);
    }
    return r.shuffled(lines).flat();
}

function file() {
    const groups = [];
    const simple = ['LINE', 'LINE', 'LINE', 'CIRCLE', 'ARC', 'LWPOLYLINE', 'ELLIPSE'];
    if (r.chance(0.5)) {
        groups.push([0, 'SECTION'], [2, 'BLOCKS']);
        for (const name of ['A', 'B']) {
            groups.push([0, 'BLOCK'], [2, name]);
            for (let i = r.integer(0, 3); i > 0; i--)
                groups.push(...shape(r.chance(0.2) ? ['INSERT'] : simple));
            groups.push([0, 'ENDBLK']);
        }
        groups.push([0, 'ENDSEC']);
    }
    groups.push([0, 'SECTION'], [2, 'ENTITIES']);
    for (let i = r.integer(0, 3); i > 0; i--)
        groups.push(...ring());
    for (let i = r.integer(0, 8); i > 0; i--)
        groups.push(...shape([...simple, 'INSERT', 'POINT']));
    groups.push([0, 'ENDSEC'], [0, 'EOF']);
    const newline = r.pick(['\n', '\r\n']);
    return groups.map(([id, value]) => `${String(id).padStart(3)}${newline}${value}${newline}`).join('');
}

function options() {
    const list = [];
    if (r.chance(0.3)) list.push('layer=a');
    if (r.chance(0.3)) list.push(`x=${r.integer(-5, 5)}`, `y=${r.integer(-5, 5)}`);
    if (r.chance(0.3)) list.push(`scale=${r.pick([0.5, 2, 3.7])}`);
    if (r.chance(0.3)) list.push(`fn=${r.integer(3, 40)}`);
    return list;
}

// A file's text and options for outline.c.
export function make(random) {
    r = random;
    return { text: file(), options: options() };
}
