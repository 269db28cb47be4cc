// SPDX-License-Identifier: MIT
// How do things that never move look? Floors and walls, and tiles by their kinds.

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

const LEFT = 1;
const RIGHT = -1;

/// Draws short strokes on one side of a segment, as a textbook draws a floor. bare is the length of the pieces before
/// it that were too short for a stroke [px]: they share one stroke with it. Returns bare for the next segment.
function hatchSegment(context, camera, side, bare, [x0, y0], [x1, y1]) {
    const from = [camera.x(x0), camera.y(y0)];
    const along = [camera.x(x1) - from[0], camera.y(y1) - from[1]];
    const length = Math.hypot(...along);
    const [ux, uy] = [along[0] / length, along[1] / length];
    // At 8 or later: a stroke slants back by 7, and so stays beside its segment.
    const first = Math.max(0, 8 - bare);
    for (let at = first; at < length; at += 11) {
        const [x, y] = [from[0] + at * ux, from[1] + at * uy];
        if (x < 0 || x > camera.width || y < 0 || y > camera.height) continue;
        context.moveTo(x, y);
        // The canvas has y downwards: (uy, -ux) points to the left.
        context.lineTo(x - 7 * ux + 9 * side * uy, y - 7 * uy - 9 * side * ux);
    }
    return first < length ? 0 : bare + length;
}

/// Hatches the same side all along: every step and every riser of a staircase.
function hatchLine(context, camera, theme, points, side) {
    context.beginPath();
    let bare = 0;
    for (let i = 0; i + 1 < points.length; ++i) {
        bare = hatchSegment(context, camera, side, bare, points[i], points[i + 1]);
    }
    context.strokeStyle = theme.hatch;
    context.lineWidth = 1.5;
    context.stroke();
}

/// Hatches the side away from moving things. For some engines a chain is solid only against things from its right. Any
/// other line is solid from both sides: then the moving things are taken to be where the middle of the view is. area is
/// twice the area that a ray from the middle sweeps along the line; it is positive if the middle is on the left of the
/// line.
function hatchedSide(points, middle, isOneSided) {
    if (isOneSided) return LEFT;
    let area = 0;
    for (let i = 0; i + 1 < points.length; ++i) {
        const [[x0, y0], [x1, y1]] = [points[i], points[i + 1]];
        area += (x1 - x0) * (middle[1] - y0) - (y1 - y0) * (middle[0] - x0);
    }
    return area > 0 ? RIGHT : LEFT;
}

/// The lines of a body, each hatched as a whole: a chain, or segments each of which starts where the one before it
/// ends.
function linesOf(shapes) {
    const lines = [];
    for (const {segment, chain, tiles} of shapes) {
        if (tiles || !(segment || chain)) continue;
        const last = lines.at(-1);
        const goesOn = segment && last && !last.isChain &&
            last.flat.at(-2) === segment[0] && last.flat.at(-1) === segment[1];
        if (goesOn) last.flat.push(segment[2], segment[3]);
        else lines.push({flat: [...(segment ?? chain)], isChain: Boolean(chain)});
    }
    return lines;
}

/// A piece of a tile map: an area, or a stretch of the outline with the filled area on its left. Areas are drawn
/// without edges; only sensors have dashed ones. Of a one-way tile only the top is drawn.
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
    if (oneWay) hatchLine(context, camera, theme, pointsInWorld(pose, shape.segment), LEFT);
}

function drawStillShape(context, camera, theme, shape, pose) {
    context.beginPath();
    traceShape(context, camera, shape, pose);
    const line = shape.segment || shape.chain;
    context.fillStyle = theme.hatching;
    if (!line) context.fill();
    context.strokeStyle = theme.ink;
    context.lineWidth = line ? 3 : 1.5;
    context.stroke();
}

function drawStill(context, camera, theme, scene, box) {
    context.setLineDash([]);
    context.lineJoin = "round";
    const middle = [(box.left + box.right) / 2, (box.bottom + box.top) / 2];
    const hasOneSided = scene.running.some(({name}) => lookOf(name).oneSidedChains);
    for (const {type, start, shapes} of scene.bodies) {
        if (type !== "static") continue;
        const pose = {x: start[0], y: start[1], angle: start[2]};
        const tiles = shapes.filter((shape) => shape.tiles);
        for (const area of tiles.filter(({polygon}) => polygon)) drawTiles(context, camera, theme, area, pose);
        for (const edge of tiles.filter(({segment}) => segment)) drawTiles(context, camera, theme, edge, pose);
        for (const shape of shapes) if (!shape.tiles) drawStillShape(context, camera, theme, shape, pose);
        for (const {flat, isChain} of linesOf(shapes)) {
            const points = pointsInWorld(pose, flat);
            hatchLine(context, camera, theme, points, hatchedSide(points, middle, isChain && hasOneSided));
        }
    }
}
