// SPDX-License-Identifier: MIT
// How is an element of the page made?

function byId(id) {
    return document.getElementById(id);
}

/// element("td", {class: "number", onclick: f}, "text", otherElement); null children are left out.
function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (value === null || value === undefined || value === false) continue;
        if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
        else if (value === true) made.setAttribute(name, "");
        else made.setAttribute(name, value);
    }
    made.append(...children.filter((child) => child !== null && child !== undefined));
    return made;
}

function columnHead(content, isNumber = false) {
    return element("th", {scope: "col", class: isNumber ? "number" : null}, content);
}

function rowHead(...content) {
    return element("th", {scope: "row"}, ...content);
}

function table(heads, rows) {
    return [element("thead", {}, element("tr", {}, ...heads)), element("tbody", {}, ...rows)];
}

/// A group of choices, of which one is chosen: choices are [value, label]. Returns a function that marks another as
/// chosen.
function fillChoice(fieldset, name, choices, chosen, choose) {
    for (const [value, label] of choices) {
        const input = element("input", {type: "radio", name, value, onchange: () => choose(value)});
        input.checked = value === chosen;
        fieldset.append(element("label", {}, input, element("span", {}, label)));
    }
    return (value) => {
        for (const input of fieldset.querySelectorAll("input")) input.checked = Number(input.value) === value;
    };
}

function download(fileName, content, type = "text/csv") {
    const link = element("a", {download: fileName, href: URL.createObjectURL(new Blob([content], {type}))});
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
