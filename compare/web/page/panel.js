// SPDX-License-Identifier: MIT
// How does a person change a scene? By sliders with number boxes: the scene's own, and those of the body that is clicked.

/// What a field holds, by its path: as set_field.h reads it. json: the scene with all its fields.
function valueAt(json, path) {
    let value = json;
    const names = path.split(".");
    for (let i = 0; i < names.length; ++i) {
        if (value === null || value === undefined) return undefined;
        const inList = Array.isArray(value) && value.find((each) => each?.name === names[i]);
        const next = inList || value[names[i]];
        const isOfShapes = next === undefined && Array.isArray(value.shapes);
        value = isOfShapes ? materialOrShape(value.shapes[0], names[i]) : next;
    }
    return value;
}

function materialOrShape(shape, name) {
    return shape?.[name] ?? shape?.material?.[name];
}

const DEGREE = Math.PI / 180;

/// How the number on a slider is made of the field's value, and the text that sets it: see ShownAs in scene.h.
const AS = {
    number: {of: (value) => value, text: (x) => String(x)},
    downwards: {of: (value) => -value, text: (x) => String(-x)},
    perSecond: {of: (value) => Math.round(1 / value), text: (x) => `1/${x}`},
    x: {of: ([x]) => x, text: (x, [, y]) => `${x},${y}`},
    y: {of: ([, y]) => y, text: (y, [x]) => `${x},${y}`},
    size: {of: (v, about) => Math.hypot(...from(v, about)),
        text: (size, v, about, angle) => polar(size, angle ?? angleOf(v, about), about)},
    direction: {of: (v, about) => angleOf(v, about) / DEGREE,
        text: (x, v, about) => polar(Math.hypot(...from(v, about)), x * DEGREE, about)},
    hanging: {of: (v, about) => wound(angleOf(v, about) / DEGREE + 90),
        text: (x, v, about) => polar(Math.hypot(...from(v, about)), (x - 90) * DEGREE, about)},
    degrees: {of: (value) => value / DEGREE, text: (x) => String(x * DEGREE)},
    degreesDown: {of: (value) => -value / DEGREE, text: (x) => String(-x * DEGREE)},
};

function from([x, y], [x0, y0] = [0, 0]) {
    return [x - x0, y - y0];
}

function angleOf(v, about) {
    const [x, y] = from(v, about);
    return Math.atan2(y, x);
}

/// Into -180 to 180.
function wound(degrees) {
    return ((degrees + 180) % 360 + 360) % 360 - 180;
}

function polar(size, angle, [x0, y0] = [0, 0]) {
    const point = [x0 + size * Math.cos(angle), y0 + size * Math.sin(angle)];
    return point.map((part) => Number(part.toPrecision(15))).join(",");
}

/// A number for a person: no more digits than say something.
function tidy(x) {
    return Number.isFinite(x) ? Number(x.toPrecision(6)) : x;
}

/// The range of a slider for a field of which only bounds are known.
function rangeFor(value, {minimum, exclusiveMinimum, maximum}, usual) {
    const far = niceStep(Math.max(2 * Math.abs(value), usual));
    const least = minimum ?? exclusiveMinimum ?? -far;
    const to = maximum ?? far, step = niceStep((to - least) / 400);
    return {from: exclusiveMinimum === undefined ? least : least + step, to, step};
}

/// What pages offer for every scene.
function generalControls(data, engines) {
    const longest = Math.max(10, niceStep(data.duration));
    const controls = [
        {set: ["gravity.1"], as: "downwards", label: "Gravity", unit: "m/s²", from: 0, to: 25, step: 0.01,
            meaning: "downwards"},
        {set: ["dt"], as: "perSecond", label: "Steps a second", unit: "1/s", from: 15, to: 480, step: 1,
            meaning: "for all engines"},
        {set: ["duration"], as: "number", label: "Duration", unit: "s", from: 0.5, to: longest, step: 0.5,
            meaning: "of the run"},
    ];
    for (const {name, label, numbers = []} of engines) {
        const subSteps = numbers.find((number) => number.name === "subSteps");
        if (!subSteps) continue;
        controls.push({set: [`${name}:solver.subSteps`], as: "number", label: `Sub-steps of ${label}`, unit: "",
            from: subSteps.least, to: Math.min(16, subSteps.most), step: 1, otherwise: subSteps.byDefault,
            meaning: "how often a step is divided"});
    }
    return controls;
}

