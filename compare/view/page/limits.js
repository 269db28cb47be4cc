// SPDX-License-Identifier: MIT
// Where in a chart is the line of a check's limit?

/// marks: limit [value], until [s]. The check looks no further than until; the time after it is shaded.
function drawLimits(context, area, graph, marks) {
    const right = area.x + area.w;
    const end = marks.until > 0 ? Math.min(Math.max(graph.toDomXCoord(marks.until), area.x), right) : right;
    context.fillStyle = themeColor("--shade");
    context.fillRect(end, area.y, right - end, area.h);
    const y = limitHeight(area, graph, marks);
    if (y === null) return;
    context.save();
    context.strokeStyle = themeColor("--limit");
    context.lineWidth = 1.5;
    context.setLineDash([2, 3]);
    context.beginPath();
    context.moveTo(area.x, y);
    context.lineTo(end, y);
    context.stroke();
    context.restore();
}

/// Null if the chart does not show it.
function limitHeight(area, graph, marks) {
    if (!(marks.limit > 0)) return null;
    const y = graph.toDomYCoord(marks.limit);
    return y >= area.y && y <= area.y + area.h ? y : null;
}

/// Puts a label on the line, over the curves; below the line if there is no room above.
function placeLimit(label, graph, marks, unit) {
    const area = graph.getArea();
    const y = limitHeight(area, graph, marks);
    label.hidden = y === null;
    if (y === null) return;
    label.textContent = `limit ${chosenQuantity(marks.limit, unit)}`;
    const isBelow = y - area.y < 1.5 * chartText();
    label.style.transform = `translate(${area.x + 5}px, ${y}px) translateY(${isBelow ? "2px" : "calc(-100% - 2px)"})`;
}
