// SPDX-License-Identifier: MIT
// Is a text of the page cut off, beyond its edge, or over another text? Is all of the stage to be seen?

/// In what is closed, for screen readers, and at the screen's edge while the page scrolls: these may lie over others.
function isLeftOut(node) {
    if (!node.checkVisibility()) return true;
    for (let at = node; at && at !== document.body; at = at.parentElement) {
        const {position, visibility, opacity} = getComputedStyle(at);
        if (visibility === "hidden" || opacity === "0") return true;
        if (at.matches(".unseen, option, noscript, script, style")) return true;
        if (position === "sticky" || position === "fixed") return true;
    }
    return false;
}

/// What of a box is seen inside the elements around it; null where it may be scrolled to. cut: is some of it lost?
function seenPart(box, node) {
    const seen = {left: box.left, right: box.right, top: box.top, bottom: box.bottom};
    let cut = false;
    for (let at = node; at && at !== document.documentElement; at = at.parentElement) {
        const {overflowX, overflowY} = getComputedStyle(at);
        if (["auto", "scroll"].includes(overflowX) || ["auto", "scroll"].includes(overflowY)) return null;
        if (overflowX === "visible") continue;
        const edge = at.getBoundingClientRect();
        cut ||= seen.left < edge.left - 1 || seen.right > edge.right + 1 || seen.bottom > edge.bottom + 1;
    }
    cut ||= seen.left < -1 || seen.right > document.documentElement.clientWidth + 1;
    return {...seen, cut};
}

function textBoxes() {
    const boxes = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
        const node = walker.currentNode;
        const text = node.textContent.trim();
        if (text === "" || isLeftOut(node.parentElement)) continue;
        const range = document.createRange();
        range.selectNodeContents(node);
        for (const rect of range.getClientRects()) {
            if (rect.width < 1 || rect.height < 1) continue;
            const seen = seenPart(rect, node.parentElement);
            if (seen) boxes.push({...seen, text: text.slice(0, 40), node});
        }
    }
    return boxes;
}

/// Letters fill about two thirds of their line: lines may touch.
function overlap(a, b) {
    const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
    const high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
    return wide > 2 && high > 0.3 * Math.min(a.bottom - a.top, b.bottom - b.top);
}

/// Once it plays: between the screen's upper edge and the controls, which stay at its lower one.
function isStageSeenPlaying() {
    const play = document.getElementById("play");
    play.click();
    const seen = isStageSeen();
    play.click();
    return seen;
}

function isStageSeen() {
    const {top, bottom, height} = document.getElementById("stage").getBoundingClientRect();
    const controls = document.getElementById("transport").getBoundingClientRect();
    return height > 0 && top >= -1 && bottom <= controls.top + 1 && controls.bottom <= innerHeight + 1;
}

/// A sentence for each fault.
function layoutFaults() {
    const faults = new Set();
    const boxes = textBoxes().sort((a, b) => a.top - b.top);
    if (document.documentElement.scrollWidth > innerWidth + 1) faults.add("the page is wider than the screen");
    boxes.forEach((box, i) => {
        if (box.cut) faults.add(`cut off: "${box.text}"`);
        for (let k = i + 1; k < boxes.length && boxes[k].top < box.bottom; ++k) {
            const other = boxes[k];
            if (other.node !== box.node && overlap(box, other)) faults.add(`"${box.text}" over "${other.text}"`);
        }
    });
    return {texts: boxes.length, faults: [...faults]};
}