/// The numbers of a schema's object that a slider may change, as controls.
function numbersOf(schema, definition, path, value, usual) {
    return Object.entries(schema.$defs[definition].properties).flatMap(([name, field]) => {
        const held = value?.[name];
        const unit = field.unit === "-" ? "" : (field.unit ?? "").replace("^2", "²");
        const control = {set: [`${path}.${name}`], unit, meaning: field.description ?? ""};
        const label = name.replace(/([A-Z])/g, (letter) => ` ${letter.toLowerCase()}`);
        if (name === "velocity" && Array.isArray(held)) {
            return [{...control, as: "size", label: "speed", ...rangeFor(Math.hypot(...held), {minimum: 0}, 5)},
                {...control, as: "direction", label: "direction", unit: "°", from: -180, to: 180, step: 1}];
        }
        if (name === "mass") {
            return [{...control, as: "number", label, unit: "kg", from: 0.01, to: 20, step: 0.01,
                meaning: "of the whole body"}];
        }
        if (field.type === "number" && field.unit === "rad") {
            return [{...control, as: "degrees", label, unit: "°", from: -180, to: 180, step: 1}];
        }
        if (field.type === "number" && field.unit) return [{...control, as: "number", label, ...rangeFor(held, field, usual)}];
        if (field.type !== "array" || field.items?.type !== "number" || !Array.isArray(held) || held.length !== 2) return [];
        return ["x", "y"].map((as, i) => ({...control, as, label: `${label} ${as}`, ...rangeFor(held[i], {}, usual)}));
    });
}

/// Those of a body: its own, its material's, and its first shape's.
function bodyControls(schema, json, name) {
    const body = json.bodies.find((each) => each.name === name), path = `bodies.${name}`;
    const seldom = ["appears", "renewed", "gravityScale", "linearDamping", "angularDamping"];
    const controls = numbersOf(schema, "SceneBody", path, body, 5)
        .filter(({set: [each]}) => !seldom.includes(each.split(".").at(-1)));
    const [shape] = body.shapes;
    if (!shape) return controls;
    const kind = ["circle", "capsule", "box"].find((each) => shape[each]);
    if (kind === "circle") controls.push(...numbersOf(schema, "Circle", `${path}.shapes.0.circle`, shape.circle, 1)
        .filter(({set: [each]}) => each.endsWith("radius")));
    return [...controls, ...numbersOf(schema, "Material", path, shape.material, 1)
        .filter(({set: [each]}) => !/surfaceSpeed|rollingResistance/.test(each))];
}

class Panel {
    /// change(paths, texts, isOver): fields are to be set; isOver: the person has let the slider go. refuse(fault): what was
    /// typed is no number that fits.
    constructor(host, change, refuse) {
        Object.assign(this, {host, change, refuse, rows: [], turned: new Map(), angles: new Map()});
    }

    /// groups: {title, controls, open}; json: the scene; bodies: as the module says of them.
    show(groups, json, bodies) {
        const openBefore = new Set([...this.host.querySelectorAll("details[open]")].map(({dataset}) => dataset.title));
        const known = this.host.childElementCount > 0;
        this.rows = [];
        this.host.replaceChildren(...groups.filter(({controls}) => controls.length > 0).map(({title, controls, open}) => {
            const rows = controls.map((control) => this.row(control)).filter(Boolean);
            const isOpen = known && !open ? openBefore.has(title) : open !== false;
            return element("details", {"data-title": title, open: isOpen}, element("summary", {}, title), ...rows);
        }));
        this.update(json, bodies);
    }

