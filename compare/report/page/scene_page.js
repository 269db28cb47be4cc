// SPDX-License-Identifier: MIT
// What does the page of one scene hold together? The stage, the charts and the tables, at one time.

/// Where each two engines part: those of the engine that the comparison is about, and the others on demand.
function partingsList(scene) {
    const isMain = ({a, b}) => isSubject(a) || isSubject(b);
    const lines = (partings) => partings.map(({text, body, time}) => element("li", {},
        element("button", {type: "button", class: "plain", "data-time": time, disabled: body === ""}, text)));
    const main = scene.partings.filter(isMain);
    const others = scene.partings.filter((parting) => !isMain(parting));
    const list = (partings) => element("ul", {}, ...lines(partings));
    return [
        main.length > 0 ? list(main) : null,
        others.length === 0 ? null : main.length === 0 ? list(others)
            : element("details", {}, element("summary", {}, "The other engines among themselves"), list(others)),
    ].filter((part) => part !== null);
}

class ScenePage {
    /// settled() is called when a person has come to a state worth an address.
    constructor(settled) {
        this.player = new Player(() => this.showTime());
        this.showSpeed = bindTransport(this.player, settled);
        this.settled = settled;
        this.view = {scene: null, hidden: new Set(), trails: false, magnify: 1, theme: stageTheme()};
        const seek = (time) => { this.player.seek(time); settled(); };
        this.charts = new Charts(byId("charts"), seek);
        bindKeys(this.player, () => this.view.scene !== null);
        document.addEventListener("keyup", () => { if (!this.player.playing) settled(); });
        byId("trails").addEventListener("change", (event) => { this.view.trails = event.target.checked; this.draw(); });
        fillChoice(byId("magnify"), "magnify", MAGNIFICATIONS, 1, (times) => {
            this.view.magnify = times;
            this.draw();
        });
        new ResizeObserver(() => this.restyle()).observe(byId("stage"));
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
            this.restyle();
            if (this.view.scene) this.charts.show();
        });
        this.bindFile("motion", motionCsv);
        this.bindFile("curves", curvesCsv);
        this.bindFile("numbers", (scene) => numbersCsv([scene]));
    }

    bindFile(what, text) {
        byId(`${what}-csv`).addEventListener("click", () => {
            const {scene} = this.view;
            download(`${scene.name}_${what}.csv`, text(scene));
        });
    }

    close() {
        this.player.stop();
        this.charts.clear();
        this.view.scene = null;
    }

    open(scene) {
        unpackScene(scene);
        this.player.load(scene.times);
        this.wasPlaying = false;
        this.view.scene = scene;
        this.view.box = sceneBox(scene);
        const moving = scene.bodies.filter((body) => body.type !== "static").length;
        this.view.trails = moving <= 3;
        byId("trails").checked = this.view.trails;
        byId("scrub").max = scene.ticks.length - 1;
        this.showHead(scene);
        this.showPartings(scene);
        this.showKeys(scene);
        this.showTables(scene);
        this.charts.load(scene);
        this.restyle();
        this.showTime();
    }

    showHead(scene) {
        const failed = failures(scene);
        byId("scene-title").textContent = titleText(scene.name);
        byId("scene-question").textContent = scene.question;
        const answer = scene.engines.find(({name}) => isSubject(name))?.answer ?? "";
        byId("scene-answer").textContent = answer;
        byId("scene-answer").hidden = answer === "";
        const all = scene.outcomes.length;
        const verdict = scene.pass === null ? notJudgedText("scene", scene)
            : failed.length === 1 ? failureText(scene, failed[0])
            : failed.length > 1 ? `${failed.length} of ${all} checks fail` : `${all} of ${all} checks`;
        byId("scene-verdict").replaceChildren(verdictMark(scene.pass), element("span", {}, verdict));
        const missing = scene.engines.filter((engine) => engine.unsupported);
        byId("unsupported").replaceChildren(...missing.map(({name, unsupported}) =>
            element("p", {class: "unsupported"}, engineName(name), ` does not run this scene: ${unsupported}`)),
            ...scene.notes.map((note) => element("p", {class: "unsupported"}, note)));
    }

    /// A click goes to the moment.
    showPartings(scene) {
        byId("partings").hidden = scene.partings.length === 0;
        byId("partings").replaceChildren(...partingsList(scene));
        for (const button of byId("partings").querySelectorAll("button")) {
            button.addEventListener("click", () => { this.player.seek(Number(button.dataset.time)); this.settled(); });
        }
    }

    showKeys(scene) {
        byId("engine-keys").replaceChildren(...scene.engines.map((engine) => {
            const toggle = (event) => this.toggle(engine.name, event.target.checked);
            const input = element("input", {type: "checkbox", onchange: toggle});
            input.checked = !engine.unsupported && !this.view.hidden.has(engine.name);
            input.disabled = Boolean(engine.unsupported);
            return element("label", {title: engine.unsupported ?? ""}, input, element("span", {}, engineName(engine.name)));
        }));
    }

    showTables(scene) {
        byId("formula-card").hidden = !scene.closedForm;
        byId("formula").replaceChildren(...formulaParts(scene.closedForm?.formula ?? ""));
        const {source, until} = scene.closedForm ?? {};
        byId("source").textContent = `Source: ${source}` + (until > 0 ? `; holds until t = ${timeText(until)}` : "");
        byId("checks").replaceChildren(...checksTable(scene));
        byId("numbers").replaceChildren(...numbersTable(scene));
        byId("settings").replaceChildren(...settingsTable(scene));
        this.showThinning(scene);
    }

    /// What of the run the page does not have.
    showThinning(scene) {
        const ticks = scene.stride === 1 ? "every step" : `one step in ${scene.stride}`;
        const digits = scene.width === 4 ? "seven digits" : "all digits";
        const points = scene.curveStride === 1 ? "every step"
            : `the least and the largest value of every ${scene.curveStride} steps`;
        const note = scene.stride === 1 ? "" : `Playback shows ${ticks}; the charts keep every peak.`;
        byId("stage-note").textContent = note;
        byId("files-note").textContent = `Motion has ${ticks} with ${digits}; curves have ${points}.`;
    }

    toggle(engine, shown) {
        if (shown) this.view.hidden.delete(engine);
        else this.view.hidden.add(engine);
        this.charts.setHidden(this.view.hidden);
        this.draw();
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
        stage.setAttribute("aria-label", `${titleText(scene.name)} at ${timeText(scene.times[this.view.frame])}`);
        drawStage(stage, this.view);
    }
}
