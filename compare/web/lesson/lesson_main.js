// SPDX-License-Identifier: MIT
// What happens when the page opens, and when its address changes? #lesson=stone&set=gravity.1=-1.6&lang=de

/// The page as it came, before it drew anything.
const LESSON_AS_IT_CAME = document.documentElement.outerHTML;
const LESSONS = JSON.parse(byId("lessons").textContent)
    .sort((a, b) => a.slides[0] - b.slides[0] || a.slides.at(-1) - b.slides.at(-1) || a.name.localeCompare(b.name));
const SLIDES = JSON.parse(byId("slide-list").textContent);
let languageNow = "en";

function readLessonAddress() {
    const fields = new URLSearchParams(location.hash.slice(1));
    return {name: fields.get("lesson"), packed: fields.get("json"), language: fields.get("lang"),
        count: Number(fields.get("count")) || null,
        changed: fields.getAll("set").map((text) => text.split(/=(.*)/s).slice(0, 2))};
}

function writeLessonAddress({name, packed, changed = [], count = null}) {
    const fields = name || packed ? [packed ? `json=${packed}` : `lesson=${encodeURIComponent(name)}`] : [];
    for (const [path, value] of changed) fields.push(`set=${encodeURIComponent(`${path}=${value}`)}`);
    if (count) fields.push(`count=${count}`);
    fields.push(`lang=${languageNow}`);
    history.replaceState(null, "", `#${fields.join("&")}`);
}

/// In the page itself, packed; or beside it, or beside the live page.
async function lessonModule() {
    const inside = byId("module").textContent;
    if (inside) return through(new DecompressionStream("deflate-raw"), bytesOf(inside));
    const response = await fetch("../live/live.wasm");
    if (!response.ok) throw new Error(`live.wasm: ${response.status}`);
    return new Uint8Array(await response.arrayBuffer());
}

/// One file of this lesson that needs no network: the module is in it, and where it begins.
async function offlineLesson(bytes, address, name) {
    const [own, others] = [true, false].map((isOwn) =>
        JSON.stringify(LESSONS.filter((lesson) => (lesson.name === name) === isOwn)));
    // Of the words those that only other lessons say are left out.
    const isNeeded = ([text]) => own.includes(JSON.stringify(text)) || !others.includes(JSON.stringify(text));
    const words = JSON.stringify(Object.fromEntries(Object.entries(JSON.parse(byId("words").textContent))
        .map(([language, said]) => [language, Object.fromEntries(Object.entries(said).filter(isNeeded))])));
    const asScript = (json) => json.replaceAll("</", "<\\/");
    const packed = await through(new CompressionStream("deflate-raw"), bytes);
    return `<!DOCTYPE html>\n${LESSON_AS_IT_CAME
        .replace(/<nav class="site-nav"[^]*?<\/nav>/, "")
        .replace(/(<script type="application\/json" id="lessons">)[^]*?(?=<\/script>)/, (_, tag) => tag + asScript(own))
        .replace(/(<script type="application\/json" id="words">)[^]*?(?=<\/script>)/, (_, tag) => tag + asScript(words))
        .replace(/(<script type="text\/plain" id="module">)[^<]*/, (_, tag) => tag + base64Of(packed))
        .replace(/(<script type="text\/plain" id="opened">)[^<]*/, (_, tag) => tag + address.replaceAll("<", "%3C"))}`;
}

function showLessonMenu(live, fault = "") {
    live.close();
    document.title = say("Plumb lessons");
    document.body.dataset.view = "overview";
    byId("overview").hidden = false;
    byId("lesson").hidden = true;
    byId("file-refused").textContent = fault;
    fillLessonMenu();
}

/// The slides of the lecture, each with its lessons.
function fillLessonMenu() {
    const link = ({name, title, question}) => element("li", {},
        element("a", {href: `#lesson=${name}&lang=${languageNow}`}, say(title)),
        element("span", {class: "question"}, plainQuestion(question)));
    const rows = SLIDES.map(({slide, subject}) => element("tr", {}, element("td", {class: "slide-numbers"}, String(slide)),
        rowHead(say(subject)), element("td", {}, element("ul", {class: "lesson-links"},
            ...LESSONS.filter(({slides}) => slides.includes(slide)).map(link)))));
    const heads = ["Slide", "Subject", "Lessons"].map((head) => columnHead(say(head)));
    byId("menu").replaceChildren(...table(heads, rows));
}

