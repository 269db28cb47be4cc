// SPDX-License-Identifier: MIT
// How does a person measure on the stage? A ruler between two points, and a protractor: an angle at the first of three.

const TOOLS = {ruler: 2, protractor: 3};  // and how many points each has

/// The points at which a tool lies when it is taken: in the middle of what is seen.
function toolPoints(camera, kind) {
    const [x, y, reach] = [camera.middleX, camera.middleY, 0.12 * camera.width / camera.scale];
    if (kind === "ruler") return [[x - reach, y - reach], [x + reach, y - reach]];
    return [[x, y], [x + reach, y], [x + 0.7 * reach, y + 0.7 * reach]];
}

/// The point of a tool under a point of the stage, as {kind, index}; null if there is none.
function toolAt(view, px, py) {
    for (const [kind, points] of Object.entries(view.tools ?? {})) {
        const index = points.findIndex(([x, y]) => Math.hypot(view.camera.x(x) - px, view.camera.y(y) - py) < 16);
        if (index >= 0) return {kind, index};
    }
    return null;
}

function toolText(kind, points) {
    if (kind === "ruler") {
        const [[x0, y0], [x1, y1]] = points;
        return `${quantity(Math.hypot(x1 - x0, y1 - y0), "m", 4)}   (${withDigits(x1 - x0, 3)}, ${withDigits(y1 - y0, 3)})`;
    }
    const [[x, y], a, b] = points;
    const angle = Math.atan2(b[1] - y, b[0] - x) - Math.atan2(a[1] - y, a[0] - x);
    const degrees = ((angle * 180 / Math.PI) % 360 + 540) % 360 - 180;
    return `${withDigits(Math.abs(degrees), 4)}°`;
}

function drawTools(context, camera, view) {
    for (const [kind, points] of Object.entries(view.tools ?? {})) {
        const [first, ...others] = points.map(([x, y]) => [camera.x(x), camera.y(y)]);
        context.strokeStyle = context.fillStyle = view.theme.hazard;
        context.lineWidth = 2;
        context.setLineDash([]);
        context.beginPath();
        for (const other of others) {
            context.moveTo(...first);
            context.lineTo(...other);
        }
        context.stroke();
        for (const [x, y] of [first, ...others]) {
            context.beginPath();
            context.arc(x, y, 6, 0, 2 * Math.PI);
            context.globalAlpha = 0.25;
            context.fill();
            context.globalAlpha = 1;
            context.stroke();
        }
        labelOnPaper(context, view.theme, toolText(kind, points), first[0], first[1] - 1.4 * view.theme.text, "left");
    }
}
