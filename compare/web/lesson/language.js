// SPDX-License-Identifier: MIT
// Which languages does the page have, and how do the texts that stand in its HTML change?

const LANGUAGES = {en: {"language": "English"}, ...JSON.parse(byId("words").textContent)};
const SAID_ATTRIBUTES = ["aria-label", "title"];

function languageOf(wanted) {
    if (LANGUAGES[wanted]) return wanted;
    const own = (navigator.language ?? "en").slice(0, 2);
    return LANGUAGES[own] ? own : "en";
}

/// Each element that says something keeps its English text.
function sayPage(language) {
    speak(LANGUAGES[language]);
    document.documentElement.lang = language;
    for (const each of document.querySelectorAll("[data-say]")) {
        each.dataset.say ||= each.textContent.trim();
        each.textContent = say(each.dataset.say);
    }
    for (const name of SAID_ATTRIBUTES) {
        for (const each of document.querySelectorAll(`[${name}]`)) {
            const key = `english${name}`;
            each[key] ??= each.getAttribute(name);
            each.setAttribute(name, say(each[key]));
        }
    }
    for (const choice of document.querySelectorAll(".languages")) choice.value = language;
}

function bindLanguages(change) {
    for (const choice of document.querySelectorAll(".languages")) {
        choice.replaceChildren(...Object.entries(LANGUAGES).map(([code, words]) =>
            element("option", {value: code, lang: code}, words.language)));
        choice.addEventListener("change", () => change(choice.value));
    }
}
