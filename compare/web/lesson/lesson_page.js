// SPDX-License-Identifier: MIT
// How does a lesson go? A question, a prediction, a run, and what comes of it; then the values may be turned.

const LESSON_QUIET = 180;  // after the last change, until charts and numbers follow [ms]
const LESSON_SLICE = 9;  // of computing before each picture [ms]

/// Larger than what happens in it, so that it does not tell how far things go.
function roomyBox(box) {
    const [dx, dy] = [0.25 * box.width, 0.35 * box.height];
    box.add(box.left - dx, box.bottom);
    box.add(box.right + dx, box.top + dy);
    return box;
}

/// The lesson with a scene of so many bodies.
function withCount(json, count) {
    const lesson = JSON.parse(json);
    return JSON.stringify({...lesson, scene: lesson.scene.replace(/\d+$/, String(count))});
}

class LessonPage {
    constructor(comparison, list) {
        Object.assign(this, {comparison, list, runs: new Runs(comparison), values: new Values(comparison)});
        this.player = new Player(() => this.showTime());
        bindTransport(this.player, () => this.settled());
        this.view = emptyView();
        this.aim = new StageAim(byId("stage"), this.view, () => this.draw());
        bindKeys(this.player, this.aim, () => this.view.scene !== null);
        this.panel = new Panel(byId("controls"), (paths, texts, isOver) => this.turn(paths, texts, isOver),
            (fault) => { byId("refused").textContent = fault; });
        this.charts = new LessonCharts(byId("charts"), (time) => { this.player.seek(time); this.settled(); });
        this.worse = new Worse(byId("worse"), () => this.rebuild());
        this.bind();
    }

    bind() {
        const click = (id, act) => byId(id).addEventListener("click", act);
        click("run", () => this.predicted());
        click("show", () => this.know(null));
        click("again", () => this.ask());
        click("reset", () => this.reset());
        byId("count").addEventListener("change", ({target}) => this.open(this.json, {count: Number(target.value)}));
        bindSwitches(this, [...DRAWN, "bounds"]);
    }

    // ---- opening

    /// json: of the lesson; count: how many bodies its scene has, where that can be chosen. Throws what is wrong with it.
    open(json, {changed = [], count = null} = {}) {
        this.close();
        this.count = count;
        const {lesson, scene} = this.comparison.lesson(count ? withCount(json, count) : json);
        this.runs.take(scene);
        Object.assign(this, {lesson, json, changed: new Map(changed)});
        this.values.openFor(lesson.engines);
        this.worse.open(lesson.worse, [...this.list.engines, ...this.list.onDemand]);
        this.start();
        this.view.aim = wholeView();
        this.view.tools = {};
        this.player.load(this.scene.times);
        byId("scrub").max = this.scene.ticks.length - 1;
        this.ask();
        this.showWords();
        this.aim.fit();
    }

    close() {
        cancelAnimationFrame(this.waiting);
        clearTimeout(this.quiet);
        this.player.stop();
        this.view.scene = null;
        this.runs.scene = null;
        this.charts.clear();
    }

    get scene() { return this.runs.scene; }
    get engines() { return [...new Set([...this.lesson.engines, ...this.worse.engines])]; }

    /// The runs begin anew with all that is set.
    start() {
        const faults = [];
        this.runs.reset();
        for (const [path, value] of [...this.changed, ...this.worse.settings]) {
            try {
                this.runs.set(path, value);
            } catch (error) {
                faults.push(error.message);
            }
        }
        this.values.forget();
        this.startRuns(faults);
        byId("refused").textContent = faults.join("; ");
        this.view.scene = this.scene;
        this.scene.countsSteps = this.lesson.countsSteps;
        this.isMeasured = false;
        this.advance();
    }

    /// An engine may refuse a number of its own: then the lesson runs as it was, and faults says why.
    startRuns(faults) {
        try {
            this.runs.start(this.engines);
        } catch (error) {
            faults.push(error.message);
            this.worse.clear();
            this.changed.clear();
            this.runs.reset();
            this.runs.start(this.engines);
        }
    }

    advance() {
        cancelAnimationFrame(this.waiting);
        clearTimeout(this.quiet);
        this.waiting = requestAnimationFrame(() => {
            if (!this.scene) return;
            const isNew = this.runs.advance(LESSON_SLICE);
            this.player.known = this.scene.times[this.runs.tick];
            if (isNew && !this.player.playing) this.draw();
            if (this.runs.isOver) this.quiet = setTimeout(() => this.measure(), LESSON_QUIET);
            else this.advance();
        });
    }

    /// All that is read of the runs needs them to be over.
    finish() {
        while (!this.runs.isOver) this.runs.advance(1000);
        this.player.known = this.player.end;
    }

    measure() {
        if (!this.scene || !this.runs.isOver || this.isMeasured) return;
        this.runs.measure(false);
        this.isMeasured = true;
        const {aim} = this.view;
        if (document.body.dataset.known === "yes" && aim.zoom === 1 && aim.follow === null) this.view.box = sceneBox(this.scene);
        this.showAsked();
        this.showResults();
    }

