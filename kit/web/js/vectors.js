// SPDX-License-Identifier: MIT
// What is a vector that the module gives? The array [x, y], which has x and y, too.

const prototype = Object.create(Array.prototype, {
  x: { get() { return this[0]; } },
  y: { get() { return this[1]; } },
  // What is made of it, as by map, is a plain array.
  constructor: { value: Array },
  // Node shows it as [1, 2].
  [Symbol.for('nodejs.util.inspect.custom')]: {
    value(depth, options, inspect) { return inspect([...this], options); } },
});

/** An array whose prototype is set takes half the time of one that a subclass of Array makes. */
export const vectorOf = (x, y) => Object.setPrototypeOf([x, y], prototype);
