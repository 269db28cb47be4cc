// SPDX-License-Identifier: MIT
// Where in a chart does a check draw its line?

/// marks: limit [value], until [s]: the check looks no further, and what comes after is shaded.
function drawLimits(context, area, graph, marks, unit) {
    const end = marks.until > 0 ? Math.min(graph.toDomXCoord(marks.until), area.x + area.w) : area.x + area.w;
    if (end < area.x + area.w) {
        context.fillStyle = themeColor("--shade");
        context.fillRect(Math.max(end, area.x), area.y, area.x + area.w - Math.max(end, area.x), area.h);
    }
    if (!(marks.limit > 0) || end <= area.x) return;
    const y = graph.toDomYCoord(marks.limit);
    if (y < area.y || y > area.y + area.h) return;
    const text = chartText();
    context.save();
    context.strokeStyle = context.fillStyle = themeColor("--limit");
    context.lineWidth = 1.5;
    context.setLineDash([2, 3]);
    context.beginPath();
    context.moveTo(area.x, y);
    context.lineTo(end, y);
    context.stroke();
    context.font = `${text}px ${getComputedStyle(document.body).fontFamily}`;
    context.textBaseline = y - area.y > 1.5 * text ? "bottom" : "top";
    const label = `limit ${chosenQuantity(marks.limit, unit)}`;
    const labelY = y + (y - area.y > 1.5 * text ? -2 : 3);
    context.fillText(label, area.x + 6, labelY);
    context.restore();
}
