// SPDX-License-Identifier: MIT
// Which numbers does a run have, in each engine? Those of the formula and of what was predicted, and its own error.

function queriesOf({predict, formula}) {
    const queries = [predict.number?.value, ...formula.flatMap(queriesIn)].filter(Boolean);
    return [...new Set(queries)].filter((query) => !/^(gravity|field )/.test(query));
}

function lessonNumbersTable(values, scene, lesson) {
    const engines = scene.running.filter(({run, unsupported}) => run !== undefined && !unsupported);
    const heads = [columnHead(""), ...engines.map(({name}) => columnHead(engineName(name), true))];
    const rows = queriesOf(lesson).map((query) => element("tr", {}, rowHead(say(query)),
        ...engines.map((engine) => element("td", {class: "number"}, valueText(values.of(engine, query))))));
    const hasTruth = engines.some(({name}) => isTruth(name));
    if (hasTruth) {
        rows.push(element("tr", {}, rowHead(say("largest distance to the closed form")), ...engines.map(({name, metrics}) =>
            element("td", {class: "number"}, isTruth(name) ? NONE : quantity(metrics.error_max, "m")))));
    }
    return table(heads, rows);
}
