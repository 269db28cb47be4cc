// SPDX-License-Identifier: MIT
// How does one quantity change over time in each engine?

function chartText() {
    return Math.round(0.84 * parseFloat(getComputedStyle(document.documentElement).fontSize));
}

/// Whole powers of ten, as many as fit.
function decadeTicker(low, high, pixels) {
    const first = Math.round(Math.log10(low));
    const last = Math.round(Math.log10(high));
    const fit = Math.max(2, Math.floor(pixels / (2.2 * chartText())));
    const step = Math.max(1, Math.ceil((last - first) / fit));
    const ticks = [];
    for (let exponent = first; exponent <= last; exponent += step) {
        ticks.push({v: 10 ** exponent, label: powerOfTen(exponent)});
    }
    return ticks;
}

function evenTicker(low, high, pixels, space, unit = "") {
    const step = niceStep((high - low) / Math.max(2, Math.floor(pixels / space)));
    const ticks = [];
    eachLine(low, high, step, (v) => ticks.push({v, label: axisText(v, step) + unit}));
    return ticks;
}

/// The look of its engine, or one of its own.
function lookOfLine(line) {
    return line.look ?? lookOf(line.engine);
}

class Chart {
    /// seek(t) is called when a person clicks, and zoomed(window) when a person drags or double-clicks.
    constructor(heading, seek, zoomed) {
        this.seek = seek;
        this.zoomed = zoomed;
        this.readout = element("dl", {class: "readout"});
        this.plot = element("div", {class: "plot"});
        this.cursor = element("div", {class: "cursor", hidden: true});
        this.limit = element("div", {class: "limit", hidden: true});
        this.figure = element("figure", {class: "chart"},
            element("figcaption", {}, heading, this.readout),
            element("div", {class: "plot-frame"}, this.plot, this.limit, this.cursor));
        this.graph = null;
        this.hidden = new Set();
    }

    /// curve: from logarithmic() or linear(); marks: see drawLimits; axis: the name beside the axis.
    show(curve, marks, axis) {
        this.clear();
        this.curve = curve;
        this.figure.hidden = curve.lines.length === 0;
        if (this.figure.hidden) return;
        this.values = curve.lines.map((line) => {
            const {engine} = line, label = say(lookOfLine(line).label);
            const name = line.look ? element("dt", {style: `color: var(${line.look.color})`}, label)
                : element("dt", {title: label}, engineMark(engine), element("span", {class: "unseen"}, label));
            const value = element("dd");
            const hidden = this.hidden.has(engine);
            this.readout.append(element("div", {"data-engine": engine, hidden}, name, value));
            return value;
        });
        this.graph = new Dygraph(this.plot, this.rows(), this.settings(marks, axis));
    }

    rows() {
        const {times, lines} = this.curve;
        return Array.from(times, (t, i) => [t, ...lines.map(({drawn}) => {
            const value = drawn[i];
            return Number.isFinite(value) ? value : null;
        })]);
    }

    /// A little more than the run, because otherwise its last tick has no label.
    wholeWindow() {
        const {times} = this.curve;
        return [0, 1.00001 * (times[times.length - 1] || 1)];
    }

    settings(marks, axis) {
        // A lesson may count steps in place of seconds.
        const {lines, range, logarithmic: isLog, unit, timeUnit = `${NO_BREAK}s`} = this.curve;
        const text = chartText();
        const series = {};
        for (const line of lines) {
            const look = lookOfLine(line);
            series[line.engine] = {color: themeColor(look.color), strokeWidth: look.width,
                strokePattern: look.dash.length > 0 ? look.dash : null};
        }
        const dense = Math.round(5 * text);
        // For an even axis, as axisText writes its ticks.
        const hasPowers = !isLog && (range[1] - range[0] < 1e-4 || Math.max(...range.map(Math.abs)) >= 1e5);
        return {
            labels: ["t", ...lines.map(({engine}) => engine)], series, legend: "never",
            visibility: lines.map(({engine}) => !this.hidden.has(engine)),
            stackedGraph: Boolean(this.curve.stacked), valueRange: range, logscale: isLog, dateWindow: this.wholeWindow(),
            ylabel: axis.length > 12 ? `[${unit}]` : `${axis} [${unit}]`, yLabelWidth: text + 6,
            axisLabelFontSize: text, gridLineColor: themeColor("--grid"), axisLineColor: themeColor("--axis"),
            highlightCircleSize: 0, rightGap: 2 * text, xRangePad: 0,
            axes: {
                x: {ticker: (low, high, pixels) => evenTicker(low, high, pixels, dense, timeUnit)},
                y: {axisLabelWidth: Math.round((hasPowers ? 6.6 : 5.4) * text), ticker: (low, high, pixels) =>
                    isLog ? decadeTicker(low, high, pixels) : evenTicker(low, high, pixels, 1.9 * text)},
            },
            underlayCallback: (context, area, graph) => drawLimits(context, area, graph, marks),
            clickCallback: (event) => {
                this.seek(this.graph.toDataXCoord(event.clientX - this.plot.getBoundingClientRect().left));
            },
            zoomCallback: () => this.zoomed(this.graph.isZoomed("x") ? this.graph.xAxisRange() : null),
            drawCallback: (graph) => {
                placeLimit(this.limit, graph, marks, unit);
                this.moveTo(this.time ?? 0);
            },
        };
    }

    moveTo(time) {
        this.time = time;
        if (!this.graph) return;
        const area = this.graph.getArea();
        const x = this.graph.toDomXCoord(time);
        this.cursor.hidden = !(x >= area.x - 1 && x <= area.x + area.w + 1);
        this.cursor.style.transform = `translateX(${x}px)`;
        this.cursor.style.top = `${area.y}px`;
        this.cursor.style.height = `${area.h}px`;
        const at = indexAt(this.curve.times, time);
        this.curve.lines.forEach(({values}, line) => {
            const text = this.curve.ruler ? rulerText : quantity;
            this.values[line].textContent = text(values[at], this.curve.unit);
        });
    }

    /// Null shows the whole run again.
    setWindow(window) {
        if (!this.graph) return;
        if (window) this.graph.updateOptions({dateWindow: window});
        else this.graph.updateOptions({dateWindow: this.wholeWindow(), valueRange: this.curve.range});
    }

    setHidden(hidden) {
        this.hidden = new Set(hidden);
        if (!this.graph) return;
        const shown = this.curve.lines.map(({engine}, line) => [line, !hidden.has(engine)]);
        this.graph.setVisibility(Object.fromEntries(shown));
        for (const row of this.readout.children) row.hidden = hidden.has(row.dataset.engine);
    }

    clear() {
        this.graph?.destroy();
        this.graph = null;
        this.readout.replaceChildren();
        this.cursor.hidden = this.limit.hidden = true;
    }
}
