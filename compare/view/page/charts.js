// SPDX-License-Identifier: MIT
// Which charts does a scene have? Motion, error, divergence and energy; they share one cursor and one zoom.

class Charts {
    constructor(host, seek) {
        const zoomed = (window) => this.zoom(window);
        const make = (title, heading = element("h2", {}, title)) => new Chart(heading, seek, zoomed);
        this.choice = element("select", {"aria-label": "Quantity plotted", onchange: () => this.showMotion()});
        this.motion = make("Motion", element("h2", {}, element("span", {class: "unseen"}, "Motion: "), this.choice));
        this.error = make("Distance to closed form");
        this.divergence = make("Distance to Plumb");
        this.energyChoice = element("select", {"aria-label": "Energy plotted", onchange: () => this.showEnergy()});
        this.energy = make("Energy", element("h2", {}, "Energy ", this.energyChoice));
        this.all = [this.motion, this.error, this.divergence, this.energy];
        this.host = host;
        host.append(...this.all.map((chart) => chart.figure));
        new ResizeObserver(() => this.all.forEach((chart) => chart.graph?.resize())).observe(host);
    }

    /// The quantity that was chosen stays, if the scene has it.
    load(scene) {
        const chosen = this.choices?.[Number(this.choice.value)]?.label;
        const isSame = this.scene?.name === scene.name;
        this.scene = scene;
        this.choices = motionChoices(scene);
        const groups = new Map();
        this.choices.forEach((choice, index) => {
            if (!groups.has(choice.group)) groups.set(choice.group, element("optgroup", {label: choice.group}));
            groups.get(choice.group).append(element("option", {value: index}, choice.label));
        });
        this.choice.replaceChildren(...groups.values());
        const kept = isSame ? this.choices.findIndex(({label}) => label === chosen) : -1;
        this.choice.value = kept >= 0 ? kept : this.choices.indexOf(firstChoice(this.choices));
        this.choice.hidden = this.choices.length === 0;
        this.show();
    }

    show() {
        const {scene} = this;
        const {limits} = scene;
        this.showMotion();
        // A chart without content is left out: there is no closed form, Plumb ran alone, or nothing moves.
        this.error.show(logarithmic(errorCurve(scene), limits.error),
            {limit: limits.error, until: scene.closedForm?.until}, "error");
        this.divergence.show(logarithmic(divergenceCurve(scene), limits.divergence),
            {limit: limits.divergence, until: limits.agreeUntil}, "distance");
        this.showEnergy();
        this.host.classList.toggle("odd", this.all.filter((chart) => !chart.figure.hidden).length % 2 === 1);
        // With an odd number of charts, the first is now wider than when it was drawn.
        for (const chart of this.all) chart.graph?.resize();
        this.moveTo(this.time ?? 0);
    }

    /// The sum in each engine, or the kinds in one of them, stacked.
    showEnergy() {
        const engines = this.scene.running.filter(({energies}) => energies.length > 1);
        const chosen = this.energyChoice.value;
        this.energyChoice.hidden = engines.length === 0;
        this.energyChoice.replaceChildren(element("option", {value: ""}, "sum"), ...engines.map(({name}) =>
            element("option", {value: name}, `by kind in ${lookOf(name).label}`)));
        const stacked = engines.find(({name}) => name === chosen);
        this.energyChoice.value = stacked ? chosen : "";
        const sum = {...engineCurve(this.scene, "energy", "J"), ruler: true};
        this.energy.show(stacked ? stackedEnergies(this.scene, stacked) : linear(sum), {}, "E");
        this.energy.moveTo(this.time ?? 0);
    }

    showMotion() {
        const choice = this.choices[Number(this.choice.value)];
        const curve = choice ? choice.curve() : {times: [0], lines: [], unit: ""};
        this.motion.show(linear(curve), {}, choice?.axis ?? "");
        this.motion.moveTo(this.time ?? 0);
    }

    moveTo(time) {
        this.time = time;
        for (const chart of this.all) chart.moveTo(time);
    }
    zoom(window) {
        for (const chart of this.all) chart.setWindow(window);
    }
    setHidden(hidden) {
        for (const chart of this.all) chart.setHidden(hidden);
    }
    clear() {
        for (const chart of this.all) chart.clear();
    }
}
