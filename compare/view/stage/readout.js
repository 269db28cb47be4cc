// SPDX-License-Identifier: MIT
// What is at the pointer? A moment of a body's way: its time, place and speed, between two steps too, and the moments at
// which the body is highest or hits something.

const REACH = 14;  // of the pointer [px]
const MOST_BODIES = 12;  // whose ways are looked at

/// The cubic through two values with these slopes at the ends of h (Hermite), at the share s of it.
function hermite(s, h, [x0, v0], [x1, v1]) {
    const [a, b] = [s * s * (3 - 2 * s), s * (1 - s)];
    return (1 - a) * x0 + a * x1 + h * b * ((1 - s) * v0 - s * v1);
}

/// Position and velocity at the share s of the step after a frame; null if they are not known.
function stateBetween(scene, engine, frame, body, s) {
    const at = [frame, frame + 1].map((each) => ({pose: poseOf(scene, engine, each, body),
        velocity: velocityOf(scene, engine, each, body)}));
    const [a, b] = at;
    if (!a.pose || !b.pose || isAround(scene, a.pose, b.pose)) return null;
    const h = scene.times[frame + 1] - scene.times[frame];
    const time = scene.times[frame] + s * h;
    // Where steps are counted, as those of a search, they are not the moments of one flight.
    if (scene.countsSteps || !a.velocity || !b.velocity) {
        return {time, x: a.pose.x + s * (b.pose.x - a.pose.x), y: a.pose.y + s * (b.pose.y - a.pose.y), velocity: null};
    }
    const part = (name, i) => hermite(s, h, [a.pose[name], a.velocity[i]], [b.pose[name], b.velocity[i]]);
    const velocity = [0, 1].map((i) => a.velocity[i] + s * (b.velocity[i] - a.velocity[i]));
    return {time, x: part("x", 0), y: part("y", 1), velocity};
}

/// The change of a body's velocity in the step after a frame, beside what gravity does; null if it is not known [m/s].
function jumpAfter(scene, engine, frame, body) {
    if (frame < 0 || frame + 1 >= scene.times.length) return null;
    const [before, after] = [frame, frame + 1].map((each) => velocityOf(scene, engine, each, body));
    const h = scene.times[frame + 1] - scene.times[frame];
    return before && after && after.map((v, i) => v - before[i] - scene.gravity[i] * h);
}

/// Where in a step a body hits: its velocity jumps there, and not in the steps beside it. Its flight before and its
/// flight after meet then, along the jump. The share of the step, or null where nothing hits.
function impactShare(scene, engine, frame, body) {
    const jump = jumpAfter(scene, engine, frame, body);
    const beside = [frame - 1, frame + 1].map((each) => jumpAfter(scene, engine, each, body));
    const size = jump && Math.hypot(...jump);
    if (!jump || size < 0.05 || beside.some((other) => other && 5 * Math.hypot(...other) > size)) return null;
    const [a, b] = [frame, frame + 1].map((each) => poseOf(scene, engine, each, body));
    const [va, vb] = [frame, frame + 1].map((each) => velocityOf(scene, engine, each, body));
    if (!a || !b || isAround(scene, a, b)) return null;
    const h = scene.times[frame + 1] - scene.times[frame];
    const along = ([x, y]) => (x * jump[0] + y * jump[1]) / size;
    const g = along(scene.gravity), way = along([b.x - a.x, b.y - a.y]);
    const s = (way - along(vb) * h + g * h * h / 2) / (along(va) - along(vb) + g * h) / h;
    return s >= 0 && s <= 1 ? s : null;
}

/// The moments of a body's way that a person asks for: {name, time, x, y, velocity}. Kept until more is known.
function momentsOf(scene, engine, body) {
    engine.moments ??= new Map();
    const kept = engine.moments.get(body);
    if (kept?.ticks === engine.ticks) return kept.moments;
    const moments = [];
    if (scene.countsSteps) return moments;
    const g = Math.hypot(...scene.gravity);
    const up = g > 0 ? scene.gravity.map((part) => -part / g) : null;
    for (let frame = 0; frame + 1 < scene.times.length && moments.length < 60; ++frame) {
        const share = impactShare(scene, engine, frame, body);
        const before = velocityOf(scene, engine, frame, body), after = velocityOf(scene, engine, frame + 1, body);
        if (!before || !after) continue;
        if (share !== null) {
            const s = share, h = scene.times[frame + 1] - scene.times[frame], from = poseOf(scene, engine, frame, body);
            const place = [from.x, from.y].map((x, i) => x + before[i] * s * h + scene.gravity[i] * (s * h) ** 2 / 2);
            moments.push({name: "hits", time: scene.times[frame] + s * h, x: place[0], y: place[1], velocity: before});
            continue;
        }
        const rise = up && [before, after].map((v) => v[0] * up[0] + v[1] * up[1]);
        if (!up || !(rise[0] > 0 && rise[1] <= 0)) continue;
        const state = stateBetween(scene, engine, frame, body, rise[0] / (rise[0] - rise[1]));
        if (state) moments.push({name: "highest", ...state});
    }
    engine.moments.set(body, {ticks: engine.ticks, moments});
    return moments;
}

