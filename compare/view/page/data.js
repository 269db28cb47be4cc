// SPDX-License-Identifier: MIT
// What is a scene to a page? An object that has what compare/view says of it, and
//   times, ticks    of the frames that are played [s, -]
//   curveTimes      of the points of curves [s]
//   running         the engines that run it; each with name, bodies (which of the scene's move in it), slots (body to
//                   place), ticks, poses (x, y, angle of each body, frame by frame), and curves, null where there is
//                   none: error, divergence, energy, probes, energies and forces as {name, values}
// readyScene(scene) makes it so, when the scene is first needed: a report unpacks its numbers, a live page computes them.

/// The numbers x, y, x, y, ... of every shape except a disc.
function pointsOf(shape) {
    return shape.polygon ?? shape.capsule ?? shape.segment ?? shape.chain ?? [];
}

/// The furthest point of a body from its origin, for the camera.
function reach(body) {
    let far = 0;
    for (const shape of body.shapes) {
        const {circle, radius = 0} = shape;
        if (circle) far = Math.max(far, Math.hypot(circle[0], circle[1]) + circle[2]);
        const points = pointsOf(shape);
        for (let i = 0; i < points.length; i += 2) far = Math.max(far, Math.hypot(points[i], points[i + 1]) + radius);
    }
    return far;
}

/// The last index whose time is not after t; times rise.
function indexAt(times, t) {
    let low = 0;
    let high = times.length - 1;
    while (low < high) {
        const middle = (low + high + 1) >> 1;
        if (times[middle] <= t + 1e-9) low = middle;
        else high = middle - 1;
    }
    return low;
}
