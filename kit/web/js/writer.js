// SPDX-License-Identifier: MIT
// How does a value become numbers in a row? A struct is its members in their order, a list its length and its elements, an
// optional value 0, or 1 and the value. row.h reads the same.
import { cached, idClasses, idKindOf, ShapeId, View } from './ids.js';
import { hintFor } from './hints.js';
import { nearestTo, Refusal, show, within } from './refusals.js';

/**
 * A row, and for each kind of value a function that writes it there.
 * @param schema the structs and enumerations
 * @param isWorld is it a World?
 * @param numberOfRule the number of a contact rule
 */
export function rowWriter(schema, isWorld, numberOfRule) {
  const row = [];
  let length = 0;
  const write = number => void (row[length++] = number);
  const writerOf = cached(makeWriter);

  function makeWriter(kind) {
    if (typeof kind === 'string') return plainWriters[kind];
    const [form] = Object.keys(kind);
    return { struct: structWriter, oneOf: enumWriter, maybe: maybeWriter, listOf: listWriter, mapTo: mapWriter,
             either: eitherWriter, integer: integerWriter, state: stateWriter, view: viewWriter }[form](kind[form], kind);
  }

  function writeBits(value) {
    let bits;
    try { bits = BigInt(value); } catch { throw new Refusal(`${show(value)} is not a whole number`); }
    if (BigInt.asUintN(64, bits) !== bits) throw new Refusal(`${value} is not within 0 to 2^64 - 1`);
    write(Number(bits & 0xffffffffn));
    write(Number(bits >> 32n));
  }
  const plainWriters = {
    bits: writeBits,
    tag: writeBits,
    number(value) {
      if (typeof value !== 'number') throw new Refusal(`${show(value)} is not a number`);
      write(value);
    },
    bool(value) {
      if (typeof value !== 'boolean') throw new Refusal(`${show(value)} is neither true nor false`);
      write(value ? 1 : 0);
    },
    vec(value) {
      const isList = Array.isArray(value), x = isList ? value[0] : value?.x, y = isList ? value[1] : value?.y;
      if (typeof x !== 'number' || typeof y !== 'number' || isList && value.length !== 2)
        throw new Refusal(`${show(value)} is not [x, y]`);
      write(x);
      write(y);
    },
    text(value) {
      if (typeof value !== 'string') throw new Refusal(`${show(value)} is not a text`);
      write(value.length);
      for (let i = 0; i < value.length; ++i) write(value.charCodeAt(i));
    },
    rule(value) { write(value == null ? 0 : numberOfRule(value)); },
    world(value) {
      if (!isWorld(value)) throw new Refusal(`${show(value)} is not a World`);
      write(value.address);
    },
    mover(value) {
      write(value.world.address);
      write(value.slot);
    },
  };

  const integerWriter = ([low, high]) => value => {
    if (!Number.isInteger(value) || value < low || value > high)
      throw new Refusal(`${show(value)} is not a whole number from ${low} to ${high}`);
    write(value);
  };
  const enumWriter = name => {
    const words = schema.enumerations[name];
    return value => {
      const index = words.indexOf(value);
      if (index < 0) throw new Refusal(`${show(value)} is none of ${words.join(', ')}`);
      write(index);
    };
  };
  const maybeWriter = kind => {
    const one = writerOf(kind);
    return value => {
      write(value == null ? 0 : 1);
      if (value != null) one(value);
    };
  };
  const listWriter = kind => {
    const one = writerOf(kind);
    return value => {
      if (!Array.isArray(value) && !ArrayBuffer.isView(value)) throw new Refusal(`${show(value)} is not a list`);
      write(value.length);
      let i = 0;
      try {
        for (; i < value.length; ++i) one(value[i]);
      } catch (error) { throw within(error, `[${i}]`); }
    };
  };
  const mapWriter = kind => {
    const one = writerOf(kind);
    return value => {
      const entries = Object.entries(value);
      write(entries.length);
      for (const [sign, meant] of entries) {
        if (sign.length !== 1 || sign.charCodeAt(0) > 127)
          throw new Refusal(`${show(sign)} is not a single ASCII character`);
        write(sign.charCodeAt(0));
        try { one(meant); } catch (error) { throw within(error, show(sign)); }
      }
    };
  };
  const eitherWriter = kinds => {
    const tags = Object.keys(kinds), ones = tags.map(tag => writerOf(kinds[tag]));
    return value => {
      const given = value !== null && typeof value === 'object' ? Object.keys(value) : [];
      const index = given.length === 1 ? tags.indexOf(given[0]) : -1;
      if (index < 0) {
        const near = given.length === 1 && nearestTo(given[0], tags);
        if (given.length > 1 && given.every(name => tags.includes(name)))
          throw new Refusal(`only one of ${given.join(', ')} can be given`);
        throw new Refusal(`${given.length ? given.join(', ') : show(value)} is not one of ${tags.join(', ')}` +
                          (near ? `; did you mean ${near}?` : ''));
      }
      write(index);
      try { ones[index](value[tags[index]]); } catch (error) { throw within(error, tags[index]); }
    };
  };
  const stateWriter = (name, { words }) => value => {
    if (value?.words?.length !== words) throw new Refusal(`${show(value)} is not a ${name}`);
    for (const word of value.words) write(word);
  };
  const viewWriter = name => {
    const id = writerOf(idKindOf(name));
    return view => {
      write(view.world.address);
      id(view.id());
    };
  };

  const idWriter = (Class, name) => value => {
    const id = value instanceof View ? value.id() : value;
    if (id == null) {
      for (let i = 0; i < (Class === ShapeId ? 4 : 3); ++i) write(0);
      return;
    }
    if (!(id instanceof Class)) throw new Refusal(`${show(value)} is not a ${name}`);
    const slot = Class === ShapeId ? id.body : id;
    write(slot.index);
    write(slot.generation);
    write(slot.world);
    if (Class === ShapeId) write(id.number);
  };

  /** The numbers of a default, written once. */
  function rowOf(kind, value) {
    const from = length;
    writerOf(kind)(asGiven(kind, value));
    const numbers = row.slice(from, length);
    length = from;
    return numbers;
  }
  /** JSON has no infinite numbers and no BigInt: they come as words. */
  function asGiven(kind, value) {
    if (typeof value === 'string' && kind === 'number') return Number(value);
    if (Array.isArray(value) && kind === 'vec') return value.map(Number);
    if (Array.isArray(value) && kind.listOf) return value.map(one => asGiven(kind.listOf, one));
    if (value && kind.maybe) return asGiven(kind.maybe, value);
    if (value && kind.either) {
      const [tag] = Object.keys(value);
      return { [tag]: asGiven(kind.either[tag], value[tag]) };
    }
    if (!value || !kind.struct) return value;
    if (idClasses[kind.struct]) return null;
    return Object.fromEntries(schema.types[kind.struct].filter(m => hasDefault(m))
      .map(m => [m.name, asGiven(m.kind, value[m.name])]));
  }
  const hasDefault = ({ kind, value }) => !kind.state && !(kind.struct && value === null);

  function structWriter(name) {
    if (idClasses[name]) return idWriter(idClasses[name], name);
    let members, known;
    const prepare = () => {
      members = schema.types[name].map(({ name, kind, value }) =>
        ({ name, write: writerOf(kind), default: hasDefault({ kind, value }) ? rowOf(kind, value) : undefined }));
      known = new Set(members.map(m => m.name));
    };
    return value => {
      if (!members) prepare();
      if (value === null || typeof value !== 'object' || Array.isArray(value) && members.length)
        throw new Refusal(`${show(value)} is not a ${name}`);
      for (const key in value)
        if (!known.has(key))
          throw new Refusal(`a ${name} has no such member${hintFor(schema, name, key)}`).within(key);
      for (let i = 0; i < members.length; ++i) {
        const member = members[i], given = value[member.name];
        if (given !== undefined) {
          try { member.write(given); } catch (error) { throw within(error, member.name); }
        } else {
          if (!member.default) throw new Refusal('is missing').within(member.name);
          for (let j = 0; j < member.default.length; ++j) write(member.default[j]);
        }
      }
    };
  }

  return {
    writerOf,
    write,
    clear() { length = 0; },
    length: () => length,
    copyTo(numbers, start) { for (let i = 0; i < length; ++i) numbers[start + i] = row[i]; },
  };
}
