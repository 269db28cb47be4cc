// SPDX-License-Identifier: MIT
// How fast does each body move, and what pushes it? From what the engine says, or from differences of the played states.

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

/// Three numbers of a body at a frame, of those that the engine has for all of them; null if it does not have them.
function rowOf(scene, engine, numbers, frame, body) {
    const slot = engine.slots.get(body);
    if (!numbers || slot === undefined || scene.ticks[frame] >= engine.ticks) return null;
    const at = 3 * (frame * engine.bodies.length + slot);
    return Number.isFinite(numbers[at]) ? [numbers[at], numbers[at + 1], numbers[at + 2]] : null;
}

/// [m/s]
function velocityOf(scene, engine, frame, body) {
    if (engine.velocities) return rowOf(scene, engine, engine.velocities, frame, body)?.slice(0, 2) ?? null;
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

/// [m/s^2]
function accelerationOf(scene, engine, frame, body) {
    const {mass} = scene.bodies[body];
    return drawnForceOf(scene, engine, frame, body)?.map((part) => part / mass) ?? null;
}

/// [kg m/s]
function momentumOf(scene, engine, frame, body) {
    const {mass} = scene.bodies[body];
    return mass ? velocityOf(scene, engine, frame, body)?.map((part) => mass * part) ?? null : null;
}

const PUSHES = ["normal", "friction", "joint"];

/// What a force in a joint is called: by the kind of the joint.
function jointForceName(joint) {
    if (!joint) return "joint";
    if (joint.spring) return "spring";
    return {distance: "rod", pulley: "rope", revolute: "hinge", prismatic: "slide", wheel: "axle"}[joint.type] ?? joint.type;
}

/// Weight, and what contacts and joints do, where the engine tells: {body, at [m], force [N], name}. Nothing before the
/// first step.
function causesOf(scene, engine, frame) {
    const numbers = engine.pushesAt?.(frame);
    if (!numbers) return [];
    const causes = [];
    for (const body of engine.bodies) {
        const {mass} = scene.bodies[body], pose = poseOf(scene, engine, frame, body);
        if (mass && pose && Math.hypot(...scene.gravity) > 0) {
            causes.push({body, at: [pose.x, pose.y], force: scene.gravity.map((part) => mass * part), name: "weight"});
        }
    }
    for (let i = 0; i + 6 < numbers.length; i += 7) {
        const [cause, body, other, x, y, fx, fy] = numbers.subarray(i, i + 7);
        const joint = PUSHES[cause] === "joint" && scene.joints.find(({index}) => index === other);
        const name = PUSHES[cause] === "joint" ? jointForceName(joint) : PUSHES[cause];
        causes.push({body, at: [x, y], force: [fx, fy], name});
    }
    return causes;
}
