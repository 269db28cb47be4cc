// SPDX-License-Identifier: MIT
// How is each engine told from the others? By colour, and also by its stroke, for those who see colours differently.

const LOOKS = {
    "plumb": {label: "Plumb", color: "--plumb", dash: [], width: 2.5, filled: true},
    "box2d-2.4": {label: "Box2D 2.4", color: "--box2d-2", dash: [], width: 1.6},
    "box2d-3": {label: "Box2D 3", color: "--box2d-3", dash: [9, 5], width: 2},
    "box2d-2.4 bullets": {label: "Box2D 2.4 with bullets", color: "--box2d-2", dash: [2, 4], width: 2.4},
    "box2d-3 bullets": {label: "Box2D 3 with bullets", color: "--box2d-3", dash: [4, 3, 1, 3], width: 2.4},
    "closed-form": {label: "Closed form", color: "--closed-form", dash: [3, 4], width: 2, ghost: true},
};

function lookOf(engine) {
    return LOOKS[engine] ?? {label: engine, color: "--other", dash: [6, 3, 1, 3], width: 2};
}

/// A colour of the style sheet, as the light or dark theme has it.
function themeColor(variable) {
    return getComputedStyle(document.documentElement).getPropertyValue(variable).trim();
}

/// The engine's mark beside its name: its disc as the stage draws it.
function engineMark(engine) {
    const look = lookOf(engine);
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    svg.setAttribute("viewBox", "0 0 20 20");
    svg.setAttribute("class", "mark");
    svg.setAttribute("aria-hidden", "true");
    svg.style.color = `var(${look.color})`;
    const dash = look.dash.map((length) => length * 0.7).join(" ");
    const cross = look.ghost ? '<path d="M10 6.5v7M6.5 10h7" stroke="currentColor" stroke-width="1.5"/>' : "";
    svg.innerHTML = `<circle cx="10" cy="10" r="7.5" fill="currentColor" fill-opacity="${look.filled ? 0.35 : 0}"
        stroke="currentColor" stroke-width="2.2" stroke-dasharray="${dash}"/>${cross}`;
    return svg;
}

function engineName(engine) {
    return element("span", {class: "engine"}, engineMark(engine), lookOf(engine).label);
}
