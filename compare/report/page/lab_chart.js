// SPDX-License-Identifier: MIT
// How does one graph of a lab look? Named curves over any quantity, on even or logarithmic axes.

const CURVE_COLORS = 8;
const CURVE_DASHES = [[], [9, 5], [3, 3], [11, 4, 2, 4], [5, 3], [14, 5], [2, 4], [7, 3, 2, 3, 2, 3]];

/// A look for each name in a lab's graphs: an engine's own look, else the next colour of the style sheet. The theory is
/// a thin dotted line in ink.
function labLooks(lab) {
    const looks = new Map();
    let next = 0;
    for (const {name, theory} of lab.graphs.flatMap(({curves}) => curves)) {
        if (looks.has(name)) continue;
        if (theory) looks.set(name, {label: name, color: "--ink", dash: [1, 4], width: 1.8});
        else if (LOOKS[name]) looks.set(name, LOOKS[name]);
        else {
            looks.set(name, {label: name, color: `--curve-${(next % CURVE_COLORS) + 1}`,
                dash: CURVE_DASHES[next % CURVE_DASHES.length], width: 2});
            ++next;
        }
    }
    return looks;
}

function unpackLab(lab) {
    if (lab.unpacked) return lab;
    for (const curve of lab.graphs.flatMap(({curves}) => curves)) {
        curve.xs = unpack(curve.xs);
        curve.ys = unpack(curve.ys);
    }
    lab.looks = labLooks(lab);
    lab.unpacked = true;
    return lab;
}

/// 1, 2, 5, 10 if there are few powers of ten; else whole powers, as many as fit.
function powerTicker(low, high, pixels, space) {
    const decades = Math.log10(high / low);
    const fit = Math.max(2, Math.floor(pixels / space));
    const leads = decades * 3 <= fit ? [1, 2, 5] : [1];
    const every = leads.length > 1 ? 1 : Math.max(1, Math.ceil(decades / fit));
    const ticks = [];
    for (let exponent = Math.floor(Math.log10(low)); 10 ** exponent <= high * 1.0001; exponent += every) {
        for (const lead of leads) {
            const v = lead * 10 ** exponent;
            if (v < low * 0.9999 || v > high * 1.0001) continue;
            const plain = v >= 0.01 && v < 10000;
            const power = lead === 1 ? powerOfTen(exponent) : `${lead}·${powerOfTen(exponent)}`;
            ticks.push({v, label: plain ? String(Number(v.toPrecision(3))) : power});
        }
    }
    return ticks;
}

/// The range of the values that an axis can show, extended to whole powers of ten, or by a little room on either side.
/// A share is shown from 0 to 100 %.
function axisRange(columns, {logarithmic, unit}, tight) {
    if (unit === "%" && !logarithmic) return [-4, 104];
    let low = Infinity;
    let high = -Infinity;
    for (const value of columns.flatMap((column) => Array.from(column))) {
        if (!Number.isFinite(value) || (logarithmic && value <= 0)) continue;
        low = Math.min(low, value);
        high = Math.max(high, value);
    }
    if (!(low <= high)) return logarithmic ? [0.1, 10] : [-1, 1];
    if (logarithmic && tight) return [low / 1.1, high * 1.1];
    if (logarithmic) {
        const bottom = Math.floor(Math.log10(low) + 1e-9);
        return [10 ** bottom, 10 ** Math.max(bottom + 1, Math.ceil(Math.log10(high) - 1e-9))];
    }
    const room = tight ? 0 : 0.08 * Math.max(high - low, 0.02 * Math.max(Math.abs(low), Math.abs(high)), 1e-12);
    return [low - room, high + room + (high > low ? 1e-5 * (high - low) : 1)];
}

function axisTitle({label, unit}) {
    return unit ? `${label} [${unit}]` : label;
}

function axisTicker({logarithmic}, space) {
    const ticker = logarithmic ? powerTicker : evenTicker;
    return (low, high, pixels) => ticker(low, high, pixels, space);
}

/// A short piece of the curve for the legend.
function curveMark(look) {
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    svg.setAttribute("viewBox", "0 0 34 10");
    svg.setAttribute("class", "stroke");
    svg.setAttribute("aria-hidden", "true");
    svg.style.color = `var(${look.color})`;
    svg.innerHTML = `<path d="M1 5h32" stroke="currentColor" stroke-width="${look.width + 0.4}"
        stroke-dasharray="${look.dash.join(" ")}" fill="none"/>`;
    return svg;
}