    row(control) {
        const id = `control-${this.rows.length}`;
        const slider = element("input", {type: "range", id, min: control.from, max: control.to, step: control.step,
            title: control.meaning});
        const number = element("input", {type: "number", step: "any", "aria-label": `${control.label} [${control.unit}]`});
        const row = {control, slider, number};
        slider.addEventListener("input", () => this.turn(row, slider.valueAsNumber, false));
        slider.addEventListener("change", () => this.turn(row, slider.valueAsNumber, true));
        number.addEventListener("change", () => this.turn(row, number.valueAsNumber, true));
        this.rows.push(row);
        return element("div", {class: "control", "data-set": control.set[0], "data-as": control.as},
            element("label", {for: id}, control.label), slider, number, element("span", {class: "unit"}, control.unit));
    }

    /// Shows what the scene holds now; not in a box in which a person writes.
    update(json, bodies) {
        this.json = json;
        this.masses = new Map(bodies.map(({name, mass}) => [name, mass]));
        for (const row of this.rows) {
            const {control, slider, number} = row;
            const held = this.held(control);
            const known = held !== undefined && held !== null && !(typeof held === "object" && !Array.isArray(held));
            slider.parentElement.hidden = !known;
            if (!known) continue;
            const x = tidy(AS[control.as].of(held, control.about));
            if (x > slider.max) slider.max = niceStep(x);
            if (x < slider.min) slider.min = x;
            slider.value = x;
            slider.setAttribute("aria-valuetext", `${x} ${control.unit}`);
            if (document.activeElement !== number || !number.matches(":invalid")) number.value = x;
        }
    }

    /// The mass of a body is that of its shapes where it is not given.
    held({set: [first], otherwise}) {
        const [engine, path] = first.split(":");
        const [, body] = /^bodies\.(.+)\.mass$/.exec(first) ?? [];
        if (body !== undefined) return this.masses.get(body);
        if (path === undefined) return valueAt(this.json, first);
        const text = this.json.engines?.[engine]?.[path];
        return text === undefined ? otherwise : Number(text);
    }

    /// A further path of a control holds a value of the same kind as the first.
    heldAt(path, otherwise) {
        const value = path.includes(":") ? undefined : valueAt(this.json, path);
        return Array.isArray(value) === Array.isArray(otherwise) ? value ?? otherwise : otherwise;
    }

    /// "Slope 45 °" for a path that was turned by a row; nothing for the further paths of a row; null if no row turned it.
    said(path) {
        const labels = this.turned.get(path);
        if (!labels) return null;
        const rowOf = (label) => this.rows.find(({control}) => control.label === label && control.set[0] === path);
        return [...labels].map(rowOf).filter(Boolean)
            .map(({control, number}) => `${control.label} ${number.value} ${control.unit}`.trim()).join(", ");
    }

    /// As if a person had written x in the row with this label. Returns why it is refused; "" if it is taken.
    take(label, x) {
        const row = this.rows.find(({control}) => control.label === label), why = this.refusal(row.control, x);
        if (why) return `${label}: ${why}`;
        this.turn(row, x, true);
        return "";
    }

    turn(row, x, isOver) {
        const {control} = row, why = this.refusal(control, x);
        if (why) {
            this.refuse(`${control.label}: ${why}`);
            row.number.value = row.slider.value;
            return;
        }
        for (const path of control.set) this.turned.set(path, (this.turned.get(path) ?? new Set()).add(control.label));
        row.slider.value = x;
        row.number.value = tidy(x);
        const [path] = control.set, held = this.held(control);
        const isVector = Array.isArray(held);
        if (isVector && Math.hypot(...from(held, control.about)) > 0) this.angles.set(path, angleOf(held, control.about));
        // Each field that it sets keeps what the number does not say: the other coordinate of its own vector.
        const texts = control.set.map((each, i) => AS[control.as].text(x, i === 0 ? held : this.heldAt(each, held), control.about,
            this.angles.get(path)));
        this.change(control.set, texts, isOver);
    }

    /// Why a control does not take a number; "" if it does. isBound: its range is not only that of the slider.
    refusal({as, isBound, from, to}, x) {
        if (!Number.isFinite(x)) return say("a number is wanted");
        if (as === "size" && x < 0) return say("it is not negative; its direction is set below");
        if (isBound && (x < from || x > to)) return sayWith("{0} is not between {1} and {2}", x, from, to);
        return "";
    }
}
