// SPDX-License-Identifier: MIT
// What are the results of all scenes and labs?

function allEngines(report) {
    const names = new Set(report.scenes.flatMap((scene) => scene.engines.map((engine) => engine.name)));
    return [...names].filter((name) => !isTruth(name));
}

/// What stands first where no scene is judged: the farthest of all engines. Null if there are no distances.
function farthestSum(scenes) {
    const all = scenes.filter((scene) => apartText(scene))
        .flatMap((scene) => scene.engines.map((engine) => ({scene, engine, apart: apartOf(engine) ?? -1})));
    if (all.length === 0) return null;
    const {scene, engine, apart} = all.reduce((far, next) => (next.apart > far.apart ? next : far));
    const subject = lookOf(scene.engines.find(({name}) => isSubject(name)).name).label;
    return element("li", {}, element("span", {class: "sum"}, element("b", {}, quantity(apart, "m"))),
        `from ${subject} at most: ${lookOf(engine.name).label} in “${titleText(scene)}”`);
}

function isNoneJudged(scenes) {
    return scenes.every(({pass}) => pass === null);
}

function sums(report) {
    const outcomes = [...report.scenes, ...report.labs].flatMap((judged) => judged.outcomes);
    const exact = report.scenes.filter((scene) => scene.closedForm);
    const close = exact.filter((scene) => {
        const error = scene.engines.find((engine) => isSubject(engine.name))?.metrics.error_max;
        return typeof error === "number" && error <= 1e-3;
    });
    const passing = (list) => list.filter(({pass}) => pass);
    const sum = (some, all, what, unjudged = "") => {
        const count = element("span", {class: "sum"}, element("b", {}, String(some.length)), ` of ${all.length}`);
        return element("li", {}, count, what, unjudged);
    };
    const scenesSum = () => isNoneJudged(report.scenes) && farthestSum(report.scenes)
        || judgedSum(report.scenes, "scenes hold");
    const judgedSum = (list, what) => sum(passing(list), list, what, unjudgedText(list));
    // The labs are below all scenes; this link leads to them.
    const labsLink = report.labs.length > 0 ? element("a", {href: labAddress(report.labs[0])}, "labs hold") : null;
    return [
        ...(report.scenes.length > 0 ? [scenesSum()] : []),
        ...(report.labs.length > 0 ? [judgedSum(report.labs, labsLink)] : []),
        ...(outcomes.length > 0 ? [sum(passing(outcomes), outcomes, "checks hold")] : []),
        ...(exact.length > 0 ? [sum(close, exact, "closed forms that Plumb follows to within 1 mm")] : []),
    ];
}

/// The result of an engine in one cell: its distance to the closed form, or why there is none.
function errorCell(scene, name) {
    const engine = scene.engines.find((candidate) => candidate.name === name);
    const cell = (attributes, text) => element("td", attributes, engineMark(name), text);
    if (!engine) return cell({class: "figure number none absent"}, NONE);
    if (engine.unsupported) return cell({class: "figure number none", title: engine.unsupported}, "unsupported");
    const compared = scene.engines.filter((other) => !isTruth(other.name) && !other.unsupported);
    const isBest = bestOf("error_max", compared.map((other) => other.metrics.error_max));
    const value = engine.metrics.error_max;
    const none = typeof value !== "number";
    const looks = `${none ? " none absent" : ""}${isBest(value) ? " best" : ""}`;
    return cell({class: `figure number${looks}`}, quantity(value, "m"));
}

function sceneAddress(scene) {
    return `#scene=${encodeURIComponent(scene.name)}`;
}

/// How many checks hold; "none" if none was judged.
function checksCell(what, judged) {
    const title = judged.pass === null ? notJudgedText(what, judged) : null;
    const all = judged.outcomes.length;
    const text = judged.pass === null ? "none" : `${all - failures(judged).length}/${all}`;
    return element("td", {class: `checked number${title ? " none" : ""}`, title}, text);
}

function verdictRow(scene, engines, pictures) {
    const failed = failures(scene);
    const apart = apartText(scene);
    const canvas = element("canvas", {class: "picture", "aria-hidden": "true"});
    pictures.add(canvas, scene);
    const link = {href: sceneAddress(scene), tabindex: -1, "aria-label": titleText(scene)};
    return element("tr", {class: scene.pass === false ? "failing" : null},
        element("td", {class: "pictured"}, element("a", link, canvas)),
        element("th", {scope: "row"}, element("a", {href: sceneAddress(scene)}, titleText(scene)),
            element("p", {class: "question"}, scene.question),
            apart && element("p", {class: "apart", title: "The largest distance of a body"}, apart),
            ...failed.slice(0, 3).map((outcome) => element("p", {class: "failure"}, failureText(scene, outcome))),
            failed.length > 3 ? element("p", {class: "failure"}, `and ${failed.length - 3} more`) : null),
        element("td", {}, verdictMark(scene.pass)),
        checksCell("scene", scene),
        ...engines.map((name) => errorCell(scene, name)));
}

