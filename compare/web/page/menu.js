// SPDX-License-Identifier: MIT
// Which scenes are there? Cards with pictures, and the list beside a scene.

function sceneAddress({name}) {
    return `#scene=${encodeURIComponent(name)}`;
}

/// Scenes by the group under which they are listed, in the order in which groups first appear.
function groupsOf(scenes) {
    const groups = new Map();
    for (const scene of scenes) {
        const group = scene.bench ? "Measured for speed" : scene.group || "Others";
        if (!groups.has(group)) groups.set(group, []);
        groups.get(group).push(scene);
    }
    return groups;
}

function card(scene, pictures) {
    const canvas = element("canvas", {class: "picture", "aria-hidden": "true"});
    if (!scene.bench) pictures.add(canvas, scene);
    return element("li", {}, element("a", {href: sceneAddress(scene)}, scene.bench ? null : canvas,
        element("strong", {}, titleText(scene)), element("span", {class: "question"}, scene.question)));
}

function fillMenu({scenes}, pictures) {
    const rows = [];
    for (const [group, members] of groupsOf(scenes)) {
        const list = element("ul", {class: "cards"}, ...members.map((scene) => {
            const item = card(scene, pictures);
            rows.push({item, texts: [titleText(scene), scene.name, scene.question, group].join(" ").toLowerCase()});
            return item;
        }));
        byId("menu").append(element("section", {}, element("h2", {}, group), list));
        byId("scene-list-items").append(element("li", {class: "group"}, group), ...members.map((scene) =>
            element("li", {}, element("a", {href: sceneAddress(scene), title: scene.question},
                element("span", {}), element("span", {class: "scene-name"}, titleText(scene))))));
    }
    byId("find").addEventListener("input", ({target}) => {
        const words = target.value.toLowerCase().split(/\s+/).filter(Boolean);
        for (const {item, texts} of rows) item.hidden = !words.every((word) => texts.includes(word));
        for (const section of byId("menu").children) section.hidden = !section.querySelector("li:not([hidden])");
        byId("nothing-found").hidden = rows.some(({item}) => !item.hidden);
    });
}
