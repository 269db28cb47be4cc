// SPDX-License-Identifier: MIT
// How do the page's numbers get into a spreadsheet?

function csvField(value) {
    if (value === null || value === undefined || (typeof value === "number" && Number.isNaN(value))) return "";
    const text = String(value);
    return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

function csvText(rows) {
    return rows.map((row) => row.map(csvField).join(",")).join("\n") + "\n";
}

/// As many digits as the number has.
function floatField(x) {
    return Number.isFinite(x) ? Number(x.toPrecision(7)) : null;
}

/// The columns of one body: its state, and its velocity, from differences of the played states where that is all there
/// is.
function bodyColumns(scene, engine, body) {
    const {name} = scene.bodies[body];
    const rate = (frame, part) => {
        if (engine.velocities) {
            return rowOf(scene, engine, engine.velocities, frame, body)?.[["x", "y", "angle"].indexOf(part)] ?? null;
        }
        const [a, b] = [Math.max(frame - 1, 0), Math.min(frame + 1, scene.times.length - 1)];
        const [from, to] = [a, b].map((at) => poseOf(scene, engine, at, body));
        if (!from || !to || a === b || isAround(scene, from, to)) return null;
        return floatField((to[part] - from[part]) / (scene.times[b] - scene.times[a]));
    };
    const state = (frame, part) => poseOf(scene, engine, frame, body)?.[part];
    return [["x", "m", state, "x"], ["y", "m", state, "y"], ["angle", "rad", state, "angle"],
        ["vx", "m/s", rate, "x"], ["vy", "m/s", rate, "y"], ["spin", "rad/s", rate, "angle"]]
        .map(([what, unit, of, part]) => ({head: `${name}.${what} [${unit}]`, at: (frame) => of(frame, part)}));
}

/// One engine's run, one row per frame: t, its bodies, its energies, the probes, the forces in joints, and
/// the distance to the closed form.
function runCsv(scene, engine) {
    const curve = (head, values) => (values
        ? [{head, at: (frame) => floatField(values[indexAt(scene.curveTimes, scene.times[frame])])}] : []);
    const columns = [
        ...engine.bodies.flatMap((body) => bodyColumns(scene, engine, body)),
        ...(engine.energies.length > 0 ? [] : curve("energy [J]", engine.energy)),
        ...engine.energies.flatMap(({name, values}) => curve(`energy.${name} [J]`, values)),
        ...scene.probes.flatMap(({name, unit}, i) => curve(`probe.${name} [${unit}]`, engine.probes[i])),
        ...engine.forces.flatMap(({name, values}) => curve(`${name}.force [N]`, values)),
        ...(isTruth(engine.name) ? [] : curve("to_truth [m]", engine.error)),
    ];
    const rows = Array.from(scene.times, (t, frame) => [t, ...columns.map(({at}) => at(frame))]);
    return csvText([["t [s]", ...columns.map(({head}) => head)], ...rows]);
}

function numbersCsv(scenes) {
    const rows = [["scene", "engine", "metric", "value", "unit"]];
    for (const scene of scenes) {
        for (const engine of scene.engines) {
            for (const [metric, value] of Object.entries(engine.metrics)) {
                if (value !== null) rows.push([scene.name, engine.name, metric, value, metricUnit(scene, metric)]);
            }
        }
    }
    return csvText(rows);
}
