// SPDX-License-Identifier: MIT
// How is a number written for a person? With three digits, and a prefix if the unit has one, else a power of ten.

const NO_BREAK = "\u00a0";
const NONE = "–";
/// The factor, the name, and the smallest size for which it is used if that is not the factor.
const PREFIXES = {
    m: [[1, "m"], [1e-3, "mm"], [1e-6, "µm"], [1e-9, "nm"]],
    s: [[1, "s", 0.01], [1e-3, "ms"], [1e-6, "µs"], [1e-9, "ns"]],
    ms: [[1, "ms"], [1e-3, "µs"], [1e-6, "ns"]],
    N: [[1e3, "kN"], [1, "N"], [1e-3, "mN"], [1e-6, "µN"]],
    J: [[1e3, "kJ"], [1, "J"], [1e-3, "mJ"], [1e-6, "µJ"]],
    rad: [[1, "rad"], [1e-3, "mrad"], [1e-6, "µrad"]],
};

/// As the page's language writes it.
function minus(text) {
    return numberText(text.replace(/-/g, "−"));
}

/// Without a power of ten: 0.00123, 12.3, 12300.
function withDigits(x, digits) {
    const r = Number(x.toPrecision(digits));
    if (r === 0) return "0";
    const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(Math.abs(r)) + 1e-9));
    return minus(r.toFixed(Math.min(decimals, 12)));
}

function superscript(exponent) {
    return String(exponent).replace("+", "").replace(/[-0-9]/g, (c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]));
}

function scientific(x, digits = 3) {
    const [lead, exponent] = x.toExponential(digits - 1).split("e");
    return `${minus(lead)}×10${superscript(exponent)}`;
}

/// A share of a whole, such as a drift of energy. With a power of ten if per cent would need many digits.
function ratioText(x, digits) {
    if (x === 0) return "0";
    const size = Math.abs(x);
    return size >= 1e-5 && size < 1e3 ? withDigits(100 * x, digits) + NO_BREAK + "%" : scientific(x, digits);
}

function plainText(x, digits) {
    const size = Math.abs(x);
    return x === 0 || (size >= 1e-3 && size < 1e5) ? withDigits(x, digits) : scientific(x, digits);
}

/// unit: "" for a ratio, "-" for a plain number.
function quantity(x, unit, digits = 3) {
    if (x === null || x === undefined || Number.isNaN(x)) return NONE;
    if (!Number.isFinite(x)) return x > 0 ? "∞" : "−∞";
    if (unit === "") return ratioText(x, digits);
    if (unit === "-") return plainText(x, digits);
    const prefixes = PREFIXES[unit];
    if (!prefixes) return plainText(x, digits) + NO_BREAK + unit;
    if (x === 0) return "0" + NO_BREAK + unit;
    const size = Math.abs(Number(x.toPrecision(digits)));
    const fit = prefixes.find(([factor, , from = factor]) => size >= from * (1 - 1e-9));
    if (!fit || size >= 1e4 * prefixes[0][0]) return scientific(x, digits) + NO_BREAK + unit;
    return withDigits(x / fit[0], digits) + NO_BREAK + fit[1];
}

/// For little room: one digit before a power of ten.
function shortQuantity(x, unit) {
    return quantity(x, unit).replace(/^(−?\d)[.,]\d+×/, (_, lead) => `${lead}×`);
}

/// A value that was chosen, not measured: 2 mm, not 2.00 mm.
function chosenQuantity(x, unit, digits = 3) {
    return quantity(x, unit, digits).replace(/([.,])(\d*?)0+(?=\D|$)/, (_, point, kept) => (kept ? point + kept : ""));
}

/// In the unit itself, as on a ruler: −0.9961 m. Less than a millionth is shown as 0.
function rulerText(x, unit) {
    if (!Number.isFinite(x)) return quantity(x, unit);
    const size = Math.abs(x);
    return `${size < 1e-6 ? "0" : size < 1e5 ? withDigits(x, 4) : scientific(x, 4)}${NO_BREAK}${unit}`;
}

function timeText(t) {
    return numberText(t.toFixed(3)) + NO_BREAK + "s";
}

/// A tick of an axis whose ticks are `step` apart.
function axisText(x, step) {
    if (Math.abs(x) < step * 1e-6) return "0";
    const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    if (decimals > 5 || Math.abs(x) >= 1e5) return scientific(x).replace(/[.,]?0+×/, "×");
    return minus(x.toFixed(decimals));
}

function powerOfTen(exponent) {
    return exponent === 0 ? "1" : exponent === 1 ? "10" : `10${superscript(exponent)}`;
}

/// A scene's or lab's own title, or one made from its name: free_fall -> Free fall.
function titleText({name, title}) {
    if (title) return title;
    const words = name.replaceAll("_", " ");
    return words.charAt(0).toUpperCase() + words.slice(1);
}
