// SPDX-License-Identifier: MIT
// What can a person take away? A link, the scene, the numbers, a picture, and the page itself as one file.

function give(fileName, content, type) {
    const link = element("a", {download: fileName, href: URL.createObjectURL(new Blob([content], {type}))});
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function base64Of(bytes) {
    let text = "";
    for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return btoa(text);
}

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
    bind("give-json", () => give(`${name()}.json`, `${live.comparison.exported()}\n`, "application/json"));
    bind("give-png", () => byId("stage").toBlob((blob) => give(`${name()}.png`, blob, "image/png")));
    bind("give-page", async () => {
        await live.settled();
        give(`${name()}.html`, offlinePage(live.bytes, location.hash), "text/html");
    });
    bind("give-link", async () => {
        await live.settled();
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

/// A scene that a person brings; what is wrong with it is said.
function openJson(live, json) {
    try {
        live.open({name: null, json});
        byId("refused").textContent = byId("file-refused").textContent = "";
        showView("scene");
        document.title = `${titleText(live.runs.data)} – Plumb live`;
        live.settled();
    } catch (error) {
        byId("refused").textContent = byId("file-refused").textContent = error.message;
    }
}
