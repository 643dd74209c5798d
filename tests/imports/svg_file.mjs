// SPDX-License-Identifier: MIT
//
// Random SVG files: pages of all kinds, shapes in groups with transforms, path data written in all
// the ways that it may be, and attributes that make no sense.


let r; // of random.mjs

const number = (low = 0, high = 100) => r.pick([
    () => String(r.integer(low, high)), () => r.between(low, high).toFixed(r.integer(1, 6)),
    () => r.between(low, high).toExponential(3), () => String(r.between(-1, 1)).replace('0.', '.'),
])();

// Numbers with as little between them as there may be.
function joined(numbers) {
    return numbers.reduce((text, next) => {
        const isTight = r.chance(0.4) && (next.startsWith('-') ||
            (next.startsWith('.') && /\.\d*$/.test(text)));
        return text + (text && !isTight ? r.pick([' ', ',', ', ', '  ']) : '') + next;
    }, '');
}

const numArgs = { a: 7, l: 2, c: 6, s: 4, q: 4, t: 2, m: 2, h: 1, v: 1, z: 0 };

function argumentsOf(letter) {
    if (letter === 'a')
        return [number(1, 50), number(1, 50), number(-90, 90), r.pick(['0', '1']), r.pick(['0', '1']),
            number(), number()];
    return Array.from({ length: numArgs[letter] }, () => number(-20, 80));
}

function data() {
    let text = `${r.pick(['M', 'm'])}${joined([number(), number()])}`;
    for (let i = r.integer(1, 8); i > 0; i--) {
        const letter = r.pick(['l', 'l', 'c', 's', 'q', 't', 'a', 'h', 'v', 'm', 'z']);
        let args = [];
        for (let k = r.chance(0.2) ? 2 : 1; k > 0; k--)
            args = args.concat(argumentsOf(letter));
        text += r.pick(['', ' ']) + (r.chance(0.5) ? letter : letter.toUpperCase()) +
            r.pick(['', ' ']) + joined(args);
    }
    return text + (r.chance(0.7) ? r.pick(['z', 'Z', ' z ']) : '');
}

function transform() {
    const one = () => r.pick([
        () => `translate(${joined([number(-30, 30), number(-30, 30)])})`,
        () => `translate(${number(-30, 30)})`, () => `scale(${number(1, 2)})`,
        () => `scale(${joined([number(-2, 2), number(1, 2)])})`,
        () => `rotate(${number(-180, 180)})`,
        () => `rotate(${joined([number(-180, 180), number(), number()])})`,
        () => `skewX(${number(-40, 40)})`, () => `skewY(${number(-40, 40)})`,
        () => `matrix(${joined(['1', number(-1, 1), number(-1, 1), '1', number(), number()])})`,
        () => `rotate(${joined([number(), number()])})`,
    ])();
    return r.chance(0.4) ? ` transform="${r.chance(0.3) ? `${one()} ${one()}` : one()}"` : '';
}

function pen() {
    if (r.chance(0.4))
        return ` style="fill:none;stroke-width:${number(1, 9)};stroke-linecap:${
            r.pick(['butt', 'round', 'square'])};stroke-linejoin:${r.pick(['miter', 'round', 'bevel'])}"`;
    return r.chance(0.4) ? ` stroke-width="${r.pick([number(1, 9), '3px', '0', '-2'])}" ` +
        `stroke-linejoin="${r.pick(['round', 'bevel', 'miter'])}"` : '';
}

const points = () => joined(Array.from({ length: 2 * r.integer(2, 6) }, () => number()));

const shapes = [
    () => `<path d="${data()}"${transform()}${pen()}/>`,
    () => `<path d="${data()}"${transform()}${pen()}/>`,
    () => `<rect x="${number()}" y="${number()}" width="${number(1, 60)}" height="${number(1, 60)}"${transform()}/>`,
    () => `<rect x="${number()}" y="${number()}" width="${number(1, 60)}" height="${number(1, 60)}" rx="${
        number(0, 40)}"${r.chance(0.5) ? ` ry="${number(0, 40)}"` : ''}${transform()}/>`,
    () => `<circle cx="${number()}" cy="${number()}" r="${number(1, 40)}"${transform()}/>`,
    () => `<ellipse cx="${number()}" cy="${number()}" rx="${number(1, 40)}" ry="${number(1, 40)}"${transform()}/>`,
    () => `<line x1="${number()}" y1="${number()}" x2="${number()}" y2="${number()}"${pen()}${transform()}/>`,
    () => `<polyline points="${points()}"${pen()}${transform()}/>`,
    () => `<polygon points="${points()}"${transform()}/>`,
    () => `<text${transform()}>text<tspan>more</tspan></text>`,
    () => `<defs><path d="${data()}"/><g><circle r="9"/></g></defs>`,
    () => `<use href="#a"/><!-- ${r.integer(0, 9)} --><svg:path d="M0 0h9v9z"/>`,
];

function content(depth) {
    let text = '';
    for (let i = r.integer(1, 3); i > 0; i--)
        text += depth < 3 && r.chance(0.3)
            ? `<${'g'}${transform()}>${content(depth + 1)}</g>\n`
            : `${r.pick(shapes)()}\n`;
    return text + (r.chance(0.1) ? `<svg width="20"${r.chance(0.5) ? ' viewBox="0 0 9 9"' : ''}/>` : '');
}

function page() {
    const length = () => r.pick(['100', '80mm', '12cm', '300px', '200pt', '10pc', '4in', '100%', '9em',
        ' 50 mm ', 'x', '1e2']);
    let text = '';
    if (r.chance(0.7)) text += ` width="${length()}" height="${length()}"`;
    if (r.chance(0.6)) text += ` viewBox="${joined([number(-9, 9), number(-9, 9), number(20, 150), number(20, 150)])}"`;
    if (r.chance(0.5)) text += ` preserveAspectRatio="${r.pick(['', '', 'defer '])}${
        r.pick(['none', 'xMinYMin', 'xMidYMax', 'xMaxYMid', 'xMaxYMax', 'what'])}${r.pick(['', ' meet', ' slice'])}"`;
    return text;
}

function file() {
    const text = `<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg"${
        r.chance(0.1) ? transform() : ''}${page()}>\n${content(0)}</svg>\n`;
    return r.chance(0.05) ? text.slice(0, r.integer(30, text.length)) : text;
}

function options() {
    const list = [];
    if (r.chance(0.3)) list.push('center');
    if (r.chance(0.3)) list.push(`dpi=${r.pick([90, 96, 300])}`);
    return list;
}

// A file's text and options for outline.c.
export function make(random) {
    r = random;
    return { text: file(), options: options() };
}
