// SPDX-License-Identifier: MIT
// How does what never moves look? Floors and walls, and tiles by their kinds.

function hatching(theme) {
    const tile = element("canvas", {width: 8, height: 8});
    const context = tile.getContext("2d");
    context.fillStyle = theme.still;
    context.fillRect(0, 0, 8, 8);
    context.strokeStyle = theme.hatch;
    context.lineWidth = 1.2;
    for (const shift of [-8, 0, 8]) {
        context.moveTo(shift, 8);
        context.lineTo(shift + 8, 0);
    }
    context.stroke();
    return context.createPattern(tile, "repeat");
}

/// Short strokes on the side away from a point, as a textbook draws a floor.
function hatchSegment(context, camera, away, [x0, y0], [x1, y1]) {
    const from = [camera.x(x0), camera.y(y0)];
    const along = [camera.x(x1) - from[0], camera.y(y1) - from[1]];
    const length = Math.hypot(...along);
    const [ux, uy] = [along[0] / length, along[1] / length];
    const other = [camera.x(away[0]) - from[0], camera.y(away[1]) - from[1]];
    const side = ux * other[1] - uy * other[0] > 0 ? -1 : 1;
    for (let at = 6; at < length; at += 11) {
        const [x, y] = [from[0] + at * ux, from[1] + at * uy];
        if (x < 0 || x > camera.width || y < 0 || y > camera.height) continue;
        context.moveTo(x, y);
        context.lineTo(x - 7 * ux - 9 * side * uy, y - 7 * uy + 9 * side * ux);
    }
}

/// awayOf(from, to) is a point on the side that is not hatched.
function hatchLine(context, camera, theme, line, pose, awayOf) {
    context.beginPath();
    for (let i = 0; i + 3 < line.length; i += 2) {
        const [from, to] = [inWorld(pose, line[i], line[i + 1]), inWorld(pose, line[i + 2], line[i + 3])];
        hatchSegment(context, camera, awayOf(from, to), from, to);
    }
    context.strokeStyle = theme.hatch;
    context.lineWidth = 1.5;
    context.stroke();
}

/// A piece of a tile map, an area or a stretch of the outline, which has what is filled on its left. Areas have no
/// edges of their own, but for sensors, which are dashed; of what is solid one way only there is its top.
function drawTiles(context, camera, theme, shape, pose) {
    const [sensor, hazard, oneWay] = ["sensor", "hazard", "oneWay"].map((kind) => shape.tiles === kind);
    context.beginPath();
    traceShape(context, camera, shape, pose);
    if (shape.polygon && !sensor) {
        context.fillStyle = hazard ? theme.hazard : theme.hatching;
        context.globalAlpha = hazard ? 0.35 : 1;
        context.fill();
        context.globalAlpha = 1;
        return;
    }
    context.setLineDash(sensor ? [4, 4] : []);
    context.strokeStyle = hazard ? theme.hazard : sensor ? theme.muted : theme.ink;
    context.lineWidth = oneWay ? 3 : hazard ? 2.5 : 1.5;
    context.stroke();
    context.setLineDash([]);
    const onRight = ([x0, y0], [x1, y1]) => [x0 + y1 - y0, y0 + x0 - x1];
    if (oneWay) hatchLine(context, camera, theme, shape.segment, pose, onRight);
}

function drawStillShape(context, camera, theme, shape, pose, middle) {
    context.beginPath();
    traceShape(context, camera, shape, pose);
    const line = shape.segment ?? shape.chain;
    context.fillStyle = theme.hatching;
    if (!line) context.fill();
    context.strokeStyle = theme.ink;
    context.lineWidth = line ? 3 : 1.5;
    context.stroke();
    if (line) hatchLine(context, camera, theme, line, pose, () => middle);
}

function drawStill(context, camera, theme, scene, box) {
    context.setLineDash([]);
    context.lineJoin = "round";
    const middle = [(box.left + box.right) / 2, (box.bottom + box.top) / 2];
    for (const {type, start, shapes} of scene.bodies) {
        if (type !== "static") continue;
        const pose = {x: start[0], y: start[1], angle: start[2]};
        const tiles = shapes.filter((shape) => shape.tiles);
        for (const area of tiles.filter(({polygon}) => polygon)) drawTiles(context, camera, theme, area, pose);
        for (const edge of tiles.filter(({segment}) => segment)) drawTiles(context, camera, theme, edge, pose);
        for (const shape of shapes) if (!shape.tiles) drawStillShape(context, camera, theme, shape, pose, middle);
    }
}
