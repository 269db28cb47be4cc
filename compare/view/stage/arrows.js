// SPDX-License-Identifier: MIT
// How fast does each body move, and what pushes it? Shown as arrows, from differences of the played states.

/// The frames before and after, and this one. Null at the ends, across an edge of the world, and if the steps are
/// uneven.
function posesAround(scene, engine, frame, body) {
    const {times} = scene;
    if (frame < 1 || frame + 1 >= times.length) return null;
    const [before, now, after] = [-1, 0, 1].map((step) => poseOf(scene, engine, frame + step, body));
    if (!before || !now || !after || isAround(scene, before, now) || isAround(scene, now, after)) return null;
    const dt = (times[frame + 1] - times[frame - 1]) / 2;
    return Math.abs(times[frame + 1] - times[frame] - dt) < 0.01 * dt ? {before, now, after, dt} : null;
}

/// [m/s]
function velocityOf(scene, engine, frame, body) {
    const inside = Math.min(Math.max(frame, 1), scene.times.length - 2);
    const around = posesAround(scene, engine, inside, body);
    if (!around) return null;
    const {before, after, dt} = around;
    return [(after.x - before.x) / (2 * dt), (after.y - before.y) / (2 * dt)];
}

/// Less than this share of a body's weight is not drawn as a force. Some engines keep positions in floats: 10 m from the
/// origin they are rounded to 1 µm, which over steps of 1/60 s looks like 0.7 thousandths of the weight.
const LEAST_FORCE = 1e-3;

/// How large a force may look that is only the rounding of floats, of 24 bits, and of the positions in the page [N].
function roundingForce(scene, mass, {now, dt}) {
    const ofOne = scene.lengthStep / 2 + 2 ** -24 * Math.max(Math.abs(now.x), Math.abs(now.y));
    return (mass * 4 * ofOne) / dt ** 2;  // before - 2 now + after: four times the rounding of one
}

/// Mass times the change of velocity: the sum of all forces on the body [N]. Null if it may be rounding.
function netForceOf(scene, engine, frame, body) {
    const around = posesAround(scene, engine, frame, body);
    const {mass} = scene.bodies[body];
    if (!around || !mass) return null;
    const {before, now, after, dt} = around;
    const force = [after.x - 2 * now.x + before.x, after.y - 2 * now.y + before.y].map((x) => (mass * x) / dt ** 2);
    return Math.hypot(...force) > roundingForce(scene, mass, around) ? force : null;
}

/// The largest force on a body in the run, for scenes without gravity [N].
function largestForce(scene) {
    if (scene.largestForce !== undefined) return scene.largestForce;
    scene.largestForce = 0;
    const [engine] = scene.running;
    for (let frame = 1; engine && frame < scene.ticks.length; ++frame) {
        for (const body of engine.bodies) {
            const force = netForceOf(scene, engine, frame, body);
            if (force) scene.largestForce = Math.max(scene.largestForce, Math.hypot(...force));
        }
    }
    return scene.largestForce;
}

/// The force that is drawn: null if it is too small to mean anything.
function drawnForceOf(scene, engine, frame, body) {
    const force = netForceOf(scene, engine, frame, body);
    if (!force) return null;
    const usual = scene.bodies[body].mass * Math.hypot(...scene.gravity) || largestForce(scene);
    return Math.hypot(...force) >= LEAST_FORCE * usual ? force : null;
}

const ARROWS = {
    velocity: {of: velocityOf, unit: "m/s", width: 2.2, filled: true},
    force: {of: drawnForceOf, unit: "N", width: 1.4, filled: false},
};

/// The size that only a twentieth of the moments exceed: an impact must not make all other arrows too short to see.
function usualSize(scene, kind) {
    scene.arrowSizes ??= {};
    if (scene.arrowSizes[kind] !== undefined) return scene.arrowSizes[kind];
    const sizes = [];
    const [engine] = scene.running;
    const stride = Math.max(1, Math.floor(scene.ticks.length / 200));
    for (let frame = 1; engine && frame < scene.ticks.length; frame += stride) {
        for (const body of engine.bodies) {
            const vector = ARROWS[kind].of(scene, engine, frame, body);
            if (vector) sizes.push(Math.hypot(...vector));
        }
    }
    sizes.sort((a, b) => a - b);
    scene.arrowSizes[kind] = sizes[Math.floor(0.95 * sizes.length)] ?? 0;
    return scene.arrowSizes[kind];
}

function drawArrow(context, [x, y], [dx, dy], filled) {
    const length = Math.hypot(dx, dy);
    if (length < 3) return;
    const head = Math.min(9, 0.6 * length);
    const [ux, uy] = [dx / length, dy / length];
    const [neckX, neckY] = [x + dx - ux * head, y + dy - uy * head];
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(neckX, neckY);
    context.stroke();
    context.beginPath();
    context.moveTo(x + dx, y + dy);
    context.lineTo(neckX - uy * head * 0.45, neckY + ux * head * 0.45);
    context.lineTo(neckX + uy * head * 0.45, neckY - ux * head * 0.45);
    context.closePath();
    if (filled) context.fill();
    else context.stroke();
}

/// Pixels for one m/s or N; 0 if nothing moves.
function arrowScale(camera, scene, kind) {
    const usual = usualSize(scene, kind);
    return usual > 1e-9 ? (0.16 * Math.min(camera.width, camera.height)) / usual : 0;
}

function drawArrows(context, camera, view, engine) {
    const {scene, frame, magnify} = view;
    context.setLineDash([]);
    for (const kind of Object.keys(ARROWS).filter((name) => view[name])) {
        const {of, width, filled} = ARROWS[kind];
        const scale = arrowScale(camera, scene, kind);
        const most = 0.5 * Math.min(camera.width, camera.height);
        context.lineWidth = width;
        for (const body of engine.bodies) {
            const pose = drawnPose(scene, engine, frame, body, magnify);
            const vector = pose && of(scene, engine, frame, body);
            if (!vector) continue;
            const shrink = Math.min(1, most / (scale * Math.hypot(...vector) || 1));
            const [dx, dy] = vector.map((part) => part * scale * shrink);
            drawArrow(context, [camera.x(pose.x), camera.y(pose.y)], [dx, -dy], filled);
        }
    }
}

/// A key above the lower ruler: how long an arrow is for which speed and force.
function drawArrowKey(context, camera, view) {
    const {theme, scene} = view;
    let y = camera.height - camera.margins.bottom - theme.text;
    context.setLineDash([]);
    for (const kind of Object.keys(ARROWS).filter((name) => view[name])) {
        const scale = arrowScale(camera, scene, kind);
        if (scale === 0) continue;
        const {unit, width, filled} = ARROWS[kind];
        const size = niceStep(30 / scale);
        const x = camera.margins.left + 10;
        const label = `${chosenQuantity(size, unit)}${kind === "force" ? ", all forces together" : ""}`;
        context.strokeStyle = context.fillStyle = theme.ink;
        context.lineWidth = width;
        drawArrow(context, [x, y], [size * scale, 0], filled);
        labelOnPaper(context, theme, label, x + size * scale + 8, y, "left");
        y -= 1.7 * theme.text;
    }
}