/// Before a run its numbers are not known.
function plainQuestion(question) {
    return say(question).replace(/\{[^{}]*\}/g, "…");
}

/// Shows a lesson; where it cannot be shown, the menu, and why. file: its name in messages.
function openLesson(live, json, wanted, file = "lesson") {
    document.body.dataset.view = "lesson";
    byId("overview").hidden = true;
    byId("lesson").hidden = false;
    try {
        live.packed = wanted.packed ?? null;
        live.open(json, wanted);
        live.settled();
        byId("all-lessons").href = `#lang=${languageNow}`;
        scrollTo(0, 0);
    } catch (error) {
        showLessonMenu(live, error.message.replace(/^lesson:/, () => `${file}:`));
    }
}

async function openLessonAddress(live) {
    const wanted = readLessonAddress();
    languageNow = languageOf(wanted.language ?? languageNow);
    sayPage(languageNow);
    if (wanted.packed) {
        const json = await unpackedJson(wanted.packed).catch(() => null);
        if (!json) return showLessonMenu(live, say("The address holds no whole lesson: perhaps the link was cut."));
        return openLesson(live, json, wanted);
    }
    const found = LESSONS.find(({name}) => name === wanted.name);
    if (!found) return showLessonMenu(live, wanted.name ? sayWith("There is no lesson {0}.", wanted.name) : "");
    openLesson(live, JSON.stringify(found), wanted);
}

async function takeLesson(live, file) {
    const json = await file.text();
    openLesson(live, json, {packed: await packedJson(json)}, file.name);
}

function bindLessonGifts(live, bytes) {
    const click = (id, act) => byId(id).addEventListener("click", act);
    click("print", () => printWorksheet(live));
    click("give-page", async () => {
        live.settled();
        download(`${live.lesson.name}.html`, await offlineLesson(bytes, location.hash, live.lesson.name), "text/html");
    });
    click("give-link", async ({target}) => {
        live.settled();
        await navigator.clipboard?.writeText(location.href).catch(() => {});
        target.textContent = say("Link copied");
        setTimeout(() => { target.textContent = say("Copy a link"); }, 2000);
    });
    // One file of a lesson has no live page beside it.
    byId("on-live").hidden = byId("module").textContent !== "";
    click("on-live", async (event) => {
        event.preventDefault();
        location.href = `../live/#json=${await packedJson(live.comparison.exported())}`;
    });
    click("projector", async ({target}) => {
        const isOn = document.documentElement.classList.toggle("projector");
        target.setAttribute("aria-pressed", String(isOn));
        if (isOn) await document.documentElement.requestFullscreen?.().catch(() => {});
        else if (document.fullscreenElement) await document.exitFullscreen();
        live.restyle();
    });
    byId("take-lesson").addEventListener("change", async ({target}) => {
        const [file] = target.files;
        if (file) await takeLesson(live, file);
        target.value = "";
    });
}

async function startLessons() {
    const bytes = await lessonModule();
    const comparison = await Comparison.load(bytes);
    const list = comparison.list();
    takeEngines([...list.engines, ...list.onDemand]);
    const live = new LessonPage(comparison, list);
    bindLanguages((language) => {
        languageNow = language;
        sayPage(language);
        if (live.scene) openLesson(live, live.json, {packed: live.packed, changed: [...live.changed], count: live.count});
        else {
            writeLessonAddress({});
            showLessonMenu(live);
        }
    });
    bindLessonGifts(live, bytes);
    bindOwnData(live);
    const opened = byId("opened").textContent;
    if (opened && !location.hash) history.replaceState(null, "", opened);
    await openLessonAddress(live);
    addEventListener("hashchange", () => openLessonAddress(live));
    globalThis.lessonPage = live;
    document.body.dataset.ready = "yes";
}

startLessons().catch((error) => {
    byId("loading").textContent = `The page could not start: ${error.message}`;
});
