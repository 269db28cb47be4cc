// SPDX-License-Identifier: MIT
// Which scenes and labs match a search?

/// Each word must be in one of the texts.
function matches(words, texts) {
    const all = texts.join(" ").toLowerCase();
    return words.every((word) => all.includes(word));
}

/// rows: {row, texts}. The body of a group is hidden if all of its rows are.
function showFound(rows, query) {
    const words = query.toLowerCase().split(/\s+/).filter((word) => word !== "");
    let found = 0;
    for (const {row, texts} of rows) {
        row.hidden = !matches(words, texts);
        if (!row.hidden) ++found;
    }
    const bodies = new Set(rows.map(({row}) => row.parentElement));
    for (const body of bodies) body.hidden = rows.every(({row}) => row.parentElement !== body || row.hidden);
    for (const table of new Set([...bodies].map((body) => body.parentElement))) {
        table.hidden = [...table.tBodies].every((body) => body.hidden);
    }
    byId("nothing-found").hidden = found > 0 || rows.length === 0;
    byId("nothing-found").textContent = `Nothing here is about “${query.trim()}”.`;
}

function bindSearch(rows) {
    const find = byId("find");
    find.addEventListener("input", () => showFound(rows, find.value));
    find.hidden = rows.length === 0;
}
