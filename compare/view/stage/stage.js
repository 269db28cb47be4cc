// SPDX-License-Identifier: MIT
// How does one moment look, with all engines drawn over each other?

function stageTheme() {
    const text = Math.round(0.8 * parseFloat(getComputedStyle(document.documentElement).fontSize));
    const theme = {text, font: getComputedStyle(document.body).fontFamily};
    for (const name of ["paper", "minor", "major", "ruler", "still", "hatch", "ink", "muted", "water", "hazard"]) {
        theme[name] = themeColor(`--stage-${name}`);
    }
    theme.hatching = hatching(theme);
    return theme;
}

function traceShape(context, camera, shape, pose) {
    if (shape.circle) {
        const [x, y] = inWorld(pose, shape.circle[0], shape.circle[1]);
        const radius = shape.circle[2] * camera.scale;
        context.moveTo(camera.x(x) + radius, camera.y(y));
        context.arc(camera.x(x), camera.y(y), radius, 0, 2 * Math.PI);
        return;
    }
    const points = pointsInWorld(pose, pointsOf(shape));
    if (shape.radius > 0) {
        traceRounded(context, camera, points, shape.radius);
        return;
    }
    points.forEach(([x, y], i) => {
        if (i === 0) context.moveTo(camera.x(x), camera.y(y));
        else context.lineTo(camera.x(x), camera.y(y));
    });
    if (shape.polygon) context.closePath();
}

/// An arc around each corner, from the normal of the edge before it to that of the edge after it; a capsule is a polygon
/// of two corners. The canvas counts angles downwards.
function traceRounded(context, camera, corners, radius) {
    const count = corners.length;
    const normals = corners.map(([x, y], i) => {
        const [nextX, nextY] = corners[(i + 1) % count];
        return Math.atan2(x - nextX, nextY - y);
    });
    const last = normals[count - 1];
    context.moveTo(camera.x(corners[0][0] + radius * Math.cos(last)), camera.y(corners[0][1] + radius * Math.sin(last)));
    corners.forEach(([x, y], i) => {
        const before = normals[(i + count - 1) % count];
        context.arc(camera.x(x), camera.y(y), radius * camera.scale, -before, -normals[i], true);
    });
    context.closePath();
}

/// The edges at which the world continues on the opposite side; 0 for a direction without edges.
function drawSeams(context, camera, theme, [width, height]) {
    context.setLineDash([6, 6]);
    context.strokeStyle = theme.ink;
    context.lineWidth = 1.5;
    context.beginPath();
    for (const x of width > 0 ? [0, width] : []) {
        context.moveTo(camera.x(x), height > 0 ? camera.y(0) : 0);
        context.lineTo(camera.x(x), height > 0 ? camera.y(height) : camera.height);
    }
    for (const y of height > 0 ? [0, height] : []) {
        context.moveTo(width > 0 ? camera.x(0) : 0, camera.y(y));
        context.lineTo(width > 0 ? camera.x(width) : camera.width, camera.y(y));
    }
    context.stroke();
}

/// Is this farther than half the width or height? Then the way crossed an edge of the world.
function isAround(scene, before, after) {
    const [width, height] = scene.wrap ?? [0, 0];
    return width > 0 && Math.abs(after.x - before.x) > width / 2 ||
        height > 0 && Math.abs(after.y - before.y) > height / 2;
}

/// A spoke shows how a disc has turned. A body too small to see is drawn as a dot. leastArm: the least arm of a ghost's
/// cross [px].
function drawBody(context, camera, body, pose, look, leastArm) {
    context.beginPath();
    for (const shape of body.shapes) traceShape(context, camera, shape, pose);
    if (body.reach * camera.scale < 3) context.arc(camera.x(pose.x), camera.y(pose.y), 4, 0, 2 * Math.PI);
    if (look.filled) {
        context.globalAlpha = 0.28;
        context.fill();
        context.globalAlpha = 1;
    }
    for (const {circle} of look.ghost ? [] : body.shapes) {
        if (!circle) continue;
        const [x, y] = inWorld(pose, circle[0], circle[1]);
        const [rimX, rimY] = inWorld(pose, circle[0] + circle[2], circle[1]);
        context.moveTo(camera.x(x), camera.y(y));
        context.lineTo(camera.x(rimX), camera.y(rimY));
    }
    context.stroke();
    if (!look.ghost) return;
    const arm = Math.min(9, Math.max(leastArm, body.reach * camera.scale * 0.6));
    context.setLineDash([]);
    context.beginPath();
    context.moveTo(camera.x(pose.x) - arm, camera.y(pose.y));
    context.lineTo(camera.x(pose.x) + arm, camera.y(pose.y));
    context.moveTo(camera.x(pose.x), camera.y(pose.y) - arm);
    context.lineTo(camera.x(pose.x), camera.y(pose.y) + arm);
    context.stroke();
    context.setLineDash(look.dash);
}

