// SPDX-License-Identifier: MIT
// What do the tables under the stage say?

const METRICS = {
    error_max: ["Largest distance to the closed form", "m"],
    error_end: ["Distance to the closed form at the end", "m"],
    divergence_max: ["Largest distance to Plumb", "m"],
    divergence_time: ["1 cm from Plumb after", "s"],
    energy_drift: ["Energy drift", ""],
    momentum_drift: ["Momentum drift", ""],
    angular_momentum_drift: ["Angular momentum drift", ""],
    penetration_max: ["Deepest penetration", "m"],
    joint_error_max: ["Widest gap in a joint", "m"],
    settle_time: ["Settled after", "s"],
    ms_per_step: ["Time for a step", "ms"],
};
/// Listed only where the scene conserves it: see compare/metric/conserved.h.
const MOMENTA = ["momentum_drift", "angular_momentum_drift"];
const LESS_IS_NOT_BETTER = ["divergence_max", "divergence_time", "settle_time"];

function metricUnit(scene, metric) {
    if (METRICS[metric]) return METRICS[metric][1];
    const probe = scene.probes.find(({name}) => `probe.${name}` === metric);
    return probe ? probe.unit : "-";
}

function metricLabel(metric) {
    if (METRICS[metric]) return METRICS[metric][0];
    return metric.startsWith("probe.") ? `Largest error of ${metric.slice(6)}` : metric;
}

function outcomeUnit(scene, outcome) {
    return outcome.check === "order" ? "-" : metricUnit(scene, outcome.metric);
}

/// "≤ 1 mm", and "≥ 1.9" for an order of convergence.
function limitText(scene, outcome) {
    const relation = outcome.check === "order" ? "≥" : "≤";
    return relation + NO_BREAK + chosenQuantity(outcome.limit, outcomeUnit(scene, outcome));
}

function failureText(scene, outcome) {
    const value = outcome.value === null ? "no value" : quantity(outcome.value, outcomeUnit(scene, outcome));
    const label = metricLabel(outcome.metric);
    const metric = label.charAt(0).toLowerCase() + label.slice(1);
    return `${lookOf(outcome.engine).label}: ${metric} ${value}, not ${limitText(scene, outcome)}`;
}

function failures(scene) {
    return scene.outcomes.filter((outcome) => !outcome.pass);
}

/// How far an engine is from the subject at most [m]; null where nothing was compared.
function apartOf(engine) {
    const value = engine.metrics.divergence_max;
    return isTruth(engine.name) || isSubject(engine.name) || typeof value !== "number" ? null : value;
}

/// "A: 1.64 m; B: 177 mm from C" for a scene without a closed form; null if there are no distances.
function apartText(scene) {
    if (scene.closedForm) return null;
    const parts = scene.engines.filter((engine) => apartOf(engine) !== null)
        .map((engine) => `${lookOf(engine.name).label}: ${quantity(apartOf(engine), "m")}`);
    const subject = scene.engines.find(({name}) => isSubject(name));
    return parts.length > 0 && subject ? `${parts.join("; ")} from ${lookOf(subject.name).label}` : null;
}

/// pass: true, false, or null if not judged.
function verdictSign(pass) {
    return pass === null ? {kind: "unjudged", sign: NONE, word: "not judged"}
        : pass ? {kind: "holds", sign: "✓", word: "holds"} : {kind: "fails", sign: "✗", word: "fails"};
}

function verdictMark(pass) {
    const {kind, sign, word} = verdictSign(pass);
    return element("span", {class: `verdict ${kind}`}, `${sign} ${word}`);
}

/// Why nothing was judged; what: "scene" or "lab".
function notJudgedText(what, {checks}) {
    return checks === 0 ? `this ${what} has no checks` : "no check binds these engines";
}

/// "5 of 6 scenes hold", and how many of the others were not judged.
function countText(list, what) {
    const unjudged = unjudgedText(list);
    return `${list.filter(({pass}) => pass).length} of ${list.length} ${what} hold${unjudged}`;
}

/// ", 1 not judged", or nothing.
function unjudgedText(list) {
    const count = list.filter(({pass}) => pass === null).length;
    return count > 0 ? `, ${count} not judged` : "";
}

