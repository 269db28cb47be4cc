// SPDX-License-Identifier: MIT
// What does a person predict, and how near is it? A number, one of several sentences, or a curve that is drawn.

/// "You said 8 m. It is 5 m: 60 % too much." With signs, "more" has two meanings: "0.3 m/s too high".
function judgeNumber({number}, said, {value, unit}) {
    if (value === null) return {isRight: null, text: say("This does not happen in the run.")};
    const off = said - value, size = Math.abs(value) > 1e-9 ? Math.abs(value) : number.to - number.from;
    const isRight = Math.abs(off) <= number.within * size;
    const share = Math.abs(off) / size;
    const told = valueText({value: said, unit}), is = valueText({value, unit});
    if (isRight) return {isRight, text: sayWith("Right: it is {0}. You said {1}.", is, told)};
    const isPlain = value > 1e-9 && said >= 0;
    const way = isPlain ? (off > 0 ? "too much" : "too little") : off > 0 ? "too high" : "too low";
    const percent = numberText(String(Number((100 * share).toPrecision(2))));
    const far = isPlain && share < 10 ? `${percent}${NO_BREAK}%` : valueText({value: Math.abs(off), unit});
    return {isRight, text: sayWith("You said {0}. It is {1}: yours is {2} {3}.", told, is, far, say(way))};
}

function judgeChoice({choice}, said) {
    const isRight = said === choice.right;
    return {isRight, text: sayWith(isRight ? "Right: {0}" : "No. It is: {0}", say(choice.options[choice.right - 1]))};
}

/// The mean distance between the drawn curve and the true one, as a share of the range of the true one.
function judgeCurve({curve}, points, {times, values}) {
    const known = values.filter(Number.isFinite);
    const range = Math.max(...known) - Math.min(...known) || Math.abs(known[0]) || 1;
    let sum = 0, count = 0;
    times.forEach((time, i) => {
        if (!Number.isFinite(values[i])) return;
        sum += Math.abs(curveAt(points, time) - values[i]);
        ++count;
    });
    const off = sum / count / range, isRight = off <= curve.within;
    const text = sayWith(isRight ? "Right: on the mean your curve is {0} of the whole range off."
        : "Not yet: on the mean your curve is {0} of the whole range off.", `${Math.round(100 * off)}${NO_BREAK}%`);
    return {isRight, text};
}

/// Between two drawn points a straight line.
function curveAt(points, time) {
    let i = points.findIndex(([t]) => t >= time);
    if (i === 0) return points[0][1];
    if (i < 0) return points.at(-1)[1];
    const [[t0, y0], [t1, y1]] = [points[i - 1], points[i]];
    return y0 + (time - t0) / (t1 - t0) * (y1 - y0);
}

/// Shows what is predicted with, and gives {said(), lock(isLocked)}; said() is null as long as nothing was said.
function numberWidget(host, {number}) {
    const {from, to, unit} = number, step = niceStep((to - from) / 200);
    const box = element("input", {type: "number", id: "said", step: "any"});
    const slider = element("input", {type: "range", min: from, max: to, step, value: (from + to) / 2,
        "aria-label": say("Your prediction")});
    slider.addEventListener("input", () => { box.value = slider.value; });
    box.addEventListener("input", () => { if (Number.isFinite(box.valueAsNumber)) slider.value = box.value; });
    const label = element("label", {for: "said"}, `${say("Your prediction")}: ${say(number.label)}`);
    host.replaceChildren(element("div", {class: "control"}, label, slider, box,
        element("span", {class: "unit"}, SHOWN_UNITS[unit] ?? unit)));
    return {
        said: () => (Number.isFinite(box.valueAsNumber) ? box.valueAsNumber : null),
        lock: (isLocked) => { box.disabled = slider.disabled = isLocked; },
        set: (value) => { box.value = slider.value = value; },
    };
}

function choiceWidget(host, {choice}) {
    const group = element("fieldset", {class: "options-list"}, element("legend", {class: "unseen"}, say("Your prediction")));
    choice.options.forEach((text, i) => group.append(element("label", {},
        element("input", {type: "radio", name: "said", value: i + 1}), element("span", {}, say(text)))));
    host.replaceChildren(group);
    return {
        said: () => Number(group.querySelector("input:checked")?.value) || null,
        lock: (isLocked) => { group.disabled = isLocked; },
        set: (value) => { group.querySelector(`input[value="${value}"]`).checked = true; },
    };
}

const HOW_TO_DRAW = "Draw {0} over the time: with the pointer, or choose a point by ← and → and move it by ↑ and ↓.";

/// scene: for its times; range: of the values, for the axis; unit.
function curveWidget(host, {curve}, times, range) {
    const pad = new CurvePad(times.at(-1), range, SHOWN_UNITS[curve.unit] ?? curve.unit);
    host.replaceChildren(element("p", {class: "note"}, sayWith(HOW_TO_DRAW, say(curve.label))), pad.figure);
    return {
        pad,
        said: () => (pad.isDrawn ? pad.points.map((point) => [...point]) : null),
        lock: (isLocked) => pad.lock(isLocked),
        set: (points) => pad.set(points),
        showTruth: (values) => pad.showTruth(times, values),
    };
}
