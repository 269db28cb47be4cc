// SPDX-License-Identifier: MIT
// What are ids and views? Ids are values, and one object for each: they can be compared with === and be keys of a Map.

/** Each has a kind, which tells it from the others in types and in JSON. */
class Id {
  constructor(index, generation, world) {
    this.index = index;
    this.generation = generation;
    this.world = world;
  }
  toString() { return `${this.kind}(${this.index}, ${this.generation}, ${this.world})`; }
  toJSON() { return { kind: this.kind, ...this }; }
}
export class BodyId extends Id {
  #shapes = [];
  get kind() { return 'BodyId'; }
  /** The id of one of its shapes, which are counted from 0. */
  shape(number) { return (this.#shapes[number] ??= new ShapeId(this, number)); }
}
export class JointId extends Id {
  get kind() { return 'JointId'; }
}
export class FieldId extends Id {
  get kind() { return 'FieldId'; }
}
export class ShapeId {
  constructor(body, number) {
    this.body = body;
    this.number = number;
    Object.freeze(this);
  }
  get kind() { return 'ShapeId'; }
  toString() { return `ShapeId(${this.body}, ${this.number})`; }
  toJSON() { return { kind: 'ShapeId', ...this }; }
}

/** The ids of one world's objects, by their slots. */
export class Ids {
  known = new Map([[BodyId, []], [JointId, []], [FieldId, []]]);

  of(Class, index, generation, world) {
    if (world === 0) return null;
    const slots = this.known.get(Class), known = slots[index];
    if (known && known.generation === generation && known.world === world) return known;
    const id = Object.freeze(new Class(index, generation, world));
    if (!known || known.generation < generation || known.world !== world) slots[index] = id;
    return id;
  }
  shapeOf(body, number) {
    return body && body.shape(number);
  }
}

export const idClasses = { BodyId, JointId, FieldId, ShapeId };

/** The kind of the id that a view has, by the view's name in the schema. */
export const idKindOf = view =>
  ({ struct: { Body: 'BodyId', BodyShape: 'ShapeId', Joint: 'JointId', Field: 'FieldId' }[view.replace('View', '')] });

/** Reads and changes an object of a world. */
export class View {
  #id;
  constructor(world, id) {
    this.world = world;
    this.#id = id;
    Object.preventExtensions(this);  // what is written to a view would be lost with it
  }
  id() { return this.#id; }
}

/** Keeps what was made for a kind. */
export const cached = make => {
  const made = new Map();
  return kind => {
    const key = typeof kind === 'string' ? kind : JSON.stringify(kind);
    if (!made.has(key)) made.set(key, make(kind));
    return made.get(key);
  };
};
