// SPDX-License-Identifier: MIT
// In which language does a page speak? Its texts are English, and are the keys of a list of words in another language.

let wordsNow = {};

/// The text in the language of the page.
function say(text) {
    return wordsNow[text] ?? text;
}

/// say("step {0} of {1}", 3, 10).
function sayWith(text, ...values) {
    return say(text).replace(/\{(\d)\}/g, (_, i) => values[i]);
}

/// words: by English text; "decimal point": the mark between whole numbers and tenths.
function speak(words) {
    wordsNow = words;
}

/// A number that was written with a point.
function numberText(text) {
    return say("decimal point") === "," ? text.replace(".", ",") : text;
}
