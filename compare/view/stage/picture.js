// SPDX-License-Identifier: MIT
// Which moment of a scene shows the most, and how is it drawn beside its title?

/// The moment at which the engines are farthest apart and both on the stage; half-way if no difference could be seen.
function momentOf(scene, box) {
    const frames = scene.ticks.length;
    const isInside = (pose) => pose.x > box.left && pose.x < box.right && pose.y > box.bottom && pose.y < box.top;
    let best = {frame: Math.floor(frames / 2), apart: 0.03 * Math.max(box.width, box.height)};
    for (let k = 0; k <= 150; ++k) {
        const frame = Math.round((k * (frames - 1)) / 150);
        scene.bodies.forEach((body, index) => {
            const reference = body.type === "static" ? null : referenceEngine(scene, index);
            const from = reference && poseOf(scene, reference, frame, index);
            if (!from || !isInside(from)) return;
            for (const engine of scene.running) {
                const pose = poseOf(scene, engine, frame, index);
                if (!pose || !isInside(pose)) continue;
                const apart = Math.hypot(pose.x - from.x, pose.y - from.y);
                if (apart > best.apart) best = {frame, apart};
            }
        });
    }
    return best.frame;
}

function pictureView(scene, theme) {
    scene.picture ??= {box: sceneBox(scene)};
    const {box} = scene.picture;
    scene.picture.frame ??= momentOf(scene, box);
    return {scene, box, frame: scene.picture.frame, hidden: new Set(), path: scene.bodies.length < 15, trails: false,
        magnify: 1, theme, isPicture: true};
}

/// Draws canvases as they come into view, one after another.
class Pictures {
    constructor() {
        this.scenes = new Map();
        this.waiting = [];
        this.watch = new IntersectionObserver((entries) => {
            for (const {target, isIntersecting} of entries) {
                if (!isIntersecting) continue;
                this.watch.unobserve(target);
                this.waiting.push(target);
            }
            this.drawNext();
        }, {rootMargin: "200px"});
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.again());
    }

    add(canvas, scene) {
        this.scenes.set(canvas, scene);
        this.watch.observe(canvas);
    }

    again() {
        this.waiting = [];
        for (const canvas of this.scenes.keys()) {
            this.watch.unobserve(canvas);
            this.watch.observe(canvas);
        }
    }

    async drawNext() {
        if (this.drawing) return;
        this.drawing = true;
        const theme = stageTheme();
        for (let canvas = this.waiting.shift(); canvas; canvas = this.waiting.shift()) {
            const scene = this.scenes.get(canvas);
            await readyScene(scene);
            if (!scene.running) {
                this.watch.observe(canvas);
                continue;
            }
            drawStage(canvas, pictureView(scene, theme));
            // So that a person can scroll in the meantime.
            await new Promise((goOn) => { setTimeout(goOn); });
        }
        this.drawing = false;
    }
}
