// SPDX-License-Identifier: MIT
// What can a person take away? A link, the scene, the numbers, a picture, and the page itself as one file.

/// One file that needs no network: the module is in it, and the address of the scene as it is now, where it begins.
function offlinePage(bytes, address) {
    const safe = address.replaceAll("<", "%3C");
    return `<!DOCTYPE html>\n${PAGE_AS_IT_CAME
        .replace(/<nav class="site-nav"[^]*?<\/nav>/, "")
        .replace(/(<script type="text\/plain" id="module">)[^<]*/, (_, tag) => tag + base64Of(bytes))
        .replace(/(<script type="text\/plain" id="opened">)[^<]*/, (_, tag) => tag + safe)}`;
}

function bindGifts(live) {
    const name = () => live.runs.data.name;
    const bind = (id, act) => byId(id).addEventListener("click", act);
    bind("give-json", () => download(`${name()}.json`, `${live.comparison.exported()}\n`, "application/json"));
    bind("give-png", () => byId("stage").toBlob((blob) => download(`${name()}.png`, blob, "image/png")));
    bind("give-page", () => {
        live.settled();
        download(`${name()}.html`, offlinePage(live.bytes, location.hash), "text/html");
    });
    bind("give-link", async () => {
        live.settled();
        await navigator.clipboard?.writeText(location.href).catch(() => {});
        byId("give-link").textContent = "Link copied";
        setTimeout(() => { byId("give-link").textContent = "Copy a link"; }, 2000);
    });
    byId("take-json").addEventListener("change", async ({target}) => {
        const [file] = target.files;
        if (file) openJson(live, await file.text());
        target.value = "";
    });
}

/// A scene that a person brings.
async function openJson(live, json) {
    if (openScene(live, {name: null, json, packed: await packedJson(json)})) live.settled();
}
