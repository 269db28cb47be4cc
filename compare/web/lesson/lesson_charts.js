// SPDX-License-Identifier: MIT
// What does a lesson plot over time? The quantities that it names, and the energy and the distance of all bodies together.

/// What is plotted of "y of ball" or "probe pull".
function choiceOf(scene, quantityText) {
    const label = quantityText.replace(/^probe /, "");
    return motionChoices(scene).find((choice) => choice.label.startsWith(`${label} [`));
}

const CAUSE_COLOURS = {forces: "--energy-potential", drivers: "--energy-springs", motors: "--energy-fields",
    friction: "--energy-kinetic", impacts: "--fail", damping: "--energy-potential", breaking: "--hold", solver: "--muted"};

/// The energy that came in or went out since the start, by cause, in the engine that accounts for it.
function causesCurve(scene) {
    const engine = scene.running.find(({causes}) => causes?.length > 0);
    const lines = (engine?.causes ?? []).map(({name, values}) => ({engine: name, values,
        look: {width: 2, dash: name === "damping" ? [4, 3] : [], label: say(name), color: CAUSE_COLOURS[name]}}));
    return {times: scene.curveTimes, lines, unit: "J", ruler: true};
}

/// The kinds of energy of the one engine that runs beside the closed form, or the sum in each engine.
function energyCurve(scene) {
    const simulating = scene.running.filter(({name}) => !isTruth(name));
    const [engine] = simulating;
    if (simulating.length === 1 && engine.energies.length > 1) return stackedEnergies(scene, engine);
    return linear({...engineCurve(scene, "energy", "J"), ruler: true});
}

class LessonCharts {
    /// seek(t) is called when a person clicks.
    constructor(host, seek) {
        Object.assign(this, {host, seek, charts: [], hidden: new Set()});
    }

    open(lesson) {
        this.clear();
        const zoomed = (window) => { for (const chart of this.charts) chart.setWindow(window); };
        this.lesson = lesson;
        this.charts = lesson.charts.map(({label, value}) =>
            Object.assign(new Chart(element("h2", {}, say(label)), this.seek, zoomed), {value}));
        this.host.replaceChildren(...this.charts.map((chart) => chart.figure));
        this.host.classList.toggle("odd", this.charts.length % 2 === 1);
    }

    /// The scene must be measured.
    fill(scene) {
        for (const chart of this.charts) {
            this.fillChart(chart, scene);
            chart.setHidden(this.hidden);
        }
    }

    fillChart(chart, scene) {
        const {value} = chart;
        if (value === "error") chart.show(logarithmic(errorCurve(scene), undefined), {}, say("distance"));
        else if (value === "energy") chart.show(energyCurve(scene), {}, "E");
        else if (value === "causes") chart.show(linear(causesCurve(scene)), {}, "E");
        else {
            const choice = choiceOf(scene, value), unit = this.lesson.countsSteps ? {timeUnit: ""} : {};
            if (choice) chart.show({...linear(choice.curve()), ...unit}, {}, choice.axis);
        }
    }

    setHidden(hidden) {
        this.hidden = hidden;
        for (const chart of this.charts) chart.setHidden(hidden);
    }

    moveTo(time) {
        for (const chart of this.charts) chart.moveTo(time);
    }

    clear() {
        for (const chart of this.charts) chart.clear();
        this.charts = [];
        this.host.replaceChildren();
    }
}
