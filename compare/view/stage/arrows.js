// SPDX-License-Identifier: MIT
// How are velocities and forces drawn? As arrows, with a key that says how long an arrow is.

/// Kinds of one scale have their lengths in common.
const ARROWS = {
    velocity: {of: velocityOf, unit: "m/s", width: 2.2, filled: true, scale: "velocity"},
    components: {of: velocityOf, unit: "m/s", width: 1.4, filled: false, scale: "velocity"},
    acceleration: {of: accelerationOf, unit: "m/s²", width: 1.4, filled: true, scale: "acceleration"},
    momentum: {of: momentumOf, unit: "kg m/s", width: 3, filled: true, scale: "momentum"},
    force: {of: drawnForceOf, unit: "N", width: 1.4, filled: false, scale: "force"},
    causes: {unit: "N", width: 1.4, filled: true, scale: "force"},
};

function arrowsShown(view) {
    return Object.keys(ARROWS).filter((kind) => view[kind]);
}

/// The sizes of all forces, each by itself, at moments of the run.
function causeSizes(scene, engine, stride) {
    const sizes = [];
    for (let frame = 1; frame < Math.min(scene.ticks.length, engine.ticks); frame += 4 * stride) {
        for (const {force} of causesOf(scene, engine, frame)) {
            const size = Math.hypot(...force);
            if (size > 0) sizes.push(size);
        }
    }
    return sizes;
}

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
    if (kind === "force" && engine?.pushesAt) sizes.push(...causeSizes(scene, engine, stride));
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

/// Pixels for one unit; 0 if nothing moves. Forces that cancel out would make others endless: so a weight counts, too.
function arrowScale(camera, scene, kind) {
    const {scale} = ARROWS[kind];
    const heaviest = Math.max(0, ...scene.bodies.map(({mass}) => mass ?? 0)) * Math.hypot(...scene.gravity);
    const usual = Math.max(usualSize(scene, scale), scale === "force" ? heaviest : 0);
    return usual > 1e-9 ? (0.16 * Math.min(camera.width, camera.height)) / usual : 0;
}

/// What the arrows of a kind are at a frame: {at [m], vector, name}.
function arrowsOf(view, engine, kind) {
    const {scene, frame, magnify} = view;
    if (kind === "causes") {
        const causes = magnify === 1 ? causesOf(scene, engine, frame) : [];
        return causes.map(({at, force, name}) => ({at, vector: force, name}));
    }
    return engine.bodies.flatMap((body) => {
        const pose = drawnPose(scene, engine, frame, body, magnify);
        const vector = pose && ARROWS[kind].of(scene, engine, frame, body);
        if (!vector) return [];
        const at = [pose.x, pose.y], [x, y] = vector;
        return kind === "components" ? [{at, vector: [x, 0]}, {at, vector: [0, y]}] : [{at, vector}];
    });
}

const MOST_NAMES = 10;  // more would lie over each other

function drawArrows(context, camera, view, engine) {
    context.setLineDash([]);
    for (const kind of arrowsShown(view)) {
        const {width, filled} = ARROWS[kind];
        const scale = arrowScale(camera, view.scene, kind);
        const most = 0.5 * Math.min(camera.width, camera.height);
        const labels = [];
        context.lineWidth = width;
        for (const {at, vector, name} of arrowsOf(view, engine, kind)) {
            const shrink = Math.min(1, most / (scale * Math.hypot(...vector) || 1));
            const [dx, dy] = vector.map((part) => part * scale * shrink);
            const from = [camera.x(at[0]), camera.y(at[1])];
            drawArrow(context, from, [dx, -dy], filled);
            if (name && Math.hypot(dx, dy) >= 4)
                labels.push([`${say(name)} ${quantity(Math.hypot(...vector), "N")}`, from[0] + dx, from[1] - dy, dx, dy]);
        }
        if (engine === guideOf(view) && labels.length <= MOST_NAMES) drawArrowNames(context, camera, view.theme, labels);
    }
}

/// Each at the tip of its arrow, or a line or more farther up or down, where no other stands; on the stage.
function drawArrowNames(context, camera, theme, labels) {
    context.save();
    const text = 0.85 * theme.text, line = 1.15 * text, taken = [];
    context.font = `${text}px ${theme.font}`;
    for (const [name, tipX, tipY, dx, dy] of labels) {
        const side = dx < 0 ? -1 : 1, width = context.measureText(name).width;
        const x = tipX + 6 * side, left = side < 0 ? x - width : x;
        const meets = (y) => taken.some((other) => Math.abs(other.y - y) < line &&
            other.left < left + width + 2 && left < other.left + other.width + 2);
        const bottom = camera.height - camera.margins.bottom - line;
        let y = Math.min(Math.max(tipY, camera.margins.top + line), bottom);
        const way = dy > 0 || y > bottom - 2 * line ? -1 : 1;
        for (let tries = 0; tries < labels.length && meets(y); ++tries) y += way * line;
        taken.push({left, width, y});
        labelOnPaper(context, {...theme, text}, name, x, y, side < 0 ? "right" : "left");
    }
    context.restore();
}

/// The momenta of all bodies tip to tail, and their sum, in a corner of the stage. In scenes of two to six bodies.
function drawMomentumSum(context, camera, view) {
    const engine = guideOf(view);
    if (!view.momentum || !engine) return;
    const momenta = engine.bodies.map((body) => momentumOf(view.scene, engine, view.frame, body)).filter(Boolean);
    if (momenta.length < 2 || momenta.length > 6) return;
    const scale = arrowScale(camera, view.scene, "momentum");
    const start = [camera.margins.left + 0.2 * camera.width, camera.margins.top + 0.16 * camera.height];
    let [x, y] = start;
    context.strokeStyle = context.fillStyle = themeColor(lookOf(engine.name).color);
    context.lineWidth = 1.5;
    context.setLineDash([]);
    for (const [px, py] of momenta) {
        drawArrow(context, [x, y], [px * scale, -py * scale], true);
        [x, y] = [x + px * scale, y - py * scale];
    }
    context.strokeStyle = context.fillStyle = view.theme.ink;
    context.lineWidth = 3;
    drawArrow(context, start, [x - start[0], y - start[1]], false);
    const sum = Math.hypot(...[0, 1].map((part) => momenta.reduce((total, p) => total + p[part], 0)));
    const text = `${say("sum of momenta")}: ${quantity(sum, "kg m/s")}`;
    labelOnPaper(context, view.theme, text, start[0], start[1] - 1.6 * view.theme.text, "left");
}

const KEY_WORDS = {force: "all forces together", causes: "each force", acceleration: "acceleration"};

/// A key above the lower ruler: how long an arrow is for which speed and force.
function drawArrowKey(context, camera, view) {
    const {theme, scene} = view;
    let y = camera.height - camera.margins.bottom - theme.text;
    context.setLineDash([]);
    for (const kind of arrowsShown(view)) {
        const scale = arrowScale(camera, scene, kind);
        if (scale === 0 || (kind === "causes" && view.force) || (kind === "components" && view.velocity)) continue;
        const {unit, width, filled} = ARROWS[kind];
        const size = niceStep(30 / scale);
        const x = camera.margins.left + 10;
        const label = chosenQuantity(size, unit) + (KEY_WORDS[kind] ? `, ${say(KEY_WORDS[kind])}` : "");
        context.strokeStyle = context.fillStyle = theme.ink;
        context.lineWidth = width;
        drawArrow(context, [x, y], [size * scale, 0], filled);
        labelOnPaper(context, theme, label, x + size * scale + 8, y, "left");
        y -= 1.7 * theme.text;
    }
}
