// SPDX-License-Identifier: MIT
// What can be switched on a stage? What is drawn, the tools to measure with, and the engines that are seen.

/// What may be drawn besides the bodies, each with its checkbox.
const DRAWN = ["path", "trails", "velocity", "components", "acceleration", "momentum", "force", "causes"];

/// What a page shows before a scene is open.
function emptyView() {
    return {scene: null, hidden: new Set(), magnify: 1, aim: wholeView(), theme: stageTheme(), tools: {}};
}

/// The page has a view, a player, charts, and draw(), showTime() and restyle(); drawn: the ids of its checkboxes.
function bindSwitches(page, drawn = DRAWN) {
    for (const name of drawn) {
        byId(name).addEventListener("change", ({target}) => { page.view[name] = target.checked; page.draw(); });
    }
    for (const tool of Object.keys(TOOLS)) {
        byId(tool).addEventListener("change", ({target}) => takeTool(page, tool, target.checked));
    }
    byId("stopwatch").addEventListener("click", () => { page.player.pressStopwatch(); page.showTime(); });
    new ResizeObserver(() => page.restyle()).observe(byId("stage"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => page.restyle());
}

/// Takes a tool, or puts it away.
function takeTool(page, tool, isTaken) {
    if (isTaken) page.view.tools[tool] = toolPoints(page.view.camera, tool);
    else delete page.view.tools[tool];
    page.draw();
}

/// One checkbox for each engine; one that does not run the scene says why.
function showEngineKeys(page, scene) {
    byId("engine-keys").replaceChildren(...scene.engines.map(({name, unsupported}) => {
        const input = element("input", {type: "checkbox", "data-engine": name,
            onchange: ({target}) => seeEngine(page, name, target.checked)});
        input.checked = !unsupported && !page.view.hidden.has(name);
        input.disabled = Boolean(unsupported);
        return element("label", {title: unsupported ?? ""}, input, element("span", {}, engineName(name)));
    }));
}

function seeEngine(page, name, isSeen) {
    if (isSeen) page.view.hidden.delete(name);
    else page.view.hidden.add(name);
    page.charts.setHidden(page.view.hidden);
    page.draw();
}
