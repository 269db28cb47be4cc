// SPDX-License-Identifier: MIT
// What if the engine were worse? Each case adds an engine, or changes a setting, and says what comes of it.

class Worse {
    /// changed() is called when a case is chosen, or no longer.
    constructor(host, changed) {
        Object.assign(this, {host, changed, cases: [], on: new Set()});
    }

    open(cases, engines) {
        this.on.clear();
        this.cases = cases;
        this.host.replaceChildren(...cases.map((each, i) => {
            const isThere = engines.some(({name}) => name === each.engine);
            const input = element("input", {type: "checkbox", disabled: !isThere, onchange: ({target}) => {
                if (target.checked) this.on.add(i);
                else this.on.delete(i);
                this.changed();
            }});
            const says = element("p", {class: "note says", role: "status"}, isThere ? "" : say("This build does not have it."));
            return element("li", {}, element("label", {}, input, element("span", {}, say(each.title))), says);
        }));
    }

    clear() {
        this.on.clear();
        for (const input of this.host.querySelectorAll("input")) input.checked = false;
    }

    get chosen() { return this.cases.filter((_, i) => this.on.has(i)); }
    get engines() { return this.chosen.map(({engine}) => engine); }
    /// [path, value] of all that are chosen.
    get settings() { return this.chosen.flatMap(({set}) => set.map((text) => text.split(/=(.*)/s).slice(0, 2))); }

    /// tell(case): the sentence, or "" while it is not known.
    show(tell) {
        this.cases.forEach((each, i) => {
            const says = this.host.children[i].querySelector(".says");
            if (!this.host.children[i].querySelector("input").disabled) says.textContent = this.on.has(i) ? tell(each) : "";
        });
    }
}

/// What it says, and how far its number is from the true one.
function worseText(values, scene, lesson, each) {
    const engine = scene.engines.find(({name}) => name === each.engine);
    if (!engine) return "";
    if (engine.unsupported) return engine.unsupported;
    const told = values.filled(scene, say(each.says), engine);
    const query = lesson.predict.number?.value;
    if (!query) return told;
    const {value, unit} = values.of(engine, query), truth = values.truth(scene, query);
    if (value === null || truth.value === null) return told;
    const off = Math.abs(value - truth.value);
    // What is asked for may be the same in all engines, such as an angle to aim at.
    if (off < 1e-6 * Math.max(1, Math.abs(truth.value))) return told;
    const share = Math.abs(truth.value) > 1e-9 ? ` (${quantity(off / Math.abs(truth.value), "", 2)})` : "";
    return `${told} ${sayWith("It is {0} off{1}.", valueText({value: off, unit}), share)}`;
}
