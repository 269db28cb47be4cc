// SPDX-License-Identifier: MIT
// Which state of the page does its address describe? #scene=free_fall&t=1.2&play=1&speed=1, or #lab=frame_rate

function readAddress() {
    const fields = new URLSearchParams(location.hash.slice(1));
    const number = (name, otherwise) => {
        const value = Number.parseFloat(fields.get(name));
        return Number.isFinite(value) ? value : otherwise;
    };
    const play = fields.get("play") === "1";
    return {scene: fields.get("scene"), lab: fields.get("lab"), time: number("t", 0), play, speed: number("speed", 1)};
}

function writeAddress({scene, time, play, speed}) {
    const fields = [`scene=${encodeURIComponent(scene)}`, `t=${Number(time.toFixed(4))}`];
    if (play) fields.push("play=1");
    if (speed !== 1) fields.push(`speed=${speed}`);
    history.replaceState(null, "", `#${fields.join("&")}`);
}