    /// The same lesson with other engines or values.
    rebuild() {
        const {time} = this.player;
        this.start();
        this.player.times = this.scene.times;
        this.player.time = Math.min(time, this.player.end);
        byId("scrub").max = this.scene.ticks.length - 1;
        this.view.box.addBox(sceneBox(this.scene));
        showEngineKeys(this, this.scene);
        this.showTime();
        this.settled();
    }

    // ---- the course of a lesson

    ask() {
        this.finish();
        this.view.box = roomyBox(sceneBox(this.scene));
        document.body.dataset.known = "no";
        this.player.stop();
        this.player.seek(0);
        byId("judged").textContent = "";
        delete byId("judged").dataset.right;
        this.makeWidget();
        this.showDrawn(false);
        this.draw();
    }

    makeWidget() {
        const {predict} = this.lesson, host = byId("predict");
        if (predict.number) this.widget = numberWidget(host, predict);
        else if (predict.choice) this.widget = choiceWidget(host, predict);
        else this.widget = curveWidget(host, predict, this.scene.times, this.padRange());
        this.widget.lock(false);
    }

    /// A range that does not give away where the curve is: it is symmetric, or as wide again as the run.
    padRange() {
        this.finish();
        const values = this.curveOf(this.lesson.predict.curve.value).filter(Number.isFinite);
        const low = Math.min(0, ...values), high = Math.max(0, ...values);
        const step = niceStep(Math.max(high - low, 1e-6) / 4);
        return [Math.floor(low / step - 0.5) * step, Math.ceil(high / step + 0.5) * step];
    }

    /// The values of a quantity, as the closed form has them, else the engine under test.
    curveOf(quantityText) {
        const curve = choiceOf(this.scene, quantityText)?.curve();
        const ordered = (curve?.lines ?? []).sort((a, b) => rank({name: a.engine}) - rank({name: b.engine}));
        const full = ordered.find(({values}) => values.some(Number.isFinite));
        return full ? Array.from(full.values) : [];
    }

    predicted() {
        const said = this.widget.said();
        if (said === null) {
            byId("judged").textContent = say("Say first what you expect.");
            return;
        }
        if (!this.tried(said)) return;
        this.said = said;
        this.widget.lock(true);
        document.body.dataset.known = "run";
        byId("judged").textContent = "";
        this.showDrawn(true);
        this.player.seek(0);
        this.player.play();
        bringStageIntoView();
    }

    /// The run takes what was said, where the lesson has a control for it. False if that does not go.
    tried(said) {
        const label = this.lesson.predict.number?.tries;
        const fault = label ? this.panel.take(say(label), said) : "";
        byId("judged").textContent = fault;
        return fault === "";
    }

    /// What is true is shown; said: what was predicted, or null.
    know(said) {
        this.finish();
        document.body.dataset.known = "yes";
        this.view.box = sceneBox(this.scene);
        this.widget.lock(true);
        this.showDrawn(true);
        const {curve} = this.lesson.predict;
        if (curve) this.widget.showTruth(this.curveOf(curve.value));
        if (said !== null) this.judge(said);
        this.measure();
        this.showResults();
        this.showTime();
    }

    judge(said) {
        const {predict} = this.lesson;
        const judged = predict.number ? judgeNumber(predict, said, this.values.truth(this.scene, predict.number.value))
            : predict.choice ? judgeChoice(predict, said)
            : judgeCurve(predict, said, {times: [...this.scene.times], values: this.curveOf(predict.curve.value)});
        byId("judged").textContent = judged.text;
        byId("judged").dataset.right = judged.isRight;
    }

    // ---- changes

    turn(paths, texts, isOver) {
        paths.forEach((path, i) => {
            this.changed.delete(path);
            this.changed.set(path, texts[i]);
        });
        this.rebuild();
        // What was drawn was drawn for other values, and their range may be another one.
        if (this.lesson.predict.curve && document.body.dataset.known === "no") this.makeWidget();
        if (byId("judged").dataset.right !== undefined) {
            delete byId("judged").dataset.right;
            byId("judged").textContent = say("The values have changed: predict again.");
        }
        if (isOver) this.panel.update(this.exported(), this.runs.data.bodies);
    }

    reset() {
        this.changed.clear();
        this.rebuild();
        this.showPanel();
    }

    exported() { return JSON.parse(this.comparison.exported(true)); }

    // ---- what is shown

