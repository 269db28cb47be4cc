// SPDX-License-Identifier: MIT
// What does the page of one scene contain? The stage, the charts and the tables, all at one time.

class ScenePage {
    /// settled() is called when the page is in a state that the address should name; grab as for StageAim.
    constructor(settled, grab) {
        this.player = new Player(() => this.showTime());
        this.showSpeed = bindTransport(this.player, settled);
        this.settled = settled;
        this.view = emptyView();
        this.aim = new StageAim(byId("stage"), this.view, () => this.draw(), grab);
        const seek = (time) => { this.player.seek(time); settled(); };
        this.charts = new Charts(byId("charts"), seek);
        bindKeys(this.player, this.aim, () => this.view.scene !== null);
        document.addEventListener("keyup", () => { if (!this.player.playing) settled(); });
        bindSwitches(this);
        fillChoice(byId("magnify"), "magnify", MAGNIFICATIONS, 1, (times) => {
            this.view.magnify = times;
            this.draw();
        });
        const parts = ["scene-answer", "partings", "unsupported"].map(byId);
        const above = new ResizeObserver(() => document.documentElement.style.setProperty("--above",
            `${parts.reduce((sum, part) => sum + part.offsetHeight, 0)}px`));
        for (const part of parts) above.observe(part);
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
            if (this.view.scene) this.charts.show();
        });
    }

    close() {
        this.player.stop();
        this.charts.clear();
        this.view.scene = null;
    }

    /// The scene must be ready: see data.js.
    open(scene) {
        this.player.load(scene.times);
        this.wasPlaying = false;
        this.view.scene = scene;
        this.view.box = sceneBox(scene);
        const moving = scene.bodies.filter((body) => body.type !== "static").length;
        this.view.trails = moving <= 3;
        this.view.path = moving <= 12;
        this.view.tools = {};
        this.view.pointer = null;
        for (const tool of Object.keys(TOOLS)) byId(tool).checked = false;
        for (const drawn of DRAWN) byId(drawn).checked = Boolean(this.view[drawn]);
        byId("causes").parentElement.hidden = !scene.running.some((engine) => engine.pushesAt);
        this.view.frame = 0;
        byId("scrub").max = scene.ticks.length - 1;
        this.view.theme = stageTheme();
        this.show(scene);
        this.charts.load(scene);
        this.aim.fit();
        this.showTime();
    }

    /// The words, keys and tables.
    show(scene) {
        this.showHead(scene);
        this.showPartings(scene);
        showEngineKeys(this, scene);
        this.showTables(scene);
    }

    showHead(scene) {
        const failed = failures(scene);
        byId("scene-title").textContent = titleText(scene);
        const isChanged = scene.changed.length > 0;
        byId("scene-changed").textContent = `Changed: ${scene.changed.join(", ")}`;
        byId("scene-changed").hidden = !isChanged;
        byId("scene-question").textContent = isChanged ? `The scene as it was asks: ${scene.question}` : scene.question;
        const answer = scene.engines.find(({name}) => isSubject(name))?.answer ?? "";
        byId("scene-answer").textContent = answer;
        byId("scene-answer").hidden = answer === "";
        const all = scene.outcomes.length;
        const verdict = scene.pass === null ? apartText(scene) ?? notJudgedText("scene", scene)
            : failed.length === 1 ? failureText(scene, failed[0])
            : failed.length > 1 ? `${failed.length} of ${all} checks fail` : `${all} of ${all} checks`;
        byId("scene-verdict").replaceChildren(verdictMark(scene.pass), element("span", {}, verdict));
        const missing = scene.engines.filter((engine) => engine.unsupported);
        byId("unsupported").replaceChildren(...missing.map(({name, unsupported}) =>
            element("p", {class: "unsupported"}, engineName(name), ` does not run this scene: ${unsupported}`)),
            ...scene.notes.map((note) => element("p", {class: "unsupported"}, note)));
    }

    /// A click goes to the moment of a parting.
    showPartings(scene) {
        byId("partings").hidden = scene.partings.length === 0;
        byId("partings").replaceChildren(...partingsParts(scene));
        for (const button of byId("partings").querySelectorAll("button")) {
            button.addEventListener("click", () => { this.player.seek(Number(button.dataset.time)); this.settled(); });
        }
    }

    showTables(scene) {
        byId("formula-card").hidden = !scene.closedForm;
        byId("formula").replaceChildren(...formulaParts(scene.closedForm?.formula ?? ""));
        const {source, until} = scene.closedForm ?? {};
        byId("source").textContent = `Source: ${source}` + (until > 0 ? `; holds until t = ${timeText(until)}` : "");
        byId("checks").replaceChildren(...checksTable(scene));
        byId("numbers").replaceChildren(...numbersTable(scene));
        byId("settings").replaceChildren(...settingsTable(scene));
        this.showFiles(scene);
    }

    /// The files to download, and what the page leaves out of the run.
    showFiles(scene) {
        const file = (label, name, text) => element("button", {type: "button",
            onclick: () => download(`${scene.name}.${name}.csv`, text())}, label);
        byId("files").replaceChildren(
            ...scene.running.map((engine) => file(engineName(engine.name), engine.name, () => runCsv(scene, engine))),
            file("All numbers", "numbers", () => numbersCsv([scene])));
        const ticks = scene.stride === 1 ? "every step" : `one step in ${scene.stride}`;
        byId("stage-note").textContent = scene.stride === 1 ? ""
            : `Playback shows ${ticks}; the charts keep every peak.`;
        const sums = scene.curveStride > 1 ? "energy"
            : `energy by kind${scene.running.some(({forces}) => forces.length > 0) ? ", forces in joints" : ""}`;
        const states = scene.lengthStep === 0 ? "positions, velocities"
            : `positions to ${quantity(scene.lengthStep, "m", 1)}, velocities from their differences`;
        byId("files-note").textContent = `CSV, one file an engine, with ${ticks}: ${states}, ${sums}, probes, ` +
            "and the distance to the closed form.";
    }

    restyle() {
        this.view.theme = stageTheme();
        this.draw();
    }

    showTime() {
        const {scene} = this.view;
        if (!scene) return;
        showTransport(this.player, scene);
        this.charts.moveTo(scene.times[this.player.frame]);
        this.draw();
        if (!this.player.playing && this.wasPlaying) this.settled();
        this.wasPlaying = this.player.playing;
    }

    draw() {
        const {scene} = this.view;
        if (!scene) return;
        this.view.frame = this.player.frame;
        const stage = byId("stage");
        stage.setAttribute("aria-label", `${titleText(scene)} at ${timeText(scene.times[this.view.frame])}`);
        drawStage(stage, this.view);
    }
}
