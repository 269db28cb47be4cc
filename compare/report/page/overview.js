// SPDX-License-Identifier: MIT
// What came of all scenes?

function allEngines(report) {
    const names = new Set(report.scenes.flatMap((scene) => scene.engines.map((engine) => engine.name)));
    names.delete("closed-form");
    return [...names];
}

function failures(scene) {
    return scene.outcomes.filter((outcome) => !outcome.pass);
}

function sums(report) {
    const outcomes = report.scenes.flatMap((scene) => scene.outcomes);
    const exact = report.scenes.filter((scene) => scene.closedForm);
    const close = exact.filter((scene) => {
        const plumb = scene.engines.find((engine) => engine.name === "plumb")?.metrics.error_max;
        return typeof plumb === "number" && plumb <= 1e-3;
    });
    const part = (some, all) => [element("b", {}, String(some)), ` of ${all}`];
    return [
        element("li", {}, element("span", {class: "sum"}, ...part(report.scenes.filter((scene) => scene.pass).length, report.scenes.length)),
            "scenes hold"),
        element("li", {}, element("span", {class: "sum"}, ...part(outcomes.filter((outcome) => outcome.pass).length, outcomes.length)),
            "checks hold"),
        element("li", {}, element("span", {class: "sum"}, ...part(close.length, exact.length)),
            "closed forms met by Plumb within 1 mm"),
    ];
}

/// What to read of an engine in one line: its distance to the closed form, or why there is none.
function errorCell(scene, name) {
    const engine = scene.engines.find((candidate) => candidate.name === name);
    if (!engine) return element("td", {class: "number none"}, NONE);
    if (engine.unsupported) return element("td", {class: "number none", title: engine.unsupported}, "unsupported");
    const compared = scene.engines.filter((other) => other.name !== "closed-form" && !other.unsupported);
    const isBest = bestOf("error_max", compared.map((other) => other.metrics.error_max));
    const value = engine.metrics.error_max;
    const none = typeof value !== "number";
    return element("td", {class: `number${none ? " none" : ""}${isBest(value) ? " best" : ""}`}, quantity(value, "m"));
}

function sceneAddress(scene) {
    return `#scene=${encodeURIComponent(scene.name)}`;
}

function verdictRow(scene, engines) {
    const failed = failures(scene);
    return element("tr", {class: scene.pass ? null : "failing"},
        element("td", {}, verdictMark(scene.pass)),
        element("th", {scope: "row"}, element("a", {href: sceneAddress(scene)}, titleText(scene.name)),
            element("p", {class: "question"}, scene.question),
            ...failed.map((outcome) => element("p", {class: "failure"}, failureText(scene, outcome)))),
        element("td", {class: "number"}, `${scene.outcomes.length - failed.length}/${scene.outcomes.length}`),
        ...engines.map((name) => errorCell(scene, name)));
}

function fillOverview(report) {
    const engines = allEngines(report);
    byId("sums").append(...sums(report));
    byId("verdicts").append(
        element("caption", {}, "Verdicts. Under each engine: its largest distance to the closed form; the least is set in bold."),
        element("thead", {}, element("tr", {}, element("th", {scope: "col"}, "Verdict"), element("th", {scope: "col"}, "Scene"),
            element("th", {scope: "col", class: "number"}, "Checks"),
            ...engines.map((name) => element("th", {scope: "col", class: "number"}, engineName(name))))),
        element("tbody", {}, ...report.scenes.map((scene) => verdictRow(scene, engines))));
    byId("verdicts-csv").addEventListener("click", () => download("plumb_numbers.csv", numbersCsv(report.scenes)));
    byId("overview-note").textContent = "– : the scene has no closed form, and is judged by what must stay constant and by agreement. " +
        "Settings of every engine stand with each scene.";
}

/// The list at the side of a scene: the same verdicts, short.
function fillSceneList(report) {
    const held = report.scenes.filter((scene) => scene.pass).length;
    byId("scene-list-sum").textContent = `${held} of ${report.scenes.length} scenes hold`;
    for (const scene of report.scenes) {
        const figures = element("span", {class: "figures"});
        for (const engine of scene.engines) {
            if (engine.name === "closed-form" || typeof engine.metrics.error_max !== "number") continue;
            figures.append(element("span", {title: `${lookOf(engine.name).label}: largest distance to the closed form`},
                engineMark(engine.name), shortQuantity(engine.metrics.error_max, "m")));
        }
        const [failed] = failures(scene);
        byId("scene-list-items").append(element("li", {}, element("a", {href: sceneAddress(scene), "data-scene": scene.name, title: scene.question},
            element("span", {class: scene.pass ? "verdict holds" : "verdict fails", "aria-label": scene.pass ? "holds" : "fails"}, scene.pass ? "✓" : "✗"),
            element("span", {class: "scene-name"}, titleText(scene.name)),
            failed ? element("span", {class: "failure"}, failureText(scene, failed)) : null,
            figures.childElementCount > 0 ? figures : null)));
    }
}