/// The line that shows a joint: a rod or a slide from anchor to anchor, a rope over its pulleys, or the arm from a body
/// to its hinge.
function lineOf(joint, a, b, poseB) {
    if (joint.over) return [a, ...joint.over, b];
    return ["distance", "prismatic"].includes(joint.type) ? [a, b] : [b, [poseB.x, poseB.y]];
}

function drawJoint(context, camera, joint, poseA, poseB, radius) {
    const a = inWorld(poseA, joint.atA[0], joint.atA[1]);
    const b = inWorld(poseB, joint.atB[0], joint.atB[1]);
    context.beginPath();
    for (const [x, y] of lineOf(joint, a, b, poseB)) context.lineTo(camera.x(x), camera.y(y));
    context.stroke();
    context.setLineDash([]);
    for (const [x, y] of [a, b]) {
        context.beginPath();
        context.arc(camera.x(x), camera.y(y), radius, 0, 2 * Math.PI);
        context.stroke();
    }
}

/// The newest part of each path, with dots at equal intervals of time, as in a stroboscope photo.
function drawTrails(context, camera, view, engine, look) {
    const {scene, frame, magnify} = view;
    const most = Math.max(20, Math.floor(8000 / engine.bodies.length));
    const first = Math.max(0, frame - most);
    const flash = Math.max(1, Math.round(niceStep(scene.ticks.length / 60)));
    context.lineWidth = 1.5;
    for (const body of engine.bodies) {
        const dots = [];
        context.globalAlpha = 0.6;
        context.beginPath();
        let before = null;
        for (let at = first; at <= frame; ++at) {
            const pose = drawnPose(scene, engine, at, body, magnify);
            if (!pose) continue;
            const point = [camera.x(pose.x), camera.y(pose.y)];
            if (before && !isAround(scene, before, pose)) context.lineTo(...point);
            else context.moveTo(...point);
            before = pose;
            if (at % flash === 0) dots.push(point);
        }
        context.stroke();
        if (!look.filled || engine.bodies.length > 6) continue;
        context.globalAlpha = 0.8;
        context.beginPath();
        for (const [x, y] of dots) {
            context.moveTo(x + 2.5, y);
            context.arc(x, y, 2.5, 0, 2 * Math.PI);
        }
        context.fill();
    }
    context.globalAlpha = 1;
}

/// More bodies than this are drawn in batches, which is many times faster; the batch is the size that was fastest, of 1 to
/// all of them. Of bodies that are only a few pixels large the area is drawn alone, or the outline where that is the look.
const CROWD = 400;
const BATCH = 64;

/// As traceShape, without making anything on the way.
function tracePolygon(context, camera, points, {x, y, angle}) {
    const {scale, originX, originY} = camera;
    const c = Math.cos(angle), s = Math.sin(angle);
    for (let i = 0; i < points.length; i += 2) {
        const px = originX + scale * (x + c * points[i] - s * points[i + 1]);
        const py = originY - scale * (y + s * points[i] + c * points[i + 1]);
        if (i === 0) context.moveTo(px, py);
        else context.lineTo(px, py);
    }
    context.closePath();
}

