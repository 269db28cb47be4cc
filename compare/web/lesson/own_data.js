// SPDX-License-Identifier: MIT
// How does a person bring data, and take them away? A table of a throw, dropped onto the page; and each engine's run.

async function bringTrack(live, file) {
    byId("csv-refused").textContent = "";
    try {
        live.comparison.bring(await file.text());
        live.rebuild();
    } catch (error) {
        byId("csv-refused").textContent = error.message.replace(/^file:/, `${file.name}:`);
    }
}

function bindOwnData(live) {
    byId("take-csv").addEventListener("change", async ({target}) => {
        const [file] = target.files;
        if (file) await bringTrack(live, file);
        target.value = "";
    });
    const lesson = byId("lesson");
    lesson.addEventListener("dragover", (event) => event.preventDefault());
    lesson.addEventListener("drop", (event) => {
        event.preventDefault();
        const [file] = event.dataTransfer.files;
        if (file) bringTrack(live, file);
    });
}

/// A file of each engine's run, once it is known.
function showOwnFiles({scene, lesson, isMeasured}) {
    const isKnown = isMeasured && document.body.dataset.known === "yes";
    byId("files").replaceChildren(...(isKnown ? scene.running.filter(({run}) => run !== undefined) : []).map((engine) =>
        element("button", {type: "button", onclick: () => download(`${lesson.name}.${engine.name}.csv`, runCsv(scene, engine))},
            engineName(engine.name), " (CSV)")));
}