function nearestIndex(xs, x) {
    const at = indexAt(xs, x);
    return at + 1 < xs.length && Math.abs(xs[at + 1] - x) < Math.abs(xs[at] - x) ? at + 1 : at;
}

class LabChart {
    constructor(graph, looks) {
        this.data = graph;
        this.looks = looks;
        this.values = graph.curves.map(() => element("output"));
        this.where = element("output", {class: "where"});
        this.plot = element("div", {class: "plot"});
        const legend = graph.curves.map(({name, note}, i) => element("li", {}, curveMark(looks.get(name)),
            looks.get(name).label, note ? element("span", {class: "curve-note"}, note) : null, this.values[i]));
        this.figure = element("figure", {class: "chart lab-chart"},
            element("figcaption", {}, element("h2", {}, graph.title), this.where),
            element("div", {class: "plot-frame"}, this.plot),
            element("ul", {class: "legend"}, ...legend));
    }

    /// Each curve has its own points: one row for each x that any curve has.
    rows() {
        const {curves, x, y} = this.data;
        const rows = new Map();
        curves.forEach(({xs, ys}, i) => xs.forEach((at, k) => {
            if (!Number.isFinite(at) || (x.logarithmic && at <= 0)) return;
            if (!rows.has(at)) rows.set(at, [at, ...curves.map(() => null)]);
            // dygraphs draws through null, and breaks a line at NaN.
            const value = ys[k];
            rows.get(at)[i + 1] = Number.isNaN(value) ? NaN : Number.isFinite(value) && (!y.logarithmic || value > 0)
                ? value : null;
        }));
        return [...rows.values()].sort((a, b) => a[0] - b[0]);
    }

    series() {
        return Object.fromEntries(this.data.curves.map(({name, xs, theory}) => {
            const look = this.looks.get(name);
            return [name, {color: themeColor(look.color), strokeWidth: look.width, drawPoints: !theory && xs.length <= 40,
                pointSize: 2.6, strokePattern: look.dash.length > 0 ? look.dash : null}];
        }));
    }

    draw() {
        this.clear();
        const {curves, x, y} = this.data;
        const text = chartText();
        const xRange = axisRange(curves.map(({xs}) => xs), x, true);
        const yRange = axisRange(curves.map(({ys}) => ys), y, false);
        this.graph = new Dygraph(this.plot, this.rows(), {
            labels: ["x", ...curves.map(({name}) => name)], series: this.series(), legend: "never",
            connectSeparatedPoints: true, dateWindow: xRange, valueRange: yRange, logscale: y.logarithmic,
            xlabel: axisTitle(x), ylabel: axisTitle(y), xLabelHeight: text + 8, yLabelWidth: text + 8,
            axisLabelFontSize: text, gridLineColor: themeColor("--grid"), axisLineColor: themeColor("--axis"),
            highlightCircleSize: 3, rightGap: Math.round(2.2 * text), xRangePad: 0,
            axes: {
                x: {logscale: x.logarithmic, axisLabelWidth: 4 * text, ticker: axisTicker(x, 4.5 * text)},
                y: {axisLabelWidth: Math.round(4.3 * text), ticker: axisTicker(y, 1.9 * text)},
            },
            highlightCallback: (event, at) => this.read(at),
            unhighlightCallback: () => this.read(null),
            zoomCallback: () => {
                if (!this.graph.isZoomed()) this.graph.updateOptions({dateWindow: xRange, valueRange: yRange});
            },
        });
    }

    /// The point of each curve nearest to this x; null: the pointer is not on the graph.
    read(at) {
        const {curves, x, y} = this.data;
        this.where.textContent = at === null ? "" : `${x.label} ${quantity(at, x.unit || "-")}`;
        curves.forEach(({xs, ys}, i) => {
            this.values[i].textContent = at === null || xs.length === 0 ? ""
                : quantity(ys[nearestIndex(xs, at)], y.unit || "-");
        });
    }

    clear() {
        this.graph?.destroy();
        this.graph = null;
    }
}
