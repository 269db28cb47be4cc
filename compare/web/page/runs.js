// SPDX-License-Identifier: MIT
// What does the module know of the open scene, in the form in which all pages show scenes (see data.js)?

const CROWD_RUN = 300;  // with so many bodies only the engine under test runs, until another is asked for

/// Where energy goes, as the module has it for an engine that accounts for it.
const ENERGY_CAUSES = ["forces", "drivers", "motors", "friction", "impacts", "damping", "breaking", "solver"];

class Runs {
    constructor(comparison) {
        this.comparison = comparison;
        this.scene = null;
        this.kept = null;
    }

    open(name) { return this.take(this.comparison.open(name)); }
    read(json) { return this.take(this.comparison.read(json)); }
    set(path, value) { return this.take(this.comparison.set(path, value)); }
    reset() { return this.take(this.comparison.reset()); }

    take(data) {
        this.data = data;
        return data;
    }

    get isCrowd() { return this.data.bodies.length > CROWD_RUN; }

    /// Begins the runs in the engines of these names; in all where there are none. Nothing has moved yet.
    start(wanted = []) {
        const {comparison, data} = this;
        this.wanted = wanted;
        this.tick = -1;
        this.limit = data.steps;
        this.spent = false;
        const ticks = Array.from({length: data.steps + 1}, (_, tick) => tick);
        const times = Float64Array.from(ticks, (tick) => tick * data.dt);
        for (const body of data.bodies) body.reach = reach(body);
        const engines = comparison.start(wanted).map((engine, run) => this.engineOf(engine, run))
            .filter((engine) => !isTruth(engine.name) || data.closedForm);
        const running = engines.filter((engine) => !engine.unsupported);
        this.scene = {...data, ticks, times, curveTimes: times, stride: 1, curveStride: 1, lengthStep: 0, engines, running,
            pass: null, checks: 0, outcomes: [], partings: [], notes: [], limits: {}};
        this.addKept();
        this.copy();
        return this.scene;
    }

    engineOf(engine, run) {
        const made = {...engine, run, metrics: {}, settings: [], answer: "", energies: [], forces: [],
            error: null, divergence: null, energy: null};
        if (engine.unsupported) return made;
        const count = 3 * engine.bodies.length * (this.data.steps + 1);
        return Object.assign(made, {ticks: 0, poses: new Float64Array(count),
            velocities: this.isCrowd ? undefined : new Float64Array(count),
            slots: new Map(engine.bodies.map((body, slot) => [body, slot])),
            probes: this.data.probes.map(() => new Float64Array(this.data.steps + 1).fill(NaN)),
            pushesAt: isTruth(engine.name) || this.isCrowd ? undefined
                : (frame) => this.comparison.pushes(run, frame)});
    }

    get isOver() { return this.tick >= this.data.steps; }

    /// Computes on for so long [ms], up to the limit. True if anything is new.
    advance(milliseconds) {
        if (this.spent || this.tick >= this.limit) return false;
        const before = this.tick;
        this.comparison.advance(this.limit, milliseconds);
        this.copy();
        return this.tick > before;
    }

    /// Takes over the ticks that are new.
    copy() {
        const {comparison, scene} = this;
        const from = this.tick + 1;
        this.tick = comparison.advance(0, 0);
        if (this.tick < from) return;
        for (const engine of scene.running) {
            if (engine.run === undefined) continue;
            const columns = 3 * engine.bodies.length;
            engine.poses.set(comparison.poses(engine.run, from, this.tick + 1), from * columns);
            engine.velocities?.set(comparison.velocities(engine.run, from, this.tick + 1), from * columns);
            const width = scene.probes.length;
            const rows = width > 0 ? comparison.probes(engine.run, from, this.tick + 1) : [];
            for (let i = 0; i < rows.length; ++i) engine.probes[i % width][from + Math.floor(i / width)] = rows[i];
            engine.ticks = this.tick + 1;
        }
        delete scene.arrowSizes;
        delete scene.largestForce;
    }

