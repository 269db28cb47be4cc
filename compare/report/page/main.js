// SPDX-License-Identifier: MIT
// What happens when the page opens, and when its address changes?

const report = readReport();
takeEngines(report.engines);
const scenePage = new ScenePage(() => {
    const {player: {time, playing: play, speed}, view: {scene}} = scenePage;
    if (scene) writeAddress({scene: scene.name, time, play, speed});
});

const labPage = new LabPage();

function showView(name) {
    document.body.dataset.view = name;
    byId("overview").hidden = name !== "overview";
    byId("scene").hidden = name !== "scene";
    byId("lab").hidden = name !== "lab";
}

/// Marks the open page in the list at the side, and sets the arrows to its neighbours in the list.
function markInList(address, list, [before, after]) {
    for (const link of byId("scene-list").querySelectorAll("ol a")) {
        const here = link.getAttribute("href") === address;
        if (!here) {
            link.removeAttribute("aria-current");
            continue;
        }
        link.setAttribute("aria-current", "page");
        link.scrollIntoView({block: "nearest"});
    }
    const at = list.indexOf(address);
    byId(before).href = list[(at + list.length - 1) % list.length];
    byId(after).href = list[(at + 1) % list.length];
}

function openLab(lab) {
    scenePage.close();
    showView("lab");
    if (labPage.lab !== lab) {
        labPage.open(lab);
        scrollTo(0, 0);
    }
    markInList(labAddress(lab), report.labs.map(labAddress), ["before-lab", "after-lab"]);
}

/// The old view stays until a scene's numbers are unpacked. If another scene was asked for meanwhile, that one is
/// shown.
async function openAddress() {
    const wanted = readAddress();
    const scene = report.scenes.find(({name}) => name === wanted.scene);
    const lab = report.labs.find(({name}) => name === wanted.lab);
    const title = scene ?? lab;
    document.title = title ? `${titleText(title)} – Plumb compared` : "Plumb compared";
    if (lab && !scene) {
        openLab(lab);
        return;
    }
    labPage.close();
    if (!scene) {
        scenePage.close();
        showView("overview");
        return;
    }
    await readyScene(scene);
    if (readAddress().scene !== scene.name) return;
    showView("scene");
    if (scenePage.view.scene !== scene) {
        scenePage.open(scene);
        scrollTo(0, 0);
    }
    markInList(sceneAddress(scene), report.scenes.map(sceneAddress), ["previous-scene", "next-scene"]);
    const speed = SPEEDS.some(([choice]) => choice === wanted.speed) ? wanted.speed : 1;
    scenePage.player.setSpeed(speed);
    scenePage.showSpeed(speed);
    scenePage.player.seek(wanted.time);
    if (wanted.play) {
        scenePage.player.play();
        bringStageIntoView();
    } else scenePage.player.pause();
}

fillOverview(report);
fillSceneList(report);
addEventListener("hashchange", openAddress);
openAddress();
