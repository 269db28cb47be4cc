// SPDX-License-Identifier: MIT
// Which part of the world does the stage show?

class Box {
    constructor() {
        this.left = this.bottom = Infinity;
        this.right = this.top = -Infinity;
    }
    get empty() { return !(this.left <= this.right); }
    get width() { return this.right - this.left; }
    get height() { return this.top - this.bottom; }
    add(x, y, around = 0) {
        this.left = Math.min(this.left, x - around);
        this.right = Math.max(this.right, x + around);
        this.bottom = Math.min(this.bottom, y - around);
        this.top = Math.max(this.top, y + around);
    }
    addBox(box) {
        if (box.empty) return;
        this.add(box.left, box.bottom);
        this.add(box.right, box.top);
    }
    grown(by) {
        const box = new Box();
        box.add(this.left - by, this.bottom - by);
        box.add(this.right + by, this.top + by);
        return box;
    }
    cut(other) {
        const box = new Box();
        box.left = Math.max(this.left, other.left);
        box.right = Math.min(this.right, other.right);
        box.bottom = Math.max(this.bottom, other.bottom);
        box.top = Math.min(this.top, other.top);
        if (box.bottom > box.top) box.left = Infinity;
        return box;
    }
}

function pathBox(scene, engine) {
    const box = new Box();
    const stride = frameStride(scene, engine);
    for (let frame = 0; frame < scene.ticks.length; frame += stride) {
        for (const body of engine.bodies) {
            const pose = poseOf(scene, engine, frame, body);
            if (pose) box.add(pose.x, pose.y, scene.bodies[body].reach);
        }
    }
    return box;
}

function shapeBox(shape, pose) {
    const box = new Box();
    if (shape.circle) {
        box.add(...inWorld(pose, shape.circle[0], shape.circle[1]), shape.circle[2]);
        return box;
    }
    const points = pointsOf(shape);
    for (let i = 0; i < points.length; i += 2) box.add(...inWorld(pose, points[i], points[i + 1]), shape.radius);
    return box;
}

/// The paths of all moving bodies, the joints, and the nearby parts of static shapes. An engine whose bodies fly off
/// widens the view by at most half, so that the others remain visible.
function sceneBox(scene) {
    const box = new Box();
    const [first, ...others] = scene.running.map((engine) => pathBox(scene, engine)).filter((path) => !path.empty);
    if (first) {
        box.addBox(first);
        const most = first.grown(0.5 * Math.max(first.width, first.height));
        for (const path of others) box.addBox(path.cut(most));
    }
    const still = scene.bodies.filter((body) => body.type === "static");
    const near = box.empty ? null : box.grown(Math.max(0.2 * Math.max(box.width, box.height), 0.3));
    for (const body of still) {
        const pose = {x: body.start[0], y: body.start[1], angle: body.start[2]};
        for (const shape of body.shapes) {
            const bounds = shapeBox(shape, pose);
            box.addBox(near ? bounds.cut(near) : bounds);
        }
    }
    for (const joint of scene.joints) {
        for (const point of joint.over ?? []) box.add(...point);
        for (const [body, at] of [[joint.a, joint.atA], [joint.b, joint.atB]]) {
            const [x, y, angle] = scene.bodies[body].start;
            box.add(...inWorld({x, y, angle}, at[0], at[1]));
        }
    }
    if (box.empty) box.add(0, 0, 1);
    return box.grown(Math.max(0.03 * Math.max(box.width, box.height), 1e-3));
}

/// Fits the whole box into a canvas of this size, y up; margins for the rulers [px]. aim: a factor of zoom, and the
/// distance from the middle of the box [m].
function fitCamera(box, width, height, margins, aim) {
    const innerWidth = Math.max(1, width - margins.left - margins.right);
    const innerHeight = Math.max(1, height - margins.top - margins.bottom);
    const scale = Math.min(innerWidth / box.width, innerHeight / box.height) * aim.zoom;
    const centerX = margins.left + innerWidth / 2;
    const centerY = margins.top + innerHeight / 2;
    const worldX = (box.left + box.right) / 2 + aim.x;
    const worldY = (box.bottom + box.top) / 2 + aim.y;
    return {
        scale, width, height, margins, middleX: worldX, middleY: worldY,
        originX: centerX - worldX * scale, originY: centerY + worldY * scale,
        x: (x) => centerX + (x - worldX) * scale,
        y: (y) => centerY - (y - worldY) * scale,
        worldX: (px) => worldX + (px - centerX) / scale,
        worldY: (px) => worldY - (px - centerY) / scale,
    };
}

/// 1, 2 or 5 times a power of ten; at least x.
function niceStep(x) {
    const power = 10 ** Math.floor(Math.log10(x));
    const lead = x / power;
    return (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10) * power;
}
