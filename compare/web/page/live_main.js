// SPDX-License-Identifier: MIT
// What happens when the page opens, and when its address changes?

/// The module is in the page itself, or lies beside it.
async function moduleBytes() {
    const inside = byId("module").textContent;
    if (inside) return bytesOf(inside);
    const response = await fetch("live.wasm");
    if (!response.ok) throw new Error(`live.wasm: ${response.status}`);
    return new Uint8Array(await response.arrayBuffer());
}

function showView(name) {
    document.body.dataset.view = name;
    byId("overview").hidden = name !== "overview";
    byId("scene").hidden = name !== "scene";
}

/// For the small pictures: a short run of the scene, copied out of the module.
function pictured(comparison, scene) {
    const runs = new Runs(comparison);
    runs.open(scene.name);
    runs.start([]);
    runs.advance(60);
    Object.assign(scene, runs.scene);
    scene.ticks = scene.ticks.slice(0, runs.tick + 1);
    scene.times = scene.times.slice(0, runs.tick + 1);
    for (const engine of scene.engines) delete engine.pushesAt;
}

/// Called by the pictures: see data.js.
let readyScene = async () => {};

function markInList(name, scenes) {
    for (const link of byId("scene-list-items").querySelectorAll("a")) {
        link.removeAttribute("aria-current");
        if (link.getAttribute("href") !== sceneAddress({name})) continue;
        link.setAttribute("aria-current", "page");
        link.scrollIntoView({block: "nearest"});
    }
    const at = scenes.findIndex((scene) => scene.name === name);
    byId("previous-scene").href = sceneAddress(scenes[(at + scenes.length - 1) % scenes.length]);
    byId("next-scene").href = sceneAddress(scenes[(at + 1) % scenes.length]);
}

function showMenu(live, fault = "") {
    live.close();
    document.title = "Plumb live";
    byId("file-refused").textContent = fault;
    showView("overview");
}

/// Shows a scene; where it cannot be shown, the menu, and why. True if it is shown.
function openScene(live, wanted) {
    showView("scene");
    try {
        live.open(wanted);
    } catch (error) {
        showMenu(live, error.message);
        return false;
    }
    document.title = `${titleText(live.runs.data)} – Plumb live`;
    return true;
}

async function openAddress(live, list) {
    const wanted = readAddress();
    if (!wanted.name && !wanted.packed) return showMenu(live);
    const json = wanted.packed && await unpackedJson(wanted.packed).catch(() => null);
    if (wanted.packed && !json) return showMenu(live, "The address holds no whole scene: perhaps the link was cut");
    if (!openScene(live, {...wanted, json})) return;
    markInList(wanted.name, list.scenes);
    scrollTo(0, 0);
    const speed = SPEEDS.some(([choice]) => choice === wanted.speed) ? wanted.speed : 1;
    live.player.setSpeed(speed);
    live.page.showSpeed(speed);
    live.player.seek(wanted.time);
    if (wanted.play) live.player.play();
}

async function openLive() {
    const bytes = await moduleBytes();
    const comparison = await Comparison.load(bytes);
    const list = comparison.list();
    takeEngines([...list.engines, KEPT_LOOK]);
    // A picture is drawn only while no scene is open: the module has one scene at a time.
    readyScene = async (scene) => {
        if (!scene.running && document.body.dataset.view === "overview") pictured(comparison, scene);
    };
    const live = new LivePage(comparison, list);
    live.bytes = bytes;
    const opened = byId("opened").textContent;
    if (opened && !location.hash) history.replaceState(null, "", opened);
    await openAddress(live, list);
    fillMenu(list, new Pictures());
    if (live.scene) markInList(live.name, list.scenes);
    addEventListener("hashchange", () => openAddress(live, list));
    globalThis.livePage = live;
    document.body.dataset.ready = "yes";
}

openLive().catch((error) => {
    byId("loading").textContent = `The page could not start: ${error.message}`;
});
