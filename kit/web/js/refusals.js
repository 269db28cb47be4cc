// SPDX-License-Identifier: MIT
// How is what is wrong told? By the path to the member, the value, and what was wanted.

/** How many letters have to be changed, left out or put in to make one word of another? */
function editDistance(a, b) {
  let row = Array.from({ length: b.length + 1 }, (_, i) => i);
  for (let i = 1; i <= a.length; ++i) {
    const next = [i];
    for (let j = 1; j <= b.length; ++j)
      next.push(Math.min(next[j - 1] + 1, row[j] + 1, row[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1)));
    row = next;
  }
  return row[b.length];
}

export function nearestTo(word, known) {
  const ranked = [...known].sort((a, b) => editDistance(word, a) - editDistance(word, b));
  return ranked.length && editDistance(word, ranked[0]) <= Math.max(2, Math.ceil(word.length / 2)) ? ranked[0] : undefined;
}

/** An error that learns on its way out of which member it tells. */
export class Refusal extends Error {
  constructor(what) {
    super(what);
    this.name = 'Error';
    this.what = what;
    this.path = '';
  }
  within(name) {
    this.path = name + (this.path && !this.path.startsWith('[') ? '.' : '') + this.path;
    this.message = `${this.path}: ${this.what}`;
    return this;
  }
}
export const within = (error, name) => (error instanceof Refusal ? error.within(name) : error);
/** As the kit tells it: "World.step: dt: ..." */
export const told = (error, title, parameter) => {
  if (error instanceof Refusal) error.within(parameter).message = `${title}: ${error.message}`;
  return error;
};

export const show = value => {
  if (typeof value === 'string') return JSON.stringify(value);
  if (typeof value === 'function') return 'a function';
  if (Array.isArray(value)) return `[${value.map(show).join(', ')}]`;
  if (/^(Body|Shape|Joint|Field)Id$/.test(value?.kind)) return `a ${value.kind}`;
  return value !== null && typeof value === 'object' ? 'an object' : String(value);
};
