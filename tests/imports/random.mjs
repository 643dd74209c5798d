// SPDX-License-Identifier: MIT

// Numbers from a seed (mulberry32, Tommy Ettinger), the same on every machine.
export function random(seed) {
    let state = seed >>> 0;
    const next = () => {
        state = (state + 0x6d2b79f5) >>> 0;
        let t = Math.imul(state ^ (state >>> 15), state | 1);
        t = (t + Math.imul(t ^ (t >>> 7), t | 61)) ^ t;
        return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
    };
    const integer = (low, high) => low + Math.floor(next() * (high - low + 1));
    return {
        integer,
        between: (low, high) => low + next() * (high - low),
        chance: (share) => next() < share,
        pick: (list) => list[integer(0, list.length - 1)],
        shuffled: (list) => list.map((item) => [next(), item]).sort((a, b) => a[0] - b[0])
            .map(([, item]) => item),
    };
}
