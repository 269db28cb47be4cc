// SPDX-License-Identifier: MIT
// What are ids and views? Ids are values, and one object for each: they can be compared with === and be keys of a Map.

class Id {
  constructor(index, generation, world) {
    this.index = index;
    this.generation = generation;
    this.world = world;
  }
}
export class BodyId extends Id {
  #shapes = [];
  /** The id of one of its shapes, which are counted from 0. */
  shape(number) { return (this.#shapes[number] ??= new ShapeId(this, number)); }
}
export class JointId extends Id {}
export class FieldId extends Id {}
export class ShapeId {
  constructor(body, number) {
    this.body = body;
    this.number = number;
    Object.freeze(this);
  }
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
