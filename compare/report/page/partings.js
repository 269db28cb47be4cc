// SPDX-License-Identifier: MIT
// Where do two engines part, and why?

/// Without the names at its start, which stand before it as marks, and with the engines' own names in it.
function partingText({a, b, text}) {
    const names = `${a} and ${b}`;
    const rest = text.startsWith(names) ? text.slice(names.length).replace(/^:? /, "") : text;
    return [a, b].reduce((so, name) => so.replaceAll(` in ${name}`, ` in ${lookOf(name).label}`), rest);
}

/// body is empty where the two stay together: then there is no moment to go to.
function partingItem(parting) {
    const {a, b, body, time} = parting;
    const when = body === "" ? element("span", {class: "when none"}, "together")
        : element("span", {class: "when"}, `${time.toFixed(2)}${NO_BREAK}s`);
    return element("li", {}, element("button", {type: "button", "data-time": time, disabled: body === "",
        title: body === "" ? null : "Go to this moment"},
        element("span", {class: "pair"}, engineName(a), engineName(b)), when,
        element("span", {class: "why"}, partingText(parting))));
}

/// Those of the engine that the comparison is about, and the others on demand.
function partingsParts(scene) {
    const isMain = ({a, b}) => isSubject(a) || isSubject(b);
    const list = (partings) => element("ul", {}, ...partings.map(partingItem));
    const main = scene.partings.filter(isMain);
    const others = scene.partings.filter((parting) => !isMain(parting));
    if (main.length === 0 || others.length === 0) return [list(scene.partings)];
    const summary = element("summary", {}, "The other engines among themselves");
    return [list(main), element("details", {}, summary, list(others))];
}
