// SPDX-License-Identifier: MIT
// What did each engine do at each moment? The data's numbers are unpacked when a scene is first opened.

function readReport() {
    return JSON.parse(byId("data").textContent);
}

/// Base64 of little-endian numbers; the page runs on little-endian machines, as all browsers' are.
function unpack(text, width) {
    if (text === null || text === undefined) return null;
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    return width === 4 ? new Float32Array(bytes.buffer) : new Float64Array(bytes.buffer);
}

function keptTicks(last, stride) {
    const ticks = [];
    for (let tick = 0; tick < last; tick += stride) ticks.push(tick);
    ticks.push(last);
    return ticks;
}

/// The moments of a curve's points: see compare/report/curve.h.
function curveTimes(scene) {
    const stride = scene.curveStride;
    if (stride === 1) return Float64Array.from({length: scene.steps + 1}, (_, tick) => tick * scene.dt);
    const count = 2 * Math.ceil((scene.steps + 1) / stride);
    const tick = (j) => Math.floor(j / 2) * stride + ((j % 2) * stride) / 2;
    return Float64Array.from({length: count}, (_, j) => tick(j) * scene.dt);
}

function unpackEngine(engine, scene) {
    if (engine.unsupported) return;
    engine.poses = unpack(engine.states, scene.width);
    engine.slots = new Map(engine.bodies.map((body, slot) => [body, slot]));
    for (const curve of ["error", "divergence", "energy"]) engine[curve] = unpack(engine[curve], 8);
    engine.probes = engine.probes.map((probe) => unpack(probe, 8));
    delete engine.states;
}

/// The numbers x, y, x, y, ... of every shape but a disc.
function pointsOf(shape) {
    return shape.polygon ?? shape.capsule ?? shape.segment ?? shape.chain ?? [];
}

/// The furthest point of a body from its origin, for the camera.
function reach(body) {
    let far = 0;
    for (const shape of body.shapes) {
        const {circle, radius = 0} = shape;
        if (circle) far = Math.max(far, Math.hypot(circle[0], circle[1]) + circle[2]);
        const points = pointsOf(shape);
        for (let i = 0; i < points.length; i += 2) far = Math.max(far, Math.hypot(points[i], points[i + 1]) + radius);
    }
    return far;
}

function unpackScene(scene) {
    if (scene.unpacked) return scene;
    scene.ticks = keptTicks(scene.steps, scene.stride);
    scene.times = Float64Array.from(scene.ticks, (tick) => tick * scene.dt);
    scene.curveTimes = curveTimes(scene);
    for (const engine of scene.engines) unpackEngine(engine, scene);
    for (const body of scene.bodies) body.reach = reach(body);
    scene.running = scene.engines.filter((engine) => !engine.unsupported);
    scene.unpacked = true;
    return scene;
}

/// The last index whose time is not after t; times rise.
function indexAt(times, t) {
    let low = 0;
    let high = times.length - 1;
    while (low < high) {
        const middle = (low + high + 1) >> 1;
        if (times[middle] <= t + 1e-9) low = middle;
        else high = middle - 1;
    }
    return low;
}