    /// A hand pulls a body in all engines from a tick on; null: it lets go. What came later is forgotten.
    hold(tick, hand) {
        const reached = hand ? this.comparison.hold(tick, hand.body, hand.grip, hand.target) : this.comparison.drop(tick);
        this.spent = false;
        this.held = true;
        if (reached < this.tick) {
            this.tick = reached;
            for (const engine of this.scene.running) if (engine.run !== undefined) engine.ticks = reached + 1;
        }
    }

    /// Measures the runs, and judges them. They are spent then: the module begins them anew when they are needed.
    measure(inDetail = false) {
        const {comparison, scene} = this;
        if (this.spent) comparison.start(this.wanted);
        const {engines, ...said} = comparison.measure(inDetail);
        Object.assign(scene, said);
        this.spent = true;
        for (const engine of scene.engines) {
            Object.assign(engine, engines.find(({name}) => name === engine.name) ?? {});
            if (engine.run === undefined || engine.unsupported) continue;
            const series = (name) => {
                const values = Float64Array.from(comparison.series(engine.run, name));
                return values.length > 0 && values.some((value) => !Number.isNaN(value)) ? values : null;
            };
            for (const name of ["error", "divergence", "energy"]) engine[name] = series(name);
            engine.energies = ["kinetic", "potential", "springs", "fields"].map((name) => ({name, values: series(name)}))
                .filter(({values}) => values?.some((value) => value !== 0));
            engine.causes = ENERGY_CAUSES.map((name) => ({name, values: series(name)}))
                .filter(({values}) => values?.some((value) => Math.abs(value) > 1e-9));
        }
    }

    /// What check --json writes of the scene.
    verdict(inDetail) {
        this.measure(inDetail);
        return this.comparison.verdict().scenes[0];
    }

    /// Keeps the run of the engine under test beside those that follow.
    keep() {
        const engine = this.scene.running.find(({name, run}) => isSubject(name) && run !== undefined);
        if (!engine) return;
        this.kept = {times: this.scene.times, bodies: engine.bodies, slots: engine.slots, ticks: engine.ticks,
            poses: engine.poses, velocities: engine.velocities};
        this.addKept();
    }

    forget() {
        this.kept = null;
        this.dropKept();
    }

    dropKept() {
        if (!this.scene) return;
        for (const list of ["engines", "running"]) this.scene[list] = this.scene[list].filter(({name}) => name !== KEPT);
    }

    /// At the frames of the present run, which may have another step.
    addKept() {
        const {kept, scene} = this;
        if (!kept) return;
        this.dropKept();
        const columns = 3 * kept.bodies.length;
        const resampled = (numbers) => {
            const rows = new Float64Array(columns * scene.times.length).fill(NaN);
            scene.times.forEach((time, frame) => {
                const at = indexAt(kept.times, time), next = Math.min(at + 1, kept.ticks - 1);
                if (time > kept.times[kept.ticks - 1] + 1e-9) return;
                const share = next > at ? (time - kept.times[at]) / (kept.times[next] - kept.times[at]) : 0;
                for (let i = 0; i < columns; ++i) {
                    const [a, b] = [numbers[at * columns + i], numbers[next * columns + i]];
                    rows[frame * columns + i] = a + share * (b - a);
                }
            });
            return rows;
        };
        const engine = {name: KEPT, bodies: kept.bodies, slots: kept.slots, ticks: scene.times.length,
            poses: resampled(kept.poses), velocities: kept.velocities && resampled(kept.velocities),
            probes: scene.probes.map(() => null), metrics: {}, settings: [], answer: "", energies: [], forces: [],
            error: null, divergence: null, energy: null, version: ""};
        scene.engines.push(engine);
        scene.running.push(engine);
    }
}

const KEPT = "kept";
const KEPT_LOOK = {name: KEPT, label: "Kept run", role: "guest", onLight: "#7a5195", onDark: "#cf9be0", dash: [2, 3],
    width: 2, filled: false, ghost: false};
