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

/// A row a frame: t, then x, y, angle of each body in each engine.
function motionCsv(scene) {
    const columns = [];
    for (const engine of scene.running) {
        for (const body of engine.bodies) {
            for (const part of ["x", "y", "angle"]) columns.push({engine, body, part});
        }
    }
    const head = ["t", ...columns.map(({engine, body, part}) => `${engine.name}.${scene.bodies[body].name}.${part}`)];
    const rows = Array.from(scene.times, (t, frame) =>
        [t, ...columns.map(({engine, body, part}) => poseOf(scene, engine, frame, body)?.[part])]);
    return csvText([head, ...rows]);
}

/// A row a point: t, then error, divergence, energy and the probes of each engine.
function curvesCsv(scene) {
    const columns = [];
    for (const engine of scene.running) {
        for (const name of ["error", "divergence", "energy"]) {
            if (engine[name]) columns.push([`${engine.name}.${name}`, engine[name]]);
        }
        engine.probes.forEach((values, index) => {
            if (values) columns.push([`${engine.name}.probe.${scene.probes[index].name}`, values]);
        });
    }
    const rows = Array.from(scene.curveTimes, (t, i) => [t, ...columns.map(([, values]) => values[i])]);
    return csvText([["t", ...columns.map(([name]) => name)], ...rows]);
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
