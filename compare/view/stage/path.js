// SPDX-License-Identifier: MIT
// Which path do the bodies of an engine take from start to end?

/// In very long runs some frames are skipped, because 200,000 points take a while to draw.
function frameStride(scene, engine) {
    return Math.max(1, Math.ceil((scene.ticks.length * engine.bodies.length) / 200000));
}

/// Made once for what is known of the run, in metres; the canvas scales it.
function wholePath(scene, engine, magnify) {
    const {path, ticks} = engine;
    if (path?.magnify === magnify && path.ticks === ticks) return path.way;
    const way = new Path2D();
    const frames = scene.ticks.length;
    const stride = frameStride(scene, engine);
    for (const body of engine.bodies) {
        let before = null;
        for (let frame = 0; frame < frames; frame += stride) {
            const pose = drawnPose(scene, engine, frame, body, magnify);
            if (!pose) continue;
            if (before && !isAround(scene, before, pose)) way.lineTo(pose.x, pose.y);
            else way.moveTo(pose.x, pose.y);
            before = pose;
        }
    }
    engine.path = {magnify, ticks, way};
    return way;
}

function drawWholePath(context, camera, view, engine) {
    context.save();
    context.transform(camera.scale, 0, 0, -camera.scale, camera.originX, camera.originY);
    context.lineWidth = (view.isPicture ? 1 : 1.5) / camera.scale;
    context.lineJoin = "round";
    context.setLineDash([]);
    context.globalAlpha = 0.3;
    context.stroke(wholePath(view.scene, engine, view.magnify));
    context.restore();
}
