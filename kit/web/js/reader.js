// SPDX-License-Identifier: MIT
// How do numbers in the module's memory become a value? row.h writes them.
import { cached, idClasses, Ids } from './ids.js';

// A vector is the array [x, y], which has x and y, too.
const vectorPrototype = Object.create(Array.prototype, {
  x: { get() { return this[0]; } },
  y: { get() { return this[1]; } },
  // What is made of it, as by map, is a plain array.
  constructor: { value: Array },
  // Node shows it as [1, 2].
  [Symbol.for('nodejs.util.inspect.custom')]: {
    value(depth, options, inspect) { return inspect([...this], options); } },
});

/** An array whose prototype is set takes half the time of one that a subclass of Array makes. */
const vectorOf = (x, y) => Object.setPrototypeOf([x, y], vectorPrototype);

/** 64 bits as a BigInt. */
const bitsOf = (low, high) => BigInt(low) | (BigInt(high) << 32n);
/** 64 bits as a number where it has all of them, else as a BigInt. */
const tagOf = (low, high) => (high < 2 ** 21 ? high * 2 ** 32 + low : bitsOf(low, high));

/**
 * For each kind of value a function that reads it from where the reader was put.
 * @param schema the structs and enumerations
 * @param stateOf makes an object of its name and its words
 * @param ruleOf the contact rule of a number, or null
 */
export function rowReader(schema, stateOf, ruleOf) {
  let numbers = null, at = 0, ids = new Ids();
  const read = () => numbers[at++];

  const readerOf = cached(makeReader);

  function makeReader(kind) {
    if (typeof kind === 'string') return plainReaders[kind];
    const [form] = Object.keys(kind);
    const of = kind[form];
    switch (form) {
      case 'integer': return read;
      case 'oneOf': return () => schema.enumerations[of][read()];
      case 'maybe': {
        const one = readerOf(of);
        return () => (read() ? one() : null);
      }
      case 'listOf': {
        const one = readerOf(of);
        return () => {
          const list = new Array(read());
          for (let i = 0; i < list.length; ++i) list[i] = one();
          return list;
        };
      }
      case 'mapTo': {
        const one = readerOf(of);
        return () => {
          const map = {};
          for (let left = read(); left > 0; --left) map[String.fromCharCode(read())] = one();
          return map;
        };
      }
      case 'either': {
        const tags = Object.keys(of), ones = tags.map(tag => readerOf(of[tag]));
        return () => {
          const index = read();
          return { [tags[index]]: ones[index]() };
        };
      }
      case 'state': return () => stateOf(of, Array.from({ length: kind.words }, read));
      case 'struct': return structReader(of);
    }
  }

  const plainReaders = {
    nothing() {},
    number: read,
    bool: () => read() !== 0,
    bits: () => bitsOf(read(), read()),
    tag: () => tagOf(read(), read()),
    vec: () => vectorOf(read(), read()),
    text: () => String.fromCharCode(...Array.from({ length: read() }, read)),
    rule: () => ruleOf(read()),
  };

  function structReader(name) {
    if (name === 'ShapeId') {
      const body = readerOf({ struct: 'BodyId' });
      return () => ids.shapeOf(body(), read());
    }
    if (idClasses[name]) return () => ids.of(idClasses[name], read(), read(), read());
    let members;
    return () => {
      members ??= schema.types[name].map(({ name, kind }) => ({ name, read: readerOf(kind) }));
      const object = {};
      for (let i = 0; i < members.length; ++i) object[members[i].name] = members[i].read();
      return object;
    };
  }

  return {
    readerOf,
    read,
    /** Puts the reader to a place in the memory. */
    begin(memory, place) {
      numbers = memory;
      at = place;
    },
    /** Whose ids are read from now on? */
    useIds(known) { ids = known; },
    /** The next numbers, into an array. */
    copyTo(array, count) { for (let i = 0; i < count; ++i) array[i] = numbers[at + i]; },
  };
}