/// One table body for each group, and a button that goes there.
function groupBodies(report, engines, pictures) {
    const bodies = new Map();
    for (const scene of report.scenes) {
        if (!bodies.has(scene.group)) {
            const columns = 4 + engines.length;
            const head = element("th", {scope: "rowgroup", colspan: columns}, element("h2", {}, scene.group));
            bodies.set(scene.group, element("tbody", {}, element("tr", {class: "group"}, head)));
        }
        bodies.get(scene.group).append(verdictRow(scene, engines, pictures));
    }
    if (bodies.size > 1) {
        byId("groups").append(...[...bodies].map(([name, body]) => element("button", {type: "button",
            onclick: () => body.scrollIntoView({block: "start"})}, name,
            element("span", {class: "count"}, String(body.rows.length - 1)))));
    }
    return [...bodies.values()];
}

function labRow(lab) {
    const failed = failures(lab);
    return element("tr", {class: lab.pass === false ? "failing" : null},
        element("th", {scope: "row"}, element("a", {href: labAddress(lab)}, titleText(lab)),
            element("p", {class: "question"}, lab.question),
            ...failed.map((outcome) => element("p", {class: "failure"}, labFailureText(outcome)))),
        element("td", {}, verdictMark(lab.pass)),
        checksCell("lab", lab),
        element("td", {class: "question seen-first"}, lab.seen[0] ?? ""));
}

function fillLabs(report) {
    byId("labs").hidden = report.labs.length === 0;
    const heads = [columnHead("Lab"), columnHead("Verdict"), columnHead("Checks", true), columnHead("What is seen")];
    byId("lab-verdicts").append(...table(heads, report.labs.map(labRow)));
}

/// The texts that the search looks through.
function searchedRows(report) {
    const scenes = [...byId("verdicts").querySelectorAll("tbody tr:not(.group)")];
    const labs = [...byId("lab-verdicts").querySelectorAll("tbody tr")];
    return [
        ...report.scenes.map((scene, i) => ({row: scenes[i],
            texts: [titleText(scene), scene.name, scene.question, scene.group]})),
        ...report.labs.map((lab, i) => ({row: labs[i], texts: [titleText(lab), lab.name, lab.question, "lab"]})),
    ];
}

function fillOverview(report) {
    const engines = allEngines(report);
    byId("sums").append(...sums(report));
    const heads = [columnHead(""), columnHead("Scene"), columnHead("Verdict"), columnHead("Checks", true),
        ...engines.map((name) => columnHead(engineName(name), true))];
    byId("verdicts").append(element("thead", {}, element("tr", {}, ...heads)),
        ...groupBodies(report, engines, new Pictures()));
    byId("verdicts").hidden = byId("verdicts-note").hidden = report.scenes.length === 0;
    byId("verdicts-csv").hidden = report.scenes.length === 0;
    fillLabs(report);
    bindSearch(searchedRows(report));
    byId("verdicts-csv").addEventListener("click", () => download("plumb_numbers.csv", numbersCsv(report.scenes)));
}

/// The list at the side of a scene: the same verdicts in short form.
function fillSceneList(report) {
    byId("scene-list-sum").textContent = isNoneJudged(report.scenes)
        ? `${report.scenes.length} ${report.scenes.length === 1 ? "scene" : "scenes"}, not judged`
        : countText(report.scenes, "scenes");
    byId("scene-list-sum").hidden = report.scenes.length === 0;
    let group = "";
    for (const scene of report.scenes) {
        if (scene.group !== group) byId("scene-list-items").append(element("li", {class: "group"}, scene.group));
        group = scene.group;
        const figures = element("span", {class: "figures"});
        for (const engine of scene.engines) {
            if (isTruth(engine.name) || typeof engine.metrics.error_max !== "number") continue;
            figures.append(element("span", {title: `${lookOf(engine.name).label}: largest distance to the closed form`},
                engineMark(engine.name), shortQuantity(engine.metrics.error_max, "m")));
        }
        const [failed] = failures(scene);
        byId("scene-list-items").append(listItem(scene, sceneAddress(scene), failed && failureText(scene, failed),
            figures.childElementCount > 0 ? figures : null));
    }
    fillLabList(report);
}

/// failure: the text if a check fails; figures: the element below, or null.
function listItem(judged, address, failure, figures) {
    const {kind, sign, word} = verdictSign(judged.pass);
    return element("li", {}, element("a", {href: address, title: judged.question},
        element("span", {class: `verdict ${kind}`, "aria-label": word}, sign),
        element("span", {class: "scene-name"}, titleText(judged)),
        failure ? element("span", {class: "failure"}, failure) : null, figures));
}

function fillLabList(report) {
    byId("lab-list-sum").textContent = countText(report.labs, "labs");
    byId("lab-list-sum").hidden = report.labs.length === 0;
    for (const lab of report.labs) {
        const [failed] = failures(lab);
        byId("lab-list-items").append(listItem(lab, labAddress(lab), failed && labFailureText(failed), null));
    }
}
