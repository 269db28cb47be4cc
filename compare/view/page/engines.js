// SPDX-License-Identifier: MIT
// How can each engine be told from the others? By its colour, and by its line, for people who see colours differently.
// All of this comes with the data: no engine is named here.

const LOOKS = new Map();

/// Called once, before anything is drawn. Each colour of an engine becomes a variable of the style sheet, one for each
/// theme.
function takeEngines(engines) {
    const rules = (colour) => engines.map((engine, i) => `--engine-${i}: ${engine[colour]};`).join(" ");
    engines.forEach((engine, i) => LOOKS.set(engine.name, {...engine, color: `--engine-${i}`}));
    document.head.append(element("style", {}, `:root { ${rules("onLight")} }
        @media (prefers-color-scheme: dark) { :root { ${rules("onDark")} } }`));
}

function lookOf(engine) {
    return LOOKS.get(engine) ??
        {name: engine, label: engine, role: "guest", color: "--other", dash: [6, 3, 1, 3], width: 2};
}

/// Is this the closed form, from which distances are measured?
function isTruth(engine) {
    return lookOf(engine).role === "truth";
}

/// Is this the engine that the comparison is about?
function isSubject(engine) {
    return lookOf(engine).role === "subject";
}

/// A colour of the style sheet, in the current light or dark theme.
function themeColor(variable) {
    return getComputedStyle(document.documentElement).getPropertyValue(variable).trim();
}

/// The engine's mark beside its name: its disc as drawn on the stage.
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
    return element("span", {class: "engine"}, engineMark(engine), say(lookOf(engine).label));
}
