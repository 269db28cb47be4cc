// SPDX-License-Identifier: MIT
// What happens when the page opens, and when its address changes?

const report = readReport();
const scenePage = new ScenePage(() => {
    const {player: {time, playing: play, speed}, view: {scene}} = scenePage;
    if (scene) writeAddress({scene: scene.name, time, play, speed});
});

function showView(name) {
    document.body.dataset.view = name;
    byId("overview").hidden = name !== "overview";
    byId("scene").hidden = name !== "scene";
}

function markInList(scene) {
    for (const link of byId("scene-list-items").querySelectorAll("a")) {
        const here = link.dataset.scene === scene.name;
        if (!here) {
            link.removeAttribute("aria-current");
            continue;
        }
        link.setAttribute("aria-current", "page");
        link.scrollIntoView({block: "nearest"});
    }
    const at = report.scenes.indexOf(scene);
    const around = (step) => sceneAddress(report.scenes[(at + step + report.scenes.length) % report.scenes.length]);
    byId("previous-scene").href = around(-1);
    byId("next-scene").href = around(1);
}

function openAddress() {
    const wanted = readAddress();
    const scene = report.scenes.find(({name}) => name === wanted.scene);
    document.title = scene ? `${titleText(scene.name)} – Plumb compared` : "Plumb compared";
    if (!scene) {
        scenePage.close();
        showView("overview");
        return;
    }
    showView("scene");
    if (scenePage.view.scene !== scene) {
        scenePage.open(scene);
        scrollTo(0, 0);
    }
    markInList(scene);
    const speed = SPEEDS.some(([choice]) => choice === wanted.speed) ? wanted.speed : 1;
    scenePage.player.setSpeed(speed);
    scenePage.showSpeed(speed);
    scenePage.player.seek(wanted.time);
    if (wanted.play) scenePage.player.play();
    else scenePage.player.pause();
}

fillOverview(report);
fillSceneList(report);
addEventListener("hashchange", openAddress);
openAddress();
