// SPDX-License-Identifier: MIT
// What is plotted over time? A curve is {times, lines: [{engine, values}], unit}.

function engineCurve(scene, name, unit) {
    const lines = scene.running.filter((engine) => engine[name])
        .map((engine) => ({engine: engine.name, values: engine[name]}));
    return {times: scene.curveTimes, lines, unit};
}

function errorCurve(scene) {
    const curve = engineCurve(scene, "error", "m");
    curve.lines = curve.lines.filter((line) => !isTruth(line.engine));
    return curve;
}

/// Plumb's distance from itself is always 0, so it is left out.
function divergenceCurve(scene) {
    const curve = engineCurve(scene, "divergence", "m");
    curve.lines = curve.lines.filter((line) => !isSubject(line.engine) && !isTruth(line.engine));
    return curve;
}

function probeCurve(scene, index) {
    const lines = scene.running.filter((engine) => engine.probes[index])
        .map((engine) => ({engine: engine.name, values: engine.probes[index]}));
    return {times: scene.curveTimes, lines, unit: scene.probes[index].unit, ruler: true};
}

/// What may be plotted of a body, with its unit.
const PARTS = {x: "m", y: "m", angle: "rad", vx: "m/s", vy: "m/s", speed: "m/s"};

function partOf(scene, engine, frame, body, part) {
    if (part in {x: 0, y: 0, angle: 0}) return poseOf(scene, engine, frame, body)?.[part] ?? NaN;
    const velocity = velocityOf(scene, engine, frame, body);
    if (!velocity) return NaN;
    return part === "speed" ? Math.hypot(...velocity) : velocity[part === "vx" ? 0 : 1];
}

function motionCurve(scene, body, part) {
    const lines = scene.running.filter((engine) => engine.slots.has(body)).map((engine) => ({engine: engine.name,
        values: Array.from(scene.ticks, (_, frame) => partOf(scene, engine, frame, body, part))}));
    return {times: scene.times, lines, unit: PARTS[part], ruler: true};
}

/// What a person may plot: the scene's own quantities first, then those of each body.
function motionChoices(scene) {
    const choices = scene.probes.map((probe, index) => ({
        group: "Probes", label: `${probe.name} [${probe.unit}]`, axis: probe.name, unit: probe.unit,
        curve: () => probeCurve(scene, index),
    })).filter((choice) => choice.curve().lines.length > 0);
    scene.bodies.forEach((body, index) => {
        if (body.type === "static") return;
        for (const [part, unit] of Object.entries(PARTS)) {
            choices.push({group: body.name, label: `${part} of ${body.name} [${unit}]`, axis: part, body: index, part,
                curve: () => motionCurve(scene, index, part)});
        }
    });
    return choices;
}

/// The kinds of energy of one engine, one on top of the other. Where the energy of a place is 0 is free: it is the least
/// of the run here.
function stackedEnergies(scene, engine) {
    const looks = {width: 1, dash: []};
    const lines = engine.energies.map(({name, values}) => {
        const least = values.reduce((low, value) => (value < low ? value : low), Infinity);
        const above = Array.from(values, (value) => value - (["potential", "fields"].includes(name) ? least : 0));
        return {engine: name, values: above, drawn: above, look: {...looks, label: name, color: `--energy-${name}`}};
    });
    const sums = Array.from(scene.curveTimes, (_, i) => lines.reduce((sum, {values}) => sum + (values[i] || 0), 0));
    const most = sums.reduce((high, sum) => Math.max(high, sum), 1e-9);
    return {times: scene.curveTimes, lines, unit: "J", ruler: true, stacked: true, range: [0, 1.1 * most],
        logarithmic: false};
}

function spread(values) {
    let low = Infinity;
    let high = -Infinity;
    for (const value of values) {
        if (!Number.isFinite(value)) continue;
        low = Math.min(low, value);
        high = Math.max(high, value);
    }
    return high > low ? high - low : 0;
}

/// An angle that the scene watches; else the direction in which the first body moves the most. If that body hardly
/// moves, another watched quantity.
function firstChoice(choices) {
    const watched = choices.filter((choice) => choice.body === undefined);
    const angle = watched.find((choice) => choice.unit === "rad");
    const body = choices.find((choice) => choice.body !== undefined)?.body;
    if (angle || body === undefined) return angle ?? watched[0];
    const parts = choices.filter((choice) => choice.body === body && (choice.part === "x" || choice.part === "y"));
    const [x, y] = parts.map((choice) => spread(choice.curve().lines[0]?.values ?? []));
    if (watched.length > 0 && Math.max(x, y) < 0.05) return watched[0];
    return x > y ? parts[0] : parts[1];
}

/// Distances over many powers of ten are drawn on a logarithmic axis, which has no 0: a value of 0 after the start is
/// drawn at the lowest power shown.
function logarithmic(curve, limit) {
    let least = Infinity;
    let most = -Infinity;
    for (const {values} of curve.lines) {
        for (const value of values) {
            if (!(value > 0) || !Number.isFinite(value)) continue;
            least = Math.min(least, value);
            most = Math.max(most, value);
        }
    }
    if (limit > 0) most = Math.max(most, limit);
    // Distances below 1e-16 m mean nothing for doubles near 1 m.
    const bottom = Math.max(-16, Math.floor(Math.log10(Math.min(least, most, 1e-3))));
    const low = Number.isFinite(bottom) ? bottom : -16;
    const high = Math.max(low + 1, Number.isFinite(most) ? Math.ceil(Math.log10(most) + 0.05) : -3);
    const floor = 10 ** low;
    const lines = curve.lines.map(({engine, values}) => ({
        engine,
        values,
        drawn: Array.from(values, (value, i) => (value >= floor ? value : i > 0 && value >= 0 ? floor : NaN)),
    }));
    return {...curve, lines, range: [floor, 10 ** high], logarithmic: true};
}

/// A constant must look constant: the axis spans at least a fiftieth of the values' size.
function linear(curve) {
    let low = Infinity;
    let high = -Infinity;
    for (const {values} of curve.lines) {
        for (const value of values) {
            if (!Number.isFinite(value)) continue;
            low = Math.min(low, value);
            high = Math.max(high, value);
        }
    }
    if (!(low <= high)) [low, high] = [-1, 1];
    const least = Math.max(0.02 * Math.max(Math.abs(low), Math.abs(high)), 1e-9);
    const middle = (low + high) / 2;
    const half = Math.max(high - low, least) / 2;
    const lines = curve.lines.map((line) => ({...line, drawn: line.values}));
    return {...curve, lines, range: [middle - 1.12 * half, middle + 1.12 * half], logarithmic: false};
}
