// SPDX-License-Identifier: MIT
// Where is a body, in one engine, at one frame of the playback?

/// Null if the engine does not have the body, or no longer has it.
function poseOf(scene, engine, frame, body) {
    const start = scene.bodies[body].start;
    if (scene.bodies[body].type === "static") return {x: start[0], y: start[1], angle: start[2]};
    const slot = engine.slots.get(body);
    if (slot === undefined || scene.ticks[frame] >= engine.ticks) return null;
    const at = 3 * (frame * engine.bodies.length + slot);
    const pose = {x: engine.poses[at], y: engine.poses[at + 1], angle: engine.poses[at + 2]};
    // A measured track has places alone: its body is drawn as it stood at the start.
    if (!Number.isFinite(pose.angle)) pose.angle = start[2];
    return Number.isFinite(pose.x + pose.y) ? pose : null;
}

/// Differences are measured from the closed form, or from Plumb if there is none.
function referenceEngine(scene, body) {
    const has = (engine) => engine.slots.has(body);
    return scene.running.find((engine) => isTruth(engine.name) && has(engine)) ??
        scene.running.find((engine) => isSubject(engine.name) && has(engine)) ?? null;
}

/// The pose with its difference from the reference drawn `magnify` times as large.
function drawnPose(scene, engine, frame, body, magnify) {
    const pose = poseOf(scene, engine, frame, body);
    const reference = magnify === 1 ? null : referenceEngine(scene, body);
    if (!pose || !reference || reference === engine) return pose;
    const from = poseOf(scene, reference, frame, body);
    if (!from) return pose;
    const away = (value, origin) => origin + magnify * (value - origin);
    return {x: away(pose.x, from.x), y: away(pose.y, from.y), angle: away(pose.angle, from.angle)};
}

/// A point of the body's frame, in the world.
function inWorld(pose, x, y) {
    const c = Math.cos(pose.angle);
    const s = Math.sin(pose.angle);
    return [pose.x + c * x - s * y, pose.y + s * x + c * y];
}

/// The numbers x, y, x, y, ... of a shape, as points of the world.
function pointsInWorld(pose, flat) {
    const points = [];
    for (let i = 0; i + 1 < flat.length; i += 2) points.push(inWorld(pose, flat[i], flat[i + 1]));
    return points;
}
