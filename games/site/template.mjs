// SPDX-License-Identifier: MIT
// Texts of pages: with gaps, {{name}}, that are filled, and with letters that HTML would take for its own.

/** Throws an Error when a gap has no part. */
export function filled(template, parts) {
  return template.replace(/\{\{(\w+)\}\}/g, (gap, name) => {
    if (parts[name] === undefined) throw new Error(`${gap} is not filled`);
    return parts[name];
  });
}

/** A text as it stands in HTML. */
export const escaped = text => text.replace(/[&<>"]/g, letter => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[letter]);
