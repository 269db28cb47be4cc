// SPDX-License-Identifier: MIT
// Where do two engines part, and why?

/// The text without the two names at its start, because marks show them; other names become the engines' labels.
function partingText({a, b, text}) {
    const names = `${a} and ${b}`;
    const rest = text.startsWith(names) ? text.slice(names.length).replace(/^:? /, "") : text;
    return [a, b].reduce((so, name) => so.replaceAll(` in ${name}`, ` in ${lookOf(name).label}`), rest);
}

/// body is empty if the two stay together: then there is no moment to go to.
function partingItem(parting) {
    const {a, b, body, time} = parting;
    const when = body === "" ? element("span", {class: "when none"}, "together")
        : element("span", {class: "when"}, `${time.toFixed(2)}${NO_BREAK}s`);
    return element("li", {}, element("button", {type: "button", "data-time": time, disabled: body === "",
        title: body === "" ? null : "Go to this moment"},
        element("span", {class: "pair"}, engineName(a), engineName(b)), when,
        element("span", {class: "why"}, partingText(parting))));
}

/// The partings of the engine that the comparison is about; the others are folded.
function partingsParts(scene) {
    const isMain = ({a, b}) => isSubject(a) || isSubject(b);
    const list = (partings) => element("ul", {}, ...partings.map(partingItem));
    const main = scene.partings.filter(isMain);
    const others = scene.partings.filter((parting) => !isMain(parting));
    if (main.length === 0 || others.length === 0) return [list(scene.partings)];
    const summary = element("summary", {}, "The other engines among themselves");
    return [list(main), element("details", {}, summary, list(others))];
}
