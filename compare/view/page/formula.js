// SPDX-License-Identifier: MIT
// How is a formula typed on one line shown as in a book? x0 + v0 t + g t^2 / 2 gets its indices and powers.

const SYMBOLS = {alpha: "α", theta: "θ", mu: "μ", omega: "ω", phi: "φ", pi: "π", sqrt: "√"};
const SIGNS = {"-": "−", ">=": "≥", "<=": "≤", "->": "→", "'": "′", "''": "″", "*": "·"};

const FORMULA_PART = new RegExp([
    /\^\(([^()]*)\)/,  // a power in parentheses
    /\^(-?\w+)/,  // a power
    /_([A-Za-z0-9]+)/,  // an index
    /([A-Za-z])(\d+)(?![\w.])/,  // a name and its digits
    /([A-Za-z]+)/,  // a word
    /(\d+(?:\.\d+)?(?:e[-+]?\d+)?)/,  // a number
    /(>=|<=|->|''|'|-|\*)/,  // a sign
].map(({source}) => source).join("|"), "g");

function formulaName(word) {
    if (SYMBOLS[word]) return SYMBOLS[word];
    return word.length === 1 ? element("i", {}, word) : word;
}

function formulaParts(text) {
    const parts = [];
    let end = 0;
    for (const match of text.matchAll(FORMULA_PART)) {
        const [whole, group, power, index, letter, digits, word, , sign] = match;
        parts.push(text.slice(end, match.index));
        if (group !== undefined || power !== undefined) parts.push(element("sup", {}, ...formulaParts(group ?? power)));
        else if (index !== undefined) parts.push(element("sub", {}, ...formulaParts(index)));
        else if (letter !== undefined) parts.push(formulaName(letter), element("sub", {}, digits));
        else if (word !== undefined) parts.push(formulaName(word));
        else parts.push(SIGNS[sign] ?? whole);
        end = match.index + whole.length;
    }
    parts.push(text.slice(end));
    return parts;
}
