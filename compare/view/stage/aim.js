// SPDX-License-Identifier: MIT
// How does a person look closer? Wheel, pinch and buttons zoom, a drag moves, and a click on a body follows it.

const ZOOMS = [0.2, 20000];

function wholeView() {
    return {zoom: 1, x: 0, y: 0, follow: null};
}

/// The engine whose body is followed: the first visible one.
function guideOf(view) {
    return view.scene.running.find((engine) => !view.hidden.has(engine.name) && engine.bodies.length > 0);
}

/// The aim relative to the middle of the box [m]; a followed body keeps its place on the stage.
function aimOf(view) {
    const {aim, box, scene, frame, magnify} = view;
    if (!aim) return wholeView();
    const guide = aim.follow === null ? null : guideOf(view);
    const pose = guide && drawnPose(scene, guide, frame, aim.follow, magnify);
    if (!pose) return aim;
    return {zoom: aim.zoom, x: aim.x + pose.x - (box.left + box.right) / 2,
        y: aim.y + pose.y - (box.bottom + box.top) / 2};
}

/// The body under a point of the stage, or null. A small body can be hit from 14 pixels away.
function bodyAt(view, px, py) {
    const {scene, frame, magnify, camera} = view;
    let best = {body: null, far: Infinity};
    for (const engine of scene.running) {
        if (view.hidden.has(engine.name)) continue;
        for (const body of engine.bodies) {
            const pose = drawnPose(scene, engine, frame, body, magnify);
            if (!pose) continue;
            const far = Math.hypot(camera.x(pose.x) - px, camera.y(pose.y) - py);
            const reach = Math.max(14, scene.bodies[body].reach * camera.scale);
            if (far < reach && far < best.far) best = {body, far};
        }
    }
    return best.body;
}

class StageAim {
    /// changed() draws the stage again. grab(body, x, y), if there is one, may take a body that is pressed at a point of
    /// the world: it returns {move(x, y), end()}, or null to leave it.
    constructor(canvas, view, changed, grab = null) {
        Object.assign(this, {canvas, view, changed, grab, pointers: new Map(), moved: 0, held: null});
        canvas.addEventListener("wheel", (event) => this.wheel(event), {passive: false});
        canvas.addEventListener("pointerdown", (event) => this.press(event));
        canvas.addEventListener("pointermove", (event) => this.move(event));
        for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => this.release(event));
        canvas.addEventListener("pointerleave", () => this.point(null));
        canvas.addEventListener("dblclick", () => this.fit());
        byId("zoom-in").addEventListener("click", () => this.zoom(1.5));
        byId("zoom-out").addEventListener("click", () => this.zoom(1 / 1.5));
        byId("zoom-fit").addEventListener("click", () => this.fit());
        byId("following").addEventListener("click", () => this.follow(null));
    }

    fit() {
        this.view.aim = wholeView();
        this.show();
    }

    follow(body) {
        const {aim, camera, box} = this.view;
        const isSame = body === aim.follow;
        if (body === null || isSame) {
            // The view stays where it is.
            Object.assign(aim, {follow: null, x: camera.middleX - (box.left + box.right) / 2,
                y: camera.middleY - (box.bottom + box.top) / 2});
        } else {
            Object.assign(aim, {follow: body, x: 0, y: 0});
        }
        this.show();
    }

    /// The point of the world at (px, py) stays there.
    zoom(factor, px = this.canvas.clientWidth / 2, py = this.canvas.clientHeight / 2) {
        const {aim, camera} = this.view;
        const zoom = Math.min(Math.max(aim.zoom * factor, ZOOMS[0]), ZOOMS[1]);
        const kept = 1 - aim.zoom / zoom;
        if (aim.follow === null) {
            aim.x += (camera.worldX(px) - camera.middleX) * kept;
            aim.y += (camera.worldY(py) - camera.middleY) * kept;
        }
        aim.zoom = zoom;
        this.show();
    }

    /// As long as the whole scene is shown, one finger on the stage scrolls the page.
    show() {
        const {aim, scene} = this.view;
        const isWhole = aim.zoom === 1 && aim.x === 0 && aim.y === 0 && aim.follow === null;
        this.canvas.style.touchAction = isWhole ? "pan-y" : "none";
        const note = byId("following");
        note.hidden = aim.follow === null;
        note.textContent = aim.follow === null ? "" : `${sayWith("Following {0}", say(scene.bodies[aim.follow].name))} ✕`;
        this.changed();
    }

    wheel(event) {
        event.preventDefault();
        this.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0016)), event.offsetX, event.offsetY);
    }

    press(event) {
        if (event.button !== 0) return;
        this.canvas.setPointerCapture(event.pointerId);
        if (this.pointers.size === 0) this.moved = 0;
        else this.moved = Infinity;
        this.pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
        if (this.pointers.size === 1) this.held = this.taken(event.offsetX, event.offsetY);
    }

    /// What a press takes hold of: a point of a tool, or a body.
    taken(px, py) {
        const {view} = this, tool = toolAt(view, px, py);
        if (tool) {
            return {move: (x, y) => {
                view.tools[tool.kind][tool.index] = [x, y];
                this.changed();
            }, end() {}};
        }
        const body = bodyAt(view, px, py);
        return body === null || !this.grab ? null : this.grab(body, view.camera.worldX(px), view.camera.worldY(py));
    }

    /// The pointer is over a point of the stage, or over none.
    point(place) {
        if (!place && !this.view.pointer) return;
        this.view.pointer = place;
        this.changed();
    }

    /// One pointer drags; two pointers pinch around the middle between them.
    move(event) {
        const before = this.pointers.get(event.pointerId);
        if (!before) {
            this.point([event.offsetX, event.offsetY]);
            return;
        }
        this.view.pointer = null;
        const now = [event.offsetX, event.offsetY];
        const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
        this.pointers.set(event.pointerId, now);
        this.moved += Math.hypot(now[0] - before[0], now[1] - before[1]);
        if (this.moved < 5) return;
        if (this.held) {
            this.held.move(this.view.camera.worldX(now[0]), this.view.camera.worldY(now[1]));
            return;
        }
        const share = other ? 0.5 : 1;
        const {aim, camera} = this.view;
        aim.x -= (share * (now[0] - before[0])) / camera.scale;
        aim.y += (share * (now[1] - before[1])) / camera.scale;
        if (!other) {
            this.show();
            return;
        }
        const apart = ([x, y]) => Math.max(10, Math.hypot(x - other[0], y - other[1]));
        this.changed();
        this.zoom(apart(now) / apart(before), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
    }

    release(event) {
        if (this.held && this.pointers.has(event.pointerId)) {
            this.held.end();
            this.held = null;
        }
        if (!this.pointers.delete(event.pointerId) || event.type === "pointercancel" || this.moved >= 5) return;
        if (this.grab) return;  // there a click chooses a body
        const body = bodyAt(this.view, event.offsetX, event.offsetY);
        if (body !== null || this.view.aim.follow !== null) this.follow(body);
    }
}