/// The moment nearest to a point of the stage, or null: {engine, body, name, time, x, y, velocity}.
function momentAt(view, px, py) {
    const {scene, camera} = view;
    let best = null;
    const take = (engine, body, state, bonus = 0) => {
        const far = Math.hypot(camera.x(state.x) - px, camera.y(state.y) - py) - bonus;
        // Of ways that lie on each other the first engine's counts.
        const nearer = best ? best.far - (best.engine === engine ? 0 : 2) : Infinity;
        if (far <= REACH - bonus && far < nearer) best = {far, engine, body, ...state};
    };
    for (const engine of scene.running) {
        if (view.hidden.has(engine.name) || engine.bodies.length > MOST_BODIES) continue;
        const last = Math.min(scene.times.length, engine.ticks) - 1;
        for (const body of engine.bodies) {
            for (let frame = 0; frame < last; ++frame) {
                const from = poseOf(scene, engine, frame, body), to = poseOf(scene, engine, frame + 1, body);
                if (!from || !to || isAround(scene, from, to)) continue;
                const [x, y] = [camera.x(from.x), camera.y(from.y)];
                const [dx, dy] = [camera.x(to.x) - x, camera.y(to.y) - y];
                const s = Math.min(1, Math.max(0, ((px - x) * dx + (py - y) * dy) / (dx * dx + dy * dy || 1)));
                if (Math.hypot(x + s * dx - px, y + s * dy - py) > REACH) continue;
                const state = stateBetween(scene, engine, frame, body, s);
                if (state) take(engine, body, state);
            }
            for (const moment of momentsOf(scene, engine, body)) take(engine, body, moment, 8);
        }
    }
    return best;
}

/// What is said of the moment, line by line.
function momentLines(scene, {engine, body, name, time, x, y, velocity}) {
    const where = `x ${rulerText(x, "m")}   y ${rulerText(y, "m")}`;
    const lines = [`${say(lookOf(engine.name).label)}: ${say(scene.bodies[body].name)}${name ? `, ${say(name)}` : ""}`,
        scene.countsSteps ? where : `t ${numberText(time.toFixed(4))}${NO_BREAK}s   ${where}`];
    if (velocity) lines.push(`v ${quantity(Math.hypot(...velocity), "m/s", 4)}   ` +
        `(${velocity.map((part) => withDigits(part, 4)).join(", ")})${NO_BREAK}m/s`);
    return lines;
}

/// Rings at the moments of few bodies, and the text at the pointer.
function drawReadout(context, camera, view) {
    const {scene, theme, pointer} = view;
    if (view.path) for (const engine of scene.running) {
        if (view.hidden.has(engine.name) || engine.bodies.length > 3) continue;
        context.strokeStyle = themeColor(lookOf(engine.name).color);
        context.lineWidth = 1.5;
        for (const body of engine.bodies) for (const {x, y} of momentsOf(scene, engine, body)) {
            context.beginPath();
            context.arc(camera.x(x), camera.y(y), 3.5, 0, 2 * Math.PI);
            context.stroke();
        }
    }
    const moment = pointer && momentAt(view, ...pointer);
    if (!moment) return;
    const lines = momentLines(scene, moment), [x, y] = [camera.x(moment.x), camera.y(moment.y)];
    context.fillStyle = themeColor(lookOf(moment.engine.name).color);
    context.beginPath();
    context.arc(x, y, 4, 0, 2 * Math.PI);
    context.fill();
    drawNote(context, camera, theme, lines, x, y);
}

/// A note beside a point of the stage, kept within it.
function drawNote(context, camera, theme, lines, x, y) {
    context.font = `${theme.text}px ${theme.font}`;
    const width = Math.max(...lines.map((line) => context.measureText(line).width)) + 16;
    const height = 1.45 * theme.text * lines.length + 10;
    const left = x + 14 + width < camera.width ? x + 14 : Math.max(4, x - 14 - width);
    const top = Math.min(Math.max(4, y - height - 10), camera.height - height - 4);
    context.fillStyle = theme.paper;
    context.strokeStyle = theme.muted;
    context.lineWidth = 1;
    context.beginPath();
    context.rect(left, top, width, height);
    context.fill();
    context.stroke();
    context.fillStyle = theme.ink;
    context.textAlign = "left";
    context.textBaseline = "middle";
    lines.forEach((line, i) => context.fillText(line, left + 8, top + 5 + 1.45 * theme.text * (i + 0.5)));
}
