// SPDX-License-Identifier: MIT
// How do bounding volumes look on the stage, and how many tests of pairs does each broad phase make?

const BOUNDS_LOOKS = {circle: [2, 3], upright: [6, 3], oriented: []};

/// data: what the module says of a tick; those of two shapes that meet are drawn thick.
function drawBounds(context, camera, theme, data) {
    context.strokeStyle = context.fillStyle = theme.ink;
    const isMet = (body, kind) => data.pairs.some((pair) => pair[kind] && (pair.a === body || pair.b === body));
    const trace = (points) => {
        context.beginPath();
        points.forEach(([x, y]) => context.lineTo(camera.x(x), camera.y(y)));
        context.closePath();
        context.stroke();
    };
    for (const {body, circle: [x, y, r], upright: [[left, bottom], [right, top]], oriented} of data.bounds) {
        const style = (kind, met) => {
            context.setLineDash(BOUNDS_LOOKS[kind]);
            context.lineWidth = isMet(body, met) ? 2.2 : 0.9;
        };
        style("circle", "circles");
        context.beginPath();
        context.arc(camera.x(x), camera.y(y), r * camera.scale, 0, 2 * Math.PI);
        context.stroke();
        style("upright", "upright");
        trace([[left, bottom], [right, bottom], [right, top], [left, top]]);
        style("oriented", "oriented");
        trace(oriented);
    }
    context.setLineDash([]);
    context.lineWidth = 2.5;
    for (const {shapes} of data.pairs) {
        if (!shapes) continue;
        const {at: [x, y], normal: [nx, ny], depth} = shapes, length = Math.max(18, depth * camera.scale);
        drawArrow(context, [camera.x(x), camera.y(y)], [nx * length, -ny * length], true);
        const told = `${say("depth")} ${valueText({value: depth, unit: "m"})}`;
        labelOnPaper(context, theme, told, camera.x(x) + 10, camera.y(y) + 14, "left");
    }
}

/// Which bounds of which two bodies overlap, in words: for those of few bodies.
function boundsRows(scene, data) {
    const mark = (holds) => (holds ? say("overlap") : say("apart"));
    return data.pairs.slice(0, 6).map(({a, b, circles, upright, oriented, shapes}) => element("tr", {},
        rowHead(`${say(scene.bodies[a].name)}, ${say(scene.bodies[b].name)}`), ...[circles, upright, oriented, Boolean(shapes)]
            .map((holds) => element("td", {}, mark(holds)))));
}

function boundsTable(scene, data) {
    const heads = ["Two bodies", "Circles", "Upright boxes", "Oriented boxes", "The shapes themselves"];
    return table(heads.map((head) => columnHead(say(head))), boundsRows(scene, data));
}

function testsTable(tests, count) {
    const heads = [columnHead(say("Broad phase")), columnHead(say("Tests of two boxes"), true),
        columnHead(say("Pairs found"), true)];
    const rows = tests.map(({way, tests, pairs}) => element("tr", {}, rowHead(say(way)),
        element("td", {class: "number"}, String(tests)), element("td", {class: "number"}, String(pairs))));
    return [element("caption", {}, sayWith("{0} boxes, in this step", count)), ...table(heads, rows)];
}
