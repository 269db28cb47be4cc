// SPDX-License-Identifier: MIT
// What do texts and formulas of a lesson say of a run? Each has queries, which the module answers.

const SHOWN_UNITS = {deg: "°", "m/s^2": "m/s²", "kg m/s^2": "kg m/s²"};

/// A number as it is worked with by hand: four digits, without zeros at the end.
function workedText(x) {
    if (x === null || !Number.isFinite(x)) return NONE;
    const size = Math.abs(x);
    if (size < 1e-12) return "0";
    if (Number.isInteger(x) && size < 1e7) return minus(String(x));  // a count has all its digits
    if (size < 1e-3 || size >= 1e6) return scientific(x, 4);
    return numberText(String(Number(x.toPrecision(4))));
}

function valueText({value, unit}) {
    const shown = SHOWN_UNITS[unit] ?? unit;
    if (value === null || !Number.isFinite(value)) return NONE;
    if (unit === "ratio") return quantity(value, "", 2);
    const isTiny = Math.abs(value) < 1e-3 && Math.abs(value) > 1e-12;
    if (isTiny && PREFIXES[unit]) return quantity(value, unit, 3);
    return minus(workedText(value)) + (shown && shown !== "-" ? (shown === "°" ? "" : NO_BREAK) + shown : "");
}

/// The queries of a run, each asked once.
class Values {
    constructor(comparison) {
        this.comparison = comparison;
        this.forget();
    }

    forget() { this.known = new Map(); }

    /// engines: of the lesson, whose own come before those of worse cases.
    openFor(engines) { this.engines = engines; }

    /// {value, unit} of an engine of the scene; value is null if there is nothing to read.
    of(engine, query) {
        const key = `${engine.name} ${query}`;
        if (!this.known.has(key)) {
            this.known.set(key, engine.run === undefined || engine.unsupported ? {value: null, unit: ""}
                : withRatio(query, this.comparison.value(engine.run, query)));
        }
        return this.known.get(key);
    }

    /// The closed form's where it knows one, else that of the engine under test, else that of the lesson's first engine.
    truth(scene, query) {
        const place = ({name}) => rank({name}) * 100 + this.engines.indexOf(name);
        const ordered = scene.running.filter(({name}) => this.engines.includes(name)).sort((a, b) => place(a) - place(b));
        for (const engine of ordered) {
            const found = this.of(engine, query);
            if (found.value !== null) return found;
        }
        return {value: null, unit: ""};
    }

    /// The text with the values of an engine, or with true ones.
    filled(scene, text, engine = null) {
        return text.replace(/\{([^{}]*)\}/g, (_, query) =>
            valueText(engine ? this.of(engine, query) : this.truth(scene, query)));
    }

    /// The formula in LaTeX, with true values; a negative one that is worked on is in parentheses. Its words are in the
    /// language of the page.
    worked(scene, formula) {
        const said = formula.replace(/(\\text\{\s*)([^{}]*?)(\s*\})/g, (_, start, words, end) => start + say(words) + end);
        return said.replace(/<([^<>]*)>/g, (found, query, at) => {
            const {value} = this.truth(scene, query), number = latexNumber(value);
            return value < 0 && !standsAlone(said.slice(0, at), said.slice(at + found.length)) ? `(${number})` : number;
        });
    }
}

/// A drift is a share of a whole.
function withRatio(query, {value, unit}) {
    return {value, unit: /^metric \w+_drift$/.test(query) ? "ratio" : unit};
}

function rank(engine) {
    return isTruth(engine.name) ? 0 : isSubject(engine.name) ? 1 : 2;
}

function latexNumber(value) {
    if (value === null || !Number.isFinite(value)) return "\\text{–}";
    const text = workedText(value).replace(",", "{,}").replaceAll("−", "-")
        .replace(/×10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)/, (_, power) => `\\cdot 10^{${plainPower(power)}}`);
    return text;
}

/// A number after "=" or at the start of a group needs no parentheses for its sign, unless it is raised to a power.
function standsAlone(before, after) {
    return /(^|=|\\approx|[{(,])\s*$/.test(before) && !/^\s*\^/.test(after);
}

function plainPower(power) {
    return [...power].map((c) => (c === "⁻" ? "-" : "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c))).join("");
}

/// The queries of a formula, in its order.
function queriesIn(formula) {
    return [...formula.matchAll(/<([^<>]*)>/g)].map(([, query]) => query);
}

function formulaElement(latex) {
    const line = element("div", {class: "worked"});
    try {
        katex.render(latex, line, {displayMode: true, output: "htmlAndMathml"});
    } catch (error) {
        line.replaceChildren(element("span", {class: "refused"}, `${latex}: ${error.message}`));
    }
    return line;
}
