// SPDX-License-Identifier: MIT
// Which numbers does a run have, in each engine? What was predicted, those that the lesson names, and its own error.

function lessonNumbersTable(values, scene, {predict, numbers}) {
    const engines = scene.running.filter(({run, unsupported}) => run !== undefined && !unsupported);
    const named = [...(predict.number ? [predict.number] : []), ...numbers];
    const hasTruth = engines.some(({name}) => isTruth(name));
    const heads = [columnHead(say("Engine")), ...named.map(({label}) => columnHead(say(label), true)),
        hasTruth ? columnHead(say("farthest from the closed form"), true) : null].filter(Boolean);
    return table(heads, engines.map((engine) => element("tr", {}, rowHead(engineName(engine.name)),
        ...named.map(({value}) => element("td", {class: "number"}, valueText(values.of(engine, value)))),
        hasTruth ? element("td", {class: "number"}, isTruth(engine.name) ? NONE : quantity(engine.metrics.error_max, "m")) : null)));
}