function drawCrowd(context, camera, view, engine, look) {
    const {scene, frame, magnify} = view;
    const isSmall = scene.bodies[engine.bodies[0]].reach * camera.scale < 6;
    context.lineWidth = isSmall ? 0.5 : Math.min(look.width, 1.2);
    for (let first = 0; first < engine.bodies.length; first += BATCH) {
        context.beginPath();
        const end = Math.min(first + BATCH, engine.bodies.length);
        for (let slot = first; slot < end; ++slot) {
            const body = engine.bodies[slot], pose = drawnPose(scene, engine, frame, body, magnify);
            if (!pose) continue;
            for (const shape of scene.bodies[body].shapes) {
                if (shape.polygon && !(shape.radius > 0)) tracePolygon(context, camera, shape.polygon, pose);
                else traceShape(context, camera, shape, pose);
            }
        }
        if (look.filled) {
            context.globalAlpha = isSmall ? 0.6 : 0.28;
            context.fill();
            context.globalAlpha = 1;
        }
        if (!isSmall || !look.filled) context.stroke();
    }
}

function drawEngine(context, camera, view, engine) {
    const {scene, frame, magnify} = view;
    const look = lookOf(engine.name);
    context.strokeStyle = context.fillStyle = themeColor(look.color);
    context.setLineDash(look.dash);
    if (view.path) drawWholePath(context, camera, view, engine);
    if (view.trails) drawTrails(context, camera, view, engine, look);
    context.lineWidth = view.isPicture ? 0.6 * look.width : look.width;
    if (engine.bodies.length > CROWD) drawCrowd(context, camera, view, engine, look);
    else for (const body of engine.bodies) {
        const pose = drawnPose(scene, engine, frame, body, magnify);
        if (pose) drawBody(context, camera, scene.bodies[body], pose, look, view.isPicture ? 2 : 5);
    }
    drawJoints(context, camera, view, engine, look);
    drawArrows(context, camera, view, engine);
}

function drawJoints(context, camera, view, engine, look) {
    const {scene, frame, magnify} = view;
    context.lineWidth = view.isPicture ? 1 : Math.max(1.5, look.width * 0.7);
    for (const joint of scene.joints) {
        context.setLineDash(look.dash);
        const poseA = drawnPose(scene, engine, frame, joint.a, magnify);
        const poseB = drawnPose(scene, engine, frame, joint.b, magnify);
        if (poseA && poseB) drawJoint(context, camera, joint, poseA, poseB, view.isPicture ? 1.5 : 3.5);
    }
}

/// Gives the canvas the size at which it is shown; drawing uses the page's pixels.
function readyContext(canvas) {
    const {clientWidth: width, clientHeight: height} = canvas;
    const density = window.devicePixelRatio || 1;
    if (canvas.width !== Math.round(width * density)) canvas.width = Math.round(width * density);
    if (canvas.height !== Math.round(height * density)) canvas.height = Math.round(height * density);
    const context = canvas.getContext("2d");
    context.setTransform(density, 0, 0, density, 0, 0);
    return context;
}

/// view: scene, box, frame, hidden (a set of engine names), path, trails, the kinds of ARROWS, magnify, aim, tools,
/// pointer, overlay (draws more, on the context with the camera). isPicture: true for a small picture without rulers.
function drawStage(canvas, view) {
    const {clientWidth: width, clientHeight: height} = canvas;
    if (width === 0 || height === 0) return;
    const context = readyContext(canvas);
    const {theme} = view;
    const {text} = theme;
    const margins = view.isPicture ? {left: 2, right: 2, top: 2, bottom: 2}
        : {left: 3.4 * text, right: text, top: text, bottom: 2 * text};
    const camera = fitCamera(view.box, width, height, margins, aimOf(view));
    view.camera = camera;
    drawPaper(context, camera, theme, !view.isPicture);
    drawFields(context, camera, view);
    if (view.scene.wrap) drawSeams(context, camera, theme, view.scene.wrap);
    drawStill(context, camera, theme, view.scene, view.box);
    for (const engine of view.scene.running) {
        if (!view.hidden.has(engine.name)) drawEngine(context, camera, view, engine);
    }
    context.setLineDash([]);
    if (view.isPicture) return;
    view.overlay?.(context, camera);
    drawMomentumSum(context, camera, view);
    drawRulers(context, camera, theme);
    drawScaleBar(context, camera, theme);
    drawArrowKey(context, camera, view);
    drawTools(context, camera, view);
    drawReadout(context, camera, view);
}