    showWords() {
        const {lesson} = this;
        byId("lesson-title").textContent = say(lesson.title);
        document.title = `${say(lesson.title)} – ${say("Plumb lessons")}`;
        byId("slides").textContent = lesson.slides.length > 0 ? sayWith("Slides {0}", lesson.slides.join(", ")) : "";
        byId("worse-card").hidden = lesson.worse.length === 0;
        byId("turn").hidden = lesson.controls.length === 0 && lesson.counts.length === 0;
        byId("reset").parentElement.hidden = lesson.controls.length === 0;
        byId("count-choice").hidden = lesson.counts.length === 0;
        byId("count").replaceChildren(...lesson.counts.map((count) => element("option", {value: count}, count)));
        byId("count").value = this.count ?? this.scene.name.match(/\d*$/)[0];
        byId("counts-frame").hidden = !lesson.show.some((shown) => shown === "bounds" || shown === "tests");
        byId("bounds").parentElement.hidden = !lesson.show.includes("bounds");
        byId("questions").replaceChildren(...lesson.questions.map(() => element("li", {}, element("details", {},
            element("summary"), element("p", {class: "answer-text"})))));
        this.showAsked();
        this.showPanel();
        showEngineKeys(this, this.scene);
        this.charts.open(lesson);
        showOwnFiles(this);
    }

    /// What is asked, with the values as they are now.
    showAsked() {
        const {lesson} = this, told = (text) => this.values.filled(this.scene, say(text));
        byId("about").textContent = told(lesson.about);
        byId("question").textContent = told(lesson.question);
        byId("questions").querySelectorAll("summary").forEach((each, i) => { each.textContent = told(lesson.questions[i].ask); });
    }

    showPanel() {
        const controls = this.lesson.controls.map((control) => ({...control, label: say(control.label), meaning: "",
            isBound: true}));
        this.panel.show([{title: say("This lesson"), controls, open: true}], this.exported(), this.runs.data.bodies);
    }

    /// The ways and arrows would tell the answer before it is predicted.
    showDrawn(isTold) {
        const {show} = this.lesson;
        for (const drawn of [...DRAWN, "bounds"]) {
            this.view[drawn] = isTold ? show.includes(drawn) : drawn === "bounds" && show.includes(drawn);
            byId(drawn).checked = this.view[drawn];
            byId(drawn).disabled = !isTold && drawn !== "bounds";
        }
    }

    showResults() {
        if (!this.isMeasured || document.body.dataset.known !== "yes") return;
        const {scene, lesson, values} = this;
        this.charts.fill(this.scene);
        byId("because").textContent = values.filled(scene, say(lesson.because));
        byId("formula-card").hidden = lesson.formula.length === 0;
        byId("formula").replaceChildren(...lesson.formula.map((line) => formulaElement(values.worked(scene, line))));
        const hasTruth = scene.running.some(({name}) => isTruth(name));
        byId("source").textContent = hasTruth ? sayWith("Closed form: {0}", say(scene.closedForm.source)) : "";
        byId("numbers").replaceChildren(...lessonNumbersTable(values, scene, lesson));
        byId("questions").querySelectorAll(".answer-text").forEach((each, i) => {
            each.textContent = values.filled(scene, say(lesson.questions[i].answer));
        });
        this.worse.show((each) => worseText(values, scene, lesson, each));
        showOwnFiles(this);
    }

    showTime() {
        const {scene} = this;
        if (!scene) return;
        const isOver = !this.player.playing && this.player.time >= this.player.end - 1e-9;
        if (isOver && document.body.dataset.known === "run") this.know(this.said);
        showTransport(this.player, scene);
        if (this.lesson.countsSteps) byId("clock").textContent = sayWith("step {0}", this.player.frame);
        this.charts.moveTo(scene.times[this.player.frame]);
        this.draw();
    }

    draw() {
        const {scene, view, lesson} = this;
        if (!scene) return;
        view.frame = this.player.frame;
        byId("stage").setAttribute("aria-label", `${say(lesson.title)}, ${timeText(scene.times[view.frame])}`);
        const engine = this.looked();
        const bounds = engine && view.bounds ? this.comparison.bounds(engine.run, view.frame) : null;
        view.overlay = bounds && ((context, camera) => drawBounds(context, camera, view.theme, bounds));
        drawStage(byId("stage"), view);
        if (bounds) byId("counts").replaceChildren(...boundsTable(scene, bounds));
        else if (engine && lesson.show.includes("tests"))
            byId("counts").replaceChildren(...testsTable(this.comparison.tests(engine.run, view.frame), scene.bodies.length));
    }

    /// The engine whose bodies are looked at more closely: the one under test, if it has this frame.
    looked() {
        if (!this.lesson.show.some((shown) => shown === "bounds" || shown === "tests")) return null;
        const runs = this.scene.running.filter(({run, ticks}) => run !== undefined && this.view.frame < ticks);
        return runs.find(({name}) => isSubject(name)) ?? runs[0] ?? null;
    }

    restyle() {
        this.view.theme = stageTheme();
        this.draw();
        if (document.body.dataset.known === "yes") this.showResults();
    }

    settled() {
        if (this.scene) writeLessonAddress({name: this.lesson.name, packed: this.packed, changed: [...this.changed], count: this.count});
    }
}
