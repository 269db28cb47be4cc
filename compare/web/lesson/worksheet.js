// SPDX-License-Identifier: MIT
// What does a class get on paper? A page with the questions and room to answer, and a page with the answers.

function lines(count) {
    return Array.from({length: count}, () => element("div", {class: "write-line"}));
}

/// The start, as it looks before the prediction.
function worksheetPicture(live) {
    const {view} = live, before = {...view};
    for (const drawn of DRAWN) view[drawn] = false;
    Object.assign(view, {aim: wholeView(), box: roomyBox(sceneBox(live.scene))});
    live.player.seek(0);
    const src = byId("stage").toDataURL("image/png");
    Object.assign(view, before);
    live.draw();
    return element("img", {src, alt: ""});
}

/// Axes to draw on, or with the true curve.
function curveOnPaper(live, isTold) {
    const {predict} = live.lesson;
    const {pad} = curveWidget(element("div"), predict, live.scene.times, live.padRange());
    if (isTold) pad.showTruth(live.scene.times, live.curveOf(predict.curve.value));
    return pad.figure;
}

function predictionOnPaper(live) {
    const {number, choice, curve} = live.lesson.predict;
    if (number) return [element("p", {}, `${say("Your prediction")}: ________________ ${SHOWN_UNITS[number.unit] ?? number.unit}`)];
    if (choice) return choice.options.map((text) => element("p", {class: "tick-box"}, say(text)));
    return [element("p", {}, sayWith("Draw {0} over the time:", say(curve.label))), curveOnPaper(live, false)];
}

/// The values as they are set now.
function givenOnPaper(live) {
    const rows = live.panel.rows.map(({control, number}) =>
        `${control.label}: ${numberText(number.value)} ${control.unit}`.trim());
    return rows.length > 0 ? element("p", {class: "given"}, `${say("Given")}: ${rows.join("; ")}`) : null;
}

function answersOnPaper(live) {
    const {lesson, values, scene} = live, {predict} = lesson;
    const truth = predict.number ? valueText(values.truth(scene, predict.number.value))
        : predict.choice ? say(predict.choice.options[predict.choice.right - 1]) : curveOnPaper(live, true);
    return element("section", {class: "sheet-page"}, element("h1", {}, `${say(lesson.title)}: ${say("answers")}`),
        element("h2", {}, values.filled(scene, say(lesson.question))), element("div", {class: "truth"}, truth),
        element("p", {}, values.filled(scene, say(lesson.because))),
        ...lesson.formula.map((line) => formulaElement(values.worked(scene, line))),
        element("ol", {}, ...lesson.questions.map(({ask, answer}) =>
            element("li", {}, element("p", {}, values.filled(scene, say(ask))), element("p", {}, values.filled(scene, say(answer)))))));
}

function fillWorksheet(live) {
    const {lesson} = live;
    const told = (text) => live.values.filled(live.scene, say(text));
    const rooms = lesson.predict.curve ? 2 : 3;
    const asked = lesson.questions.map(({ask}) => element("li", {}, element("p", {}, told(ask)), ...lines(rooms)));
    byId("worksheet").replaceChildren(
        element("section", {class: "sheet-page"},
            element("p", {class: "name-line"}, `${say("Name")} ______________________   ${say("Date")} ____________`),
            element("h1", {}, say(lesson.title)), element("p", {}, told(lesson.about)), worksheetPicture(live),
            givenOnPaper(live), element("h2", {}, told(lesson.question)), ...predictionOnPaper(live),
            element("p", {}, `${say("What the run shows")}: ________________`), element("ol", {}, ...asked)),
        answersOnPaper(live));
}

function printWorksheet(live) {
    live.finish();
    fillWorksheet(live);
    byId("worksheet").hidden = false;
    document.body.classList.add("printing");
    const done = () => {
        document.body.classList.remove("printing");
        byId("worksheet").hidden = true;
    };
    addEventListener("afterprint", done, {once: true});
    print();
}
