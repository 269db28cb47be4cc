// SPDX-License-Identifier: MIT
// How does a person play, pause, step and move through time?

const SPEEDS = [[0.125, "⅛×"], [0.25, "¼×"], [0.5, "½×"], [1, "1×"], [2, "2×"], [4, "4×"]];
const MAGNIFICATIONS = [[1, "×1"], [10, "×10"], [100, "×100"], [1000, "×1000"]];

/// True for a control that uses the key itself.
function takesSpace(target) {
    if (target.tagName === "INPUT") return target.type !== "range";
    return ["SELECT", "BUTTON", "A"].includes(target.tagName);
}
/// True for a control that uses arrows, digits and signs itself; the one of time leaves them to the page.
function takesOthers(target) {
    if (target.tagName === "INPUT") return target.type !== "checkbox" && target.id !== "scrub";
    return target.tagName === "SELECT";
}

/// Space plays and pauses, the arrows step, Home and End go to the ends, +, - and 0 zoom. A focused control keeps its
/// own keys.
function bindKeys(player, aim, isOpen) {
    document.addEventListener("keydown", (event) => {
        if (!isOpen() || event.ctrlKey || event.altKey || event.metaKey) return;
        const actions = {
            " ": () => player.toggle(),
            ArrowLeft: () => player.step(-1),
            ArrowRight: () => player.step(1),
            Home: () => player.seek(0),
            End: () => player.seek(player.end),
            "+": () => aim.zoom(1.5),
            "-": () => aim.zoom(1 / 1.5),
            0: () => aim.fit(),
        };
        const action = actions[event.key];
        const taken = event.key === " " ? takesSpace(event.target) : takesOthers(event.target);
        if (!action || taken) return;
        event.preventDefault();
        action();
    });
}

/// On a small screen the controls stay at the edge while the page scrolls: a person who plays must see the bodies move.
function bringStageIntoView() {
    const stage = byId("stage").getBoundingClientRect();
    const below = byId("transport").getBoundingClientRect().height;
    const isSeen = stage.top >= -1 && stage.bottom <= innerHeight - below + 1;
    if (isSeen) return;
    // Includes the engines' keys above the stage, if there is room for them.
    const column = byId("stage-column");
    const withKeys = stage.bottom - column.getBoundingClientRect().top + below;
    (withKeys <= innerHeight ? column : byId("stage")).scrollIntoView({block: "start"});
}

function bindTransport(player, settled) {
    byId("play").addEventListener("click", () => {
        player.toggle();
        if (player.playing) bringStageIntoView();
        settled();
    });
    byId("step-back").addEventListener("click", () => { player.step(-1); settled(); });
    byId("step-on").addEventListener("click", () => { player.step(1); settled(); });
    byId("scrub").addEventListener("input", (event) => player.seekFrame(Number(event.target.value)));
    byId("scrub").addEventListener("change", settled);
    byId("repeat").addEventListener("change", (event) => { player.repeat = event.target.checked; });
    return fillChoice(byId("speeds"), "speed", SPEEDS, 1, (speed) => { player.setSpeed(speed); settled(); });
}

function showTransport(player, scene) {
    const frame = player.frame;
    const time = scene.times[frame];
    byId("clock").textContent = timeText(time);
    byId("tick").textContent = sayWith("step {0} of {1}", scene.ticks[frame], scene.steps);
    const {from, until} = player.watch;
    byId("stopwatch").textContent = from === undefined ? say("Stopwatch") : `Δt ${timeText((until ?? time) - from)}`;
    byId("stopwatch").setAttribute("aria-pressed", String(from !== undefined && until === undefined));
    const scrub = byId("scrub");
    scrub.value = frame;
    scrub.style.setProperty("--done", `${(100 * frame) / Math.max(1, scene.ticks.length - 1)}%`);
    scrub.setAttribute("aria-valuetext", timeText(time));
    const play = byId("play");
    play.textContent = player.playing ? `❚❚ ${say("Pause")}` : `▶ ${say("Play")}`;
    play.setAttribute("aria-pressed", String(player.playing));
}
