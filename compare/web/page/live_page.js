// SPDX-License-Identifier: MIT
// How does a scene run while a person changes it? A change begins it anew at once; what is slow comes when all is quiet.

const QUIET = 180;  // after the last change, until charts and verdicts follow [ms]
const FIRST_SLICE = 30;  // of computing, before a picture is drawn [ms]
const NEXT_SLICE = 9;  // of computing, before each next one [ms]

class LivePage {
    constructor(comparison, list) {
        this.comparison = comparison;
        this.list = list;
        this.runs = new Runs(comparison);
        this.page = new ScenePage(() => this.settled(), (body, x, y) => this.grab(body, x, y));
        this.panel = new Panel(byId("controls"), (paths, texts, isOver) => this.change(paths, texts, isOver),
            (fault) => this.refuse(fault));
        this.schema = null;
        this.hand = null;
        this.picked = null;
        byId("engine-keys").addEventListener("change", ({target}) => this.ask(target));
        byId("reset").addEventListener("click", () => this.reset());
        byId("restart").addEventListener("click", () => this.restart());
        byId("follow").addEventListener("click", () => { if (this.picked !== null) this.page.aim.follow(this.picked); });
        byId("keep").addEventListener("click", () => this.keep());
        byId("look-closer").addEventListener("click", () => this.measure(true));
        bindGifts(this);
    }

    get player() { return this.page.player; }
    get scene() { return this.runs.scene; }

    /// What the address names. changed: [path, value]; wanted: engines, none for the usual ones. What cannot be set is
    /// left out, and said; throws where there is no such scene, or its JSON is wrong.
    open({name, json, packed, changed = [], wanted = []}) {
        this.runs.forget();
        this.name = name;
        this.packed = packed;
        this.picked = null;
        byId("keep").textContent = "Keep this run";
        if (json) this.runs.read(json);
        else this.runs.open(name);
        this.changed = new Map();
        const faults = changed.map(([path, value]) => this.set(path, value)).filter(Boolean);
        this.refuse(faults.join("; "));
        this.panel.turned.clear();
        this.panel.angles.clear();
        this.wanted = wanted.length > 0 ? wanted : this.runs.isCrowd ? [subjectName(this.list)] : [];
        this.begin();
        this.page.open(this.scene);
        // Where a scene offers nothing of its own, its first body's numbers may be turned at once.
        if ((this.exported().controls ?? []).length === 0 && !this.runs.isCrowd)
            this.picked = this.scene.bodies.findIndex(({type}) => type === "dynamic");
        if (this.picked < 0) this.picked = null;
        this.showPanel();
        this.go();
    }

    close() {
        cancelAnimationFrame(this.waiting);
        clearTimeout(this.quiet);
        this.page.close();
        this.runs.scene = null;
    }

    /// Runs from the start on, as far as a picture may wait.
    begin() {
        clearTimeout(this.quiet);
        this.hand = null;
        this.runs.held = false;
        this.runs.start(this.wanted);
        this.runs.advance(this.runs.isCrowd ? 0 : FIRST_SLICE);
        document.body.classList.add("pending");
    }

    /// The runs begin anew with the scene as it is now; what a person looks at stays.
    again() {
        this.begin();
        const {page, scene, player} = this;
        page.view.scene = scene;
        player.times = scene.times;
        player.time = 0;
        player.watch = {};
        byId("scrub").max = scene.ticks.length - 1;
        // The picture keeps still under a hand.
        if (!this.isPlacing) page.view.box.addBox(sceneBox(scene));
        page.showTime();
        this.go();
    }

    /// Computes on before each picture, until all is known; then measures.
    go() {
        cancelAnimationFrame(this.waiting);
        this.waiting = requestAnimationFrame(() => {
            if (!this.scene) return;
            const {runs, player} = this;
            if (this.hand) this.pull();
            // Of a crowd no more than what is played next: a picture must not wait for what is seen later.
            const isNew = runs.advance(runs.isCrowd && player.playing ? 0 : NEXT_SLICE);
            player.known = this.scene.times[runs.tick];
            if (isNew && !player.playing) this.page.draw();
            if (!runs.isOver || this.hand) this.go();
            else this.whenQuiet();
        });
    }

    whenQuiet() {
        clearTimeout(this.quiet);
        this.quiet = setTimeout(() => this.measure(false), QUIET);
    }

    /// The verdicts, tables and charts of the run as it is. Crowds take long: they are measured when that is asked for.
    measure(inDetail) {
        const {runs, page, scene} = this;
        if (!scene || !runs.isOver) return;
        if (!runs.held && (!runs.isCrowd || inDetail)) runs.measure(inDetail);
        const {zoom, follow} = page.view.aim;
        if (!this.isPlacing && zoom === 1 && follow === null) page.view.box = sceneBox(scene);
        page.show(scene);
        byId("scene-changed").textContent = `Changed: ${this.changedText()}`;
        byId("held").hidden = !runs.held;
        if (runs.held) for (const id of ["scene-answer", "partings", "scene-verdict"]) byId(id).replaceChildren();
        byId("look-closer").hidden = inDetail || runs.held;
        page.charts.load(scene);
        document.body.classList.remove("pending");
        page.showTime();
    }

    /// What was changed, as the panel calls it.
    changedText() {
        if (this.changed.size === 0) return "nothing";
        const short = (text) => text.replace(/-?\d+\.\d{4,}/g, (digits) => tidy(Number(digits)));
        return [...this.changed].map(([path, text]) => this.panel.said(path) ?? `${path} = ${short(text)}`)
            .filter(Boolean).join(", ");
    }

