// SPDX-License-Identifier: MIT
// Which state of the page does its address describe? #scene=projectile&set=gravity.1=-1.6&t=1.2&play=1&speed=0.5; a scene
// that a person brought is in it as packed JSON.

function readAddress() {
    const fields = new URLSearchParams(location.hash.slice(1));
    const number = (name, otherwise) => {
        const value = Number.parseFloat(fields.get(name));
        return Number.isFinite(value) ? value : otherwise;
    };
    const changed = fields.getAll("set").map((text) => text.split(/=(.*)/s).slice(0, 2));
    return {name: fields.get("scene"), packed: fields.get("json"), changed, time: number("t", 0),
        play: fields.get("play") === "1", speed: number("speed", 1)};
}

async function packedJson(json) {
    const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(json));
    return base64Of(bytes).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

async function unpackedJson(packed) {
    const bytes = bytesOf(packed.replaceAll("-", "+").replaceAll("_", "/"));
    return new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes));
}

function writeAddress({name, packed, changed, time, play, speed}) {
    const fields = [packed ? `json=${packed}` : `scene=${encodeURIComponent(name)}`];
    for (const [path, value] of changed) fields.push(`set=${encodeURIComponent(`${path}=${value}`)}`);
    if (time > 0) fields.push(`t=${Number(time.toFixed(4))}`);
    if (play) fields.push("play=1");
    if (speed !== 1) fields.push(`speed=${speed}`);
    history.replaceState(null, "", `#${fields.join("&")}`);
}
