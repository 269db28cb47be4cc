// SPDX-License-Identifier: MIT
// What is the stage drawn on? Graph paper with rulers in metres, and a scale bar.

function eachLine(from, to, step, draw) {
    for (let i = Math.ceil(from / step - 1e-9); i * step <= to + step * 1e-9; ++i) draw(i * step, i);
}

function paperLines(context, camera, step, color) {
    context.strokeStyle = color;
    context.lineWidth = 1;
    context.beginPath();
    eachLine(camera.worldX(0), camera.worldX(camera.width), step, (x) => {
        const px = Math.round(camera.x(x)) + 0.5;
        context.moveTo(px, 0);
        context.lineTo(px, camera.height);
    });
    eachLine(camera.worldY(camera.height), camera.worldY(0), step, (y) => {
        const py = Math.round(camera.y(y)) + 0.5;
        context.moveTo(0, py);
        context.lineTo(camera.width, py);
    });
    context.stroke();
}

function majorStep(camera, text) {
    return niceStep((5.5 * text) / camera.scale);
}

function drawPaper(context, camera, theme, hasLines) {
    context.fillStyle = theme.paper;
    context.fillRect(0, 0, camera.width, camera.height);
    if (!hasLines) return;
    const step = majorStep(camera, theme.text);
    paperLines(context, camera, step / 5, theme.minor);
    paperLines(context, camera, step, theme.major);
}

/// Drawn over the scene: numbers along the left and the lower edge, on strips that keep them readable.
function drawRulers(context, camera, theme) {
    const {left, bottom} = camera.margins;
    const step = majorStep(camera, theme.text);
    const floor = camera.height - bottom;
    context.fillStyle = theme.ruler;
    context.fillRect(0, floor, camera.width, bottom);
    context.fillRect(0, 0, left, floor);
    context.fillStyle = theme.muted;
    context.font = `${theme.text}px ${theme.font}`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    eachLine(camera.worldX(left + theme.text), camera.worldX(camera.width - 3.2 * theme.text), step, (x) => {
        context.fillText(axisText(x, step), camera.x(x), floor + bottom / 2);
    });
    context.textAlign = "right";
    eachLine(camera.worldY(floor - theme.text / 2), camera.worldY(2 * theme.text), step, (y) => {
        context.fillText(axisText(y, step), left - 7, camera.y(y));
    });
    context.fillText("m", camera.width - 10, floor + bottom / 2);
    context.fillText("m", left - 7, theme.text * 0.9);
}

/// Text on a patch of paper, over the drawing.
function labelOnPaper(context, theme, text, x, y, align) {
    context.font = `${theme.text}px ${theme.font}`;
    context.textAlign = align;
    context.textBaseline = "middle";
    context.lineJoin = "round";
    context.lineWidth = 5;
    context.strokeStyle = theme.paper;
    context.strokeText(text, x, y);
    context.fillStyle = theme.ink;
    context.fillText(text, x, y);
}

/// Above the scene, because the floor is below it.
function drawScaleBar(context, camera, theme) {
    const length = majorStep(camera, theme.text);
    const label = axisText(length, length) + NO_BREAK + "m";
    const right = camera.width - 18;
    const left = right - length * camera.scale;
    const y = camera.margins.top + 1.6 * theme.text;
    labelOnPaper(context, theme, label, (left + right) / 2, y - 9 - theme.text / 3, "center");
    context.strokeStyle = theme.ink;
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(left, y - 5);
    context.lineTo(left, y + 5);
    context.moveTo(left, y);
    context.lineTo(right, y);
    context.moveTo(right, y - 5);
    context.lineTo(right, y + 5);
    context.stroke();
}