    /// From the start, and without the hand that pulled.
    restart() {
        if (this.runs.held) this.again();
        else this.player.seek(0);
        this.settled();
    }

    // ---- changes

    change(paths, texts, isOver) {
        const before = this.runs.data;
        const faults = paths.map((path, i) => this.set(path, texts[i])).filter(Boolean);
        this.refuse(faults[0] ?? "");
        if (this.runs.data !== before) this.again();
        if (isOver) this.changeIsOver();
    }

    /// Why a field cannot be set so; "" if it is set.
    set(path, text) {
        try {
            this.runs.set(path, text);
        } catch (error) {
            return error.message;
        }
        this.changed.delete(path);
        this.changed.set(path, text);
        return "";
    }

    refuse(fault) {
        byId("refused").textContent = fault;
    }

    changeIsOver() {
        this.updatePanel();
        this.settled();
    }

    reset() {
        this.runs.reset();
        this.changed.clear();
        this.again();
        this.page.aim.fit();
        this.page.view.box = sceneBox(this.scene);
        this.refuse("");
        this.showPanel();
        this.settled();
    }

    keep() {
        if (this.runs.kept) this.runs.forget();
        else this.runs.keep();
        byId("keep").textContent = this.runs.kept ? "Forget the kept run" : "Keep this run";
        showEngineKeys(this.page, this.scene);
        this.page.charts.load(this.scene);
        this.page.draw();
    }

    /// An engine that does not run yet begins when its key is pressed.
    ask(target) {
        const engine = target.dataset?.engine;
        if (!engine || engine === KEPT || !target.checked || this.runs.wanted.length === 0) return;
        if (this.runs.wanted.includes(engine)) return;
        this.wanted = [...this.runs.wanted, engine];
        this.again();
        showEngineKeys(this.page, this.scene);
    }

    // ---- the panel

    exported() {
        return JSON.parse(this.comparison.exported(true));
    }

    showPanel() {
        const json = this.exported(), {data} = this.runs;
        const own = json.controls ?? [];
        const groups = [{title: "This scene", controls: own}];
        if (this.picked !== null) {
            this.schema ??= this.comparison.schema();
            groups.push({title: `The body ${data.bodies[this.picked].name}`, open: true,
                controls: bodyControls(this.schema, json, data.bodies[this.picked].name)});
        }
        const isOffered = new Set(own.flatMap(({set}) => set));
        groups.push({title: "The world",
            controls: generalControls(data, this.list.engines).filter(({set: [first]}) => !isOffered.has(first)),
            open: own.length === 0});
        this.panel.show(groups, json, data.bodies);
        byId("pick-hint").hidden = this.picked !== null;
    }

    updatePanel() {
        this.panel.update(this.exported(), this.runs.data.bodies);
    }

    pick(body) {
        if (this.picked === body) return;
        this.picked = body;
        this.showPanel();
    }

    // ---- the hand

    /// While the scene plays a body is pulled; while it stands it is placed, at the start.
    grab(body, x, y) {
        const {player, scene} = this;
        this.pick(body);
        if (scene.bodies[body].type !== "dynamic" && player.playing) return null;
        return player.playing ? this.holdOf(body, x, y) : this.placeOf(body, x, y);
    }

    holdOf(body, x, y) {
        const canTouch = (each) => each.run !== undefined && !isTruth(each.name) && each.slots.has(body);
        const engine = this.scene.running.find(canTouch) ?? this.scene.running[0];
        const pose = poseOf(this.scene, engine, this.player.frame, body);
        if (!pose) return null;
        const [c, s] = [Math.cos(pose.angle), Math.sin(pose.angle)], [dx, dy] = [x - pose.x, y - pose.y];
        return {
            move: (toX, toY) => {
                this.hand = {body, grip: [c * dx + s * dy, c * dy - s * dx], target: [toX, toY]};
                clearTimeout(this.quiet);
                document.body.classList.add("pending");
                this.go();
            },
            end: () => {
                if (!this.hand) return;
                this.hand = null;
                this.runs.hold(this.runs.tick, null);
                this.runs.limit = this.runs.data.steps;
                this.go();
            },
        };
    }

    /// The runs go no farther than the picture needs while a hand may move.
    pull() {
        const {runs, player, scene} = this;
        const tick = Math.min(runs.tick, Math.max(player.frame, 0));
        if (tick >= runs.data.steps) return;
        runs.hold(tick, this.hand);
        runs.limit = Math.min(runs.data.steps, indexAt(scene.times, player.time + 0.035 * player.speed) + 1);
    }

    /// Rounded to what a pixel can tell.
    placeOf(body, x, y) {
        const {page, player} = this;
        const drawn = drawnPose(this.scene, guideOf(page.view), player.frame, body, page.view.magnify);
        if (!drawn) return null;
        const unit = 10 ** Math.floor(Math.log10(1 / page.view.camera.scale));
        const rounded = (value) => Number((Math.round(value / unit) * unit).toPrecision(12));
        const path = `bodies.${this.scene.bodies[body].name}.position`;
        this.isPlacing = true;
        return {
            move: (toX, toY) => this.change([path], [`${rounded(drawn.x + toX - x)},${rounded(drawn.y + toY - y)}`], false),
            end: () => {
                this.isPlacing = false;
                page.view.box.addBox(sceneBox(this.scene));
                this.changeIsOver();
                this.go();
            },
        };
    }

    // ---- the address

    settled() {
        const {player} = this;
        if (!this.scene) return;
        writeAddress({name: this.name, packed: this.packed, changed: [...this.changed], time: player.time,
            play: player.playing, speed: player.speed});
    }
}

function subjectName({engines}) {
    return engines.find(({role}) => role === "subject").name;
}
