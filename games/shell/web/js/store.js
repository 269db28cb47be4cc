// SPDX-License-Identifier: MIT
// What a page keeps for the next time: best scores, options, keys, sound. Where a browser keeps nothing, it lasts for a visit.

export class Store {
  constructor(game) {
    this.key = `plumb.${game}`;
    this.unkept = {};  // what the browser would not keep
  }

  read() {
    let kept = {};
    try {
      kept = JSON.parse(localStorage.getItem(this.key)) ?? {};
    } catch { /* not allowed, or not ours */ }
    return { ...kept, ...this.unkept };
  }
  /** Changes these entries, and leaves the others. */
  write(entries) {
    const all = { ...this.read(), ...entries };
    try {
      localStorage.setItem(this.key, JSON.stringify(all));
      this.unkept = {};
    } catch { this.unkept = all; }
  }
}

/** Two lists of best scores as one: another page of the game may have kept some since. */
export function bestOf(mine, others) {
  const all = [...mine];
  for (const score of new Set(others)) {
    const missing = others.filter(one => one === score).length - mine.filter(one => one === score).length;
    for (let i = 0; i < missing; ++i) all.push(score);
  }
  return all.sort((a, b) => b - a).slice(0, 10);
}

/** The lines "score N" and "option NAME VALUE" of a game's toKeep(). */
export function keptOf(text) {
  const scores = [], options = {};
  for (const line of text.split('\n')) {
    const [what, name, ...rest] = line.split(' ');
    if (what === 'score') scores.push(Number(name));
    if (what === 'option') options[name] = rest.join(' ');
  }
  return { scores, options };
}
