// SPDX-License-Identifier: MIT
// What does the page of one lab hold? What is seen, the graphs, and the checks.

function labAddress(lab) {
    return `#lab=${encodeURIComponent(lab.name)}`;
}

function labLimitText({atMost, limit, unit}) {
    return (atMost ? "≤" : "≥") + NO_BREAK + chosenQuantity(limit, unit || "-");
}

function labFailureText(outcome) {
    const value = outcome.value === null ? "no value" : quantity(outcome.value, outcome.unit || "-");
    return `${outcome.check}: ${value}, not ${labLimitText(outcome)}`;
}

function labChecksTable(lab) {
    if (lab.pass === null) return [element("caption", {}, notJudgedText("lab", lab))];
    const heads = [columnHead(""), columnHead("Check"), columnHead("Value", true), columnHead("Limit", true),
        columnHead("Why this limit")];
    const rows = lab.outcomes.map((outcome) => element("tr", {class: outcome.pass ? null : "failing"},
        element("td", {}, verdictMark(outcome.pass)), element("td", {}, element("code", {}, outcome.check)),
        element("td", {class: "number"}, quantity(outcome.value, outcome.unit || "-")),
        element("td", {class: "number"}, labLimitText(outcome)),
        element("td", {class: "reason"}, outcome.reason)));
    return table(heads, rows);
}

/// One row for each point of the lab's curves.
function labCsv(lab) {
    const rows = [["graph", "curve", "x", "y"]];
    for (const {title, curves} of lab.graphs) {
        for (const {name, xs, ys} of curves) xs.forEach((x, i) => rows.push([title, name, x, ys[i]]));
    }
    return csvText(rows);
}

class LabPage {
    constructor() {
        this.lab = null;
        this.charts = [];
        byId("lab-csv").addEventListener("click", () => download(`${this.lab.name}.csv`, labCsv(this.lab)));
        new ResizeObserver(() => this.charts.forEach((chart) => chart.graph?.resize())).observe(byId("lab-graphs"));
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    }

    draw() {
        for (const chart of this.charts) chart.draw();
    }

    open(lab) {
        this.close();
        this.lab = unpackLab(lab);
        byId("lab-title").textContent = titleText(lab);
        byId("lab-question").textContent = lab.question;
        byId("lab-varied").textContent = `Varied: ${lab.varied}.`;
        const failed = failures(lab);
        const verdict = lab.pass === null ? notJudgedText("lab", lab)
            : failed.length === 1 ? labFailureText(failed[0])
            : `${lab.outcomes.length - failed.length} of ${lab.outcomes.length} checks`;
        byId("lab-verdict").replaceChildren(verdictMark(lab.pass), element("span", {}, verdict));
        byId("lab-seen").replaceChildren(...lab.seen.map((sentence) => element("li", {}, sentence)));
        byId("lab-checks").replaceChildren(...labChecksTable(lab));
        this.charts = lab.graphs.map((graph) => new LabChart(graph, lab.looks));
        byId("lab-graphs").replaceChildren(...this.charts.map((chart) => chart.figure));
        this.draw();
    }

    close() {
        for (const chart of this.charts) chart.clear();
        this.charts = [];
        this.lab = null;
    }
}
