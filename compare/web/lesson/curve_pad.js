// SPDX-License-Identifier: MIT
// How does a person draw a curve over time? With the pointer, or point by point with the arrow keys.

const PAD_POINTS = 13;
const PAD = {width: 360, height: 190, left: 44, right: 10, top: 10, bottom: 26};

function svgElement(tag, attributes = {}) {
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    return made;
}

class CurvePad {
    /// duration [s]; range: lowest and highest value that can be drawn.
    constructor(duration, [low, high], unit) {
        Object.assign(this, {duration, low, high, unit, chosen: 0, isDrawn: false, isLocked: false});
        const middle = (low + high) / 2;
        this.points = Array.from({length: PAD_POINTS}, (_, i) => [i * duration / (PAD_POINTS - 1), middle]);
        this.svg = svgElement("svg", {viewBox: `0 0 ${PAD.width} ${PAD.height}`, class: "curve-pad", tabindex: 0, role: "slider",
            "aria-label": say("Your curve"), "aria-valuemin": low, "aria-valuemax": high});
        this.truth = svgElement("polyline", {class: "pad-truth"});
        this.line = svgElement("polyline", {class: "pad-line"});
        this.mark = svgElement("circle", {class: "pad-mark", r: 5});
        this.svg.append(...this.axes(), this.truth, this.line, this.mark);
        this.figure = element("div", {class: "pad-frame"});
        this.figure.append(this.svg);
        this.svg.addEventListener("pointerdown", (event) => this.press(event));
        this.svg.addEventListener("pointermove", (event) => this.drag(event));
        this.svg.addEventListener("pointerup", () => { this.last = null; });
        this.svg.addEventListener("keydown", (event) => this.key(event));
        this.draw();
    }

    x(time) { return PAD.left + time / this.duration * (PAD.width - PAD.left - PAD.right); }
    y(value) { return PAD.top + (this.high - value) / (this.high - this.low) * (PAD.height - PAD.top - PAD.bottom); }

    axes() {
        const parts = [svgElement("rect", {class: "pad-paper", x: PAD.left, y: PAD.top, width: PAD.width - PAD.left - PAD.right,
            height: PAD.height - PAD.top - PAD.bottom})];
        const line = (x0, y0, x1, y1) => svgElement("line", {class: "pad-grid", x1: x0, y1: y0, x2: x1, y2: y1});
        const label = (text, x, y, anchor) => {
            const made = svgElement("text", {class: "pad-label", x, y, "text-anchor": anchor});
            made.textContent = text;
            return made;
        };
        const step = niceStep((this.high - this.low) / 5), of = niceStep(this.duration / 5);
        eachLine(this.low, this.high, step, (value) => parts.push(
            line(PAD.left, this.y(value), PAD.width - PAD.right, this.y(value)),
            label(axisText(value, step), PAD.left - 5, this.y(value) + 4, "end")));
        eachLine(0, this.duration, of, (time) => parts.push(line(this.x(time), PAD.top, this.x(time), PAD.height - PAD.bottom),
            label(axisText(time, of), this.x(time), PAD.height - 10, "middle")));
        parts.push(label(`[${this.unit}]`, PAD.left + 5, PAD.top + 13, "start"),
            label("t [s]", PAD.width - PAD.right - 5, PAD.height - PAD.bottom - 6, "end"));
        return parts;
    }

    /// The place of a pointer: the nearest point, and the value there.
    placeOf(event) {
        const box = this.svg.getBoundingClientRect();
        const px = (event.clientX - box.left) / box.width * PAD.width, py = (event.clientY - box.top) / box.height * PAD.height;
        const share = (px - PAD.left) / (PAD.width - PAD.left - PAD.right);
        const index = Math.round(Math.min(1, Math.max(0, share)) * (PAD_POINTS - 1));
        const value = this.high - (py - PAD.top) / (PAD.height - PAD.top - PAD.bottom) * (this.high - this.low);
        return {index, value: Math.min(this.high, Math.max(this.low, value))};
    }

    press(event) {
        if (this.isLocked) return;
        this.svg.setPointerCapture(event.pointerId);
        this.last = this.placeOf(event);
        this.put(this.last.index, this.last.value);
    }

    /// A quick move passes over points: they come to lie on the line between.
    drag(event) {
        if (!this.last || this.isLocked) return;
        const now = this.placeOf(event), from = this.last, way = Math.sign(now.index - from.index) || 1;
        for (let i = from.index; i !== now.index + way; i += way) {
            const share = now.index === from.index ? 1 : (i - from.index) / (now.index - from.index);
            this.points[i][1] = from.value + share * (now.value - from.value);
        }
        this.last = now;
        this.put(now.index, now.value);
    }

    key(event) {
        const step = (this.high - this.low) / (event.shiftKey ? 10 : 40);
        const [, value] = this.points[this.chosen];
        const acts = {
            ArrowLeft: () => this.choose(this.chosen - 1),
            ArrowRight: () => this.choose(this.chosen + 1),
            ArrowUp: () => this.put(this.chosen, Math.min(this.high, value + step)),
            ArrowDown: () => this.put(this.chosen, Math.max(this.low, value - step)),
        };
        if (!acts[event.key] || this.isLocked) return;
        event.preventDefault();
        event.stopPropagation();
        acts[event.key]();
    }

    choose(index) {
        this.chosen = Math.min(PAD_POINTS - 1, Math.max(0, index));
        this.draw();
    }

    put(index, value) {
        this.points[index][1] = value;
        this.isDrawn = true;
        this.choose(index);
    }

    set(points) {
        this.points = points.map((point) => [...point]);
        this.isDrawn = true;
        this.draw();
    }

    lock(isLocked) { this.isLocked = isLocked; }

    showTruth(times, values) {
        const shown = [...times].map((time, i) => [time, values[i]]).filter(([, value]) => Number.isFinite(value));
        this.truth.setAttribute("points", shown.map(([time, value]) =>
            `${this.x(time).toFixed(1)},${Math.min(PAD.height, Math.max(0, this.y(value))).toFixed(1)}`).join(" "));
    }

    draw() {
        this.svg.classList.toggle("drawn", this.isDrawn);
        const [time, value] = this.points[this.chosen];
        this.line.setAttribute("points", this.points.map(([t, v]) => `${this.x(t)},${this.y(v)}`).join(" "));
        this.mark.setAttribute("cx", this.x(time));
        this.mark.setAttribute("cy", this.y(value));
        this.svg.setAttribute("aria-valuenow", Number(value.toPrecision(3)));
        this.svg.setAttribute("aria-valuetext",
            `${numberText(time.toFixed(2))} s: ${numberText(value.toPrecision(3))} ${this.unit}`);
    }
}