/// Values within a twentieth of the least are equally good. If all are, none is marked.
function bestOf(metric, values) {
    const known = values.filter((value) => typeof value === "number");
    if (known.length < 2 || LESS_IS_NOT_BETTER.includes(metric)) return () => false;
    const least = Math.min(...known.map(Math.abs));
    const isLeast = (value) => typeof value === "number" && Math.abs(value) <= 1.05 * least;
    return known.every(isLeast) ? () => false : isLeast;
}

function numbersTable(scene) {
    const names = Object.keys(METRICS);
    const rank = (metric) => (names.includes(metric) ? names.indexOf(metric) : names.length);
    const metrics = [...new Set(scene.running.flatMap((engine) => Object.keys(engine.metrics)))]
        .filter((metric) => !MOMENTA.includes(metric) || scene.conserved.includes(metric))
        .filter((metric) => scene.running.some((engine) => typeof engine.metrics[metric] === "number"))
        .sort((a, b) => rank(a) - rank(b));
    const rows = metrics.map((metric) => {
        const compared = scene.running.filter((engine) => !isTruth(engine.name));
        const isBest = bestOf(metric, compared.map((engine) => engine.metrics[metric]));
        const head = rowHead(metricLabel(metric), " ", element("code", {}, metric));
        return element("tr", {}, head, ...scene.running.map((engine) => {
            const value = engine.metrics[metric];
            const best = !isTruth(engine.name) && isBest(value);
            return element("td", {class: best ? "number best" : "number"}, quantity(value, metricUnit(scene, metric)));
        }));
    });
    const heads = scene.running.map((engine) => columnHead(engineName(engine.name), true));
    return table([columnHead("Metric"), ...heads], rows);
}

function checksTable(scene) {
    if (scene.pass === null) return [element("caption", {}, notJudgedText("scene", scene))];
    const heads = [columnHead(element("span", {class: "unseen"}, "Verdict")), columnHead("Check"),
        columnHead("Engine"), columnHead("Metric"),
        columnHead("Value", true), columnHead("Limit", true), columnHead("Why this limit")];
    const rows = scene.outcomes.map((outcome) => element("tr", {class: outcome.pass ? null : "failing"},
        element("td", {}, verdictMark(outcome.pass)), element("td", {}, outcome.check),
        element("td", {}, engineName(outcome.engine)), element("td", {}, metricLabel(outcome.metric)),
        element("td", {class: "number"}, quantity(outcome.value, outcomeUnit(scene, outcome))),
        element("td", {class: "number"}, limitText(scene, outcome)),
        element("td", {class: "reason"}, outcome.reason ? `allowed because ${outcome.reason}` : "")));
    return table(heads, rows);
}

/// Shown as 1/60 s if the step is such a fraction.
function stepText(dt) {
    const rate = 1 / dt;
    const isWhole = rate > 1.5 && Math.abs(rate - Math.round(rate)) < 1e-6;
    return isWhole ? `1/${Math.round(rate)}${NO_BREAK}s` : quantity(dt, "s");
}

function settingsTable(scene) {
    // The closed form has a card of its own.
    const engines = scene.engines.filter((engine) => !isTruth(engine.name));
    const names = [...new Set(engines.flatMap((engine) => engine.settings.map(([name]) => name)))];
    const row = (name, value) => element("tr", {}, rowHead(name),
        ...engines.map((engine) => element("td", {}, value(engine) ?? NONE)));
    const same = (name, value) => element("tr", {}, rowHead(name), element("td", {colspan: engines.length}, value));
    const [gx, gy] = scene.gravity;
    return table([columnHead("Setting"), ...engines.map((engine) => columnHead(engineName(engine.name)))], [
        same("step", stepText(scene.dt)),
        same("gravity", `(${chosenQuantity(gx, "-", 4)}, ${chosenQuantity(gy, "-", 4)})${NO_BREAK}m/s²`),
        row("version", (engine) => engine.version || null),
        ...(engines.some(({hash}) => hash) ? [row("hash of the last state", (engine) => engine.hash ?? null)] : []),
        ...names.map((name) => row(name, (engine) => engine.settings.find(([key]) => key === name)?.[1])),
    ]);
}
