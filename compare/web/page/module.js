// SPDX-License-Identifier: MIT
// How does the page ask the module? Numbers cross as they are, texts as UTF-8.

class Comparison {
    /// bytes: of live.wasm.
    static async load(bytes) {
        const comparison = new Comparison();
        const {module, instance} = await comparison.started(bytes);
        comparison.module = module;
        comparison.exports = instance.exports;
        comparison.exports._initialize();
        return comparison;
    }

    /// Of the system that its C library expects there is the clock alone.
    async started(bytes) {
        const module = await WebAssembly.compile(bytes);
        const notThere = 52;
        const system = {};
        for (const {name} of WebAssembly.Module.imports(module)) system[name] = () => notThere;
        system.clock_time_get = (clock, precision, at) => {
            const now = BigInt(Math.round(performance.now() * 1e6));
            new DataView(this.exports.memory.buffer).setBigUint64(at, now, true);
            return 0;
        };
        return {module, instance: await WebAssembly.instantiate(module, {wasi_snapshot_preview1: system})};
    }

    text() {
        const {memory, textAt, textLength} = this.exports;
        return new TextDecoder().decode(new Uint8Array(memory.buffer, textAt(), textLength()));
    }

    /// Calls a function of the module, and throws what it refuses.
    call(name, ...numbers) {
        const result = this.exports[name](...numbers);
        if (result < 0) throw new Error(this.text());
        return result;
    }

    give(text) {
        const bytes = new TextEncoder().encode(text);
        const at = this.exports.room(bytes.length);
        new Uint8Array(this.exports.memory.buffer, at, bytes.length).set(bytes);
    }

    /// Calls a function that takes a text and says one as JSON.
    ask(name, text = "", ...numbers) {
        this.give(text);
        this.call(name, ...numbers);
        return JSON.parse(this.text());
    }

    /// Numbers that the module has for the last call. They are its own memory: valid until the next call.
    numbers(count) {
        return new Float64Array(this.exports.memory.buffer, this.exports.numbersAt(), count);
    }

    /// Opens the scene of a lesson: {lesson, scene}.
    lesson(json) { return this.ask("lesson", json); }
    schema() { return this.ask("schema"); }
    list() { return this.ask("list"); }
    open(name) { return this.ask("open", name); }
    read(json) { return this.ask("read", json); }
    set(path, value) { return this.ask("set", `${path}=${value}`); }
    reset() { return this.ask("reset"); }
    start(engines = []) { return this.ask("start", engines.join(",")); }
    advance(tick, milliseconds) { return this.call("advance", tick, milliseconds); }
    poses(run, from, until) { return this.numbers(this.call("rowsOf", run, 0, from, until)); }
    velocities(run, from, until) { return this.numbers(this.call("rowsOf", run, 1, from, until)); }
    probes(run, from, until) { return this.numbers(this.call("probesOf", run, from, until)); }
    pushes(run, tick) { return this.numbers(this.call("pushesOf", run, tick)); }
    hold(tick, body, [gripX, gripY], [x, y]) { return this.call("hold", tick, body, gripX, gripY, x, y); }
    bring(csv) {
        this.give(csv);
        this.call("bring");
    }
    /// What a query reads of a run: {value, unit}; value is null if there is nothing to read.
    value(run, query) {
        this.give(query);
        this.call("valueOf", run);
        const [value] = this.numbers(1);
        return {value: Number.isFinite(value) ? value : null, unit: this.text()};
    }
    bounds(run, tick) { return this.ask("boundsOf", "", run, tick); }
    tests(run, tick) { return this.ask("testsOf", "", run, tick); }
    drop(tick) { return this.call("drop", tick); }
    measure(inDetail) { return this.ask("measure", "", inDetail ? 1 : 0); }
    series(run, name) {
        this.give(name);
        return this.numbers(this.call("series", run));
    }
    verdict() { return this.ask("verdict"); }

    exported(everything = false) {
        this.call("exported", everything ? 1 : 0);
        return this.text();
    }
}
