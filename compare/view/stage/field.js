// SPDX-License-Identifier: MIT
// Where do forces come from that no visible body exerts?

/// Fills the stage on the side of the surface to which gravity pulls.
function drawWater(context, camera, theme, {surface, down}) {
    const reach = 4 * (camera.width + camera.height);
    const [x, y] = [camera.x(surface[0]), camera.y(surface[1])];
    const [dx, dy] = [down[0] * reach, -down[1] * reach];
    context.beginPath();
    context.moveTo(x - dy, y + dx);
    context.lineTo(x + dy, y - dx);
    context.lineTo(x + dy + dx, y - dx + dy);
    context.lineTo(x - dy + dx, y + dx + dy);
    context.closePath();
    context.fillStyle = theme.water;
    context.fill();
}

/// Rings around a point that attracts, like a magnet on a map.
function drawPull(context, camera, theme, x, y) {
    context.strokeStyle = theme.muted;
    context.lineWidth = 1;
    context.setLineDash([3, 4]);
    for (const radius of [12, 20, 28]) {
        context.beginPath();
        context.arc(camera.x(x), camera.y(y), radius, 0, 2 * Math.PI);
        context.stroke();
    }
    context.setLineDash([]);
}

/// A magnet on a body is drawn where the first visible engine has that body.
function drawFields(context, camera, view) {
    const {scene, frame, magnify, theme} = view;
    const shown = scene.running.find((engine) => !view.hidden.has(engine.name));
    for (const field of scene.fields) {
        if (field.surface) drawWater(context, camera, theme, field);
        if (field.center && field.body === undefined) drawPull(context, camera, theme, ...field.center);
        const pose = field.body !== undefined && shown && drawnPose(scene, shown, frame, field.body, magnify);
        if (pose) drawPull(context, camera, theme, ...inWorld(pose, ...field.center));
    }
}
