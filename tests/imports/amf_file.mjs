// SPDX-License-Identifier: MIT
//
// Random AMF files: boxes, some of whose corners are wrong.

const faces = ['013', '032', '467', '475', '045', '051', '237', '276', '026', '064', '157', '173'];

function box(r) {
    const [x, y, z, size] = [0, 0, 0, 0].map(() => r.integer(1, 20));
    let text = '<object id="0"><mesh><vertices>';
    for (let i = 0; i < 8; i++)
        text += `<vertex><coordinates><x>${x + (i & 1) * size}</x><y>${y + (i >> 1 & 1) * size}</y>` +
            `<z>${z + (i >> 2) * size}</z></coordinates></vertex>\n`;
    text += '</vertices><volume>';
    for (const face of faces)
        text += `<triangle>${[...face].map((v, i) => `<v${i + 1}>${r.chance(0.005) ? 9 : v}</v${i + 1}>`).join('')}</triangle>\n`;
    return `${text}</volume></mesh></object>\n`;
}

// A file's text and options for outline.c.
export function make(r) {
    const boxes = Array.from({ length: r.integer(1, 3) }, () => box(r));
    return { text: `<?xml version="1.0"?>\n<amf unit="inch">\n${boxes.join('')}</amf>\n`, options: [] };
}
