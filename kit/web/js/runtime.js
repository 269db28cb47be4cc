// SPDX-License-Identifier: MIT
// The kit for JavaScript. The build puts the schema before this text: what the kit's structs and functions are called,
// and of which kinds their members and parameters are. Nothing but numbers crosses to the module; row.h reads and
// writes the same rows.

/** The columns of World.contacts(): a row is a point of a contact. */
export const contactColumns = Object.freeze([
  'indexA', 'shapeA', 'indexB', 'shapeB', 'x', 'y', 'normalX', 'normalY', 'separation', 'normalForce', 'frictionForce']);
/** The columns of World.events(): a row is an event. What an event does not have is NaN. */
export const eventColumns = Object.freeze([
  'kind', 'indexA', 'shapeA', 'indexB', 'shapeB', 'x', 'y', 'normalX', 'normalY', 'speed']);
/** The kinds of events, by their number in World.events(). */
export const eventKinds = Object.freeze([
  'contactBegin', 'contactEnd', 'contactHit', 'sensorBegin', 'sensorEnd', 'jointBreak', 'quarantine']);
export const unlimited = Infinity;

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

function nearestTo(word, known) {
  const ranked = [...known].sort((a, b) => editDistance(word, a) - editDistance(word, b));
  return ranked.length && editDistance(word, ranked[0]) <= Math.max(2, Math.ceil(word.length / 2)) ? ranked[0] : undefined;
}

/** An error that learns on its way out of which member it tells. */
class Refusal extends Error {
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
const within = (error, name) => (error instanceof Refusal ? error.within(name) : error);
/** As the kit tells it: "World.step: dt: ..." */
const told = (error, title, parameter) => {
  if (error instanceof Refusal) error.within(parameter).message = `${title}: ${error.message}`;
  return error;
};

const show = value => {
  if (typeof value === 'string') return JSON.stringify(value);
  if (typeof value === 'function') return 'a function';
  if (Array.isArray(value)) return `[${value.map(show).join(', ')}]`;
  return value !== null && typeof value === 'object' ? 'an object' : String(value);
};

// Ids are values, and one object for each: they can be compared with === and be keys of a Map.

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
class Ids {
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

/** @param source where plumb.wasm is: its bytes, a URL, or a Response; without it, beside this file. */
export async function load(source) {
  const module = await compiled(source ?? wasmSource());
  let exports;
  const mayTouch = (rule, at, count) => asked(rule, at, count);
  const imports = { plumb: { mayTouch }, wasi_snapshot_preview1: {} };
  const notThere = 52;
  for (const { name } of WebAssembly.Module.imports(module).filter(i => i.module === 'wasi_snapshot_preview1'))
    imports.wasi_snapshot_preview1[name] = () => notThere;
  imports.wasi_snapshot_preview1.clock_time_get = (clock, precision, at) => {
    new DataView(exports.memory.buffer).setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
    return 0;
  };
  exports = (await WebAssembly.instantiate(module, imports)).exports;
  exports._initialize();
  if (exports.hashOfSchema() >>> 0 !== schemaHash) throw new Error('plumb.js and plumb.wasm are not of one build');

  let numbers = new Float64Array(exports.memory.buffer);
  const inMemory = () => {
    if (numbers.buffer !== exports.memory.buffer) numbers = new Float64Array(exports.memory.buffer);
    return numbers;
  };

  const idClasses = { BodyId, JointId, FieldId, ShapeId };

  // ---- what goes in: a row, and for each kind of value a function that writes it there

  const row = [];
  let length = 0;
  const write = number => void (row[length++] = number);
  const writers = new Map(), readers = new Map();
  const cached = (map, make) => kind => {
    const key = typeof kind === 'string' ? kind : JSON.stringify(kind);
    if (!map.has(key)) map.set(key, make(kind));
    return map.get(key);
  };
  const writerOf = cached(writers, makeWriter), readerOf = cached(readers, makeReader);

  function makeWriter(kind) {
    if (typeof kind === 'string') return plainWriters[kind];
    const [form] = Object.keys(kind);
    return { struct: structWriter, oneOf: enumWriter, maybe: maybeWriter, listOf: listWriter, mapTo: mapWriter,
             either: eitherWriter, integer: integerWriter, state: stateWriter, view: viewWriter }[form](kind[form], kind);
  }

  const plainWriters = {
    number(value) {
      if (typeof value !== 'number') throw new Refusal(`${show(value)} is not a number`);
      write(value);
    },
    bool(value) {
      if (typeof value !== 'boolean') throw new Refusal(`${show(value)} is neither true nor false`);
      write(value ? 1 : 0);
    },
    bits(value) {
      let bits;
      try { bits = BigInt(value); } catch { throw new Refusal(`${show(value)} is not a whole number`); }
      if (BigInt.asUintN(64, bits) !== bits) throw new Refusal(`${value} is not within 0 to 2^64 - 1`);
      write(Number(bits & 0xffffffffn));
      write(Number(bits >> 32n));
    },
    vec(value) {
      const x = Array.isArray(value) ? value[0] : value?.x, y = Array.isArray(value) ? value[1] : value?.y;
      if (typeof x !== 'number' || typeof y !== 'number') throw new Refusal(`${show(value)} is not [x, y]`);
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
      if (!(value instanceof World)) throw new Refusal(`${show(value)} is not a World`);
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
  const idKindOf = view =>
    ({ struct: { Body: 'BodyId', BodyShape: 'ShapeId', Joint: 'JointId', Field: 'FieldId' }[view.replace('View', '')] });
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
        if (!known.has(key)) {
          const near = nearestTo(key, known);
          throw new Refusal(`a ${name} has no such member` + (near ? `; did you mean ${near}?` : '')).within(key);
        }
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

  // ---- what comes out

  let at = 0, ids = new Ids();
  const read = () => numbers[at++];

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
      case 'state': return () => new states[of](Array.from({ length: kind.words }, read));
      case 'struct': return structReader(of);
    }
  }

  const plainReaders = {
    nothing() {},
    number: read,
    bool: () => read() !== 0,
    bits: () => BigInt(read()) | (BigInt(read()) << 32n),
    vec: () => [read(), read()],
    text: () => String.fromCharCode(...Array.from({ length: read() }, read)),
    rule: () => rules[read() - 1] ?? null,
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

  // ---- rules: functions that the module asks while it steps

  const rules = [];
  let busy = false, thrown = null;
  function numberOfRule(rule) {
    if (typeof rule !== 'function') throw new Refusal(`${show(rule)} is not a function`);
    let index = rules.indexOf(rule);
    if (index < 0) {
      if (rules.length === schema.mostRules)
        throw new Refusal(`there may be no more than ${schema.mostRules} different rules; use one for many shapes`);
      index = rules.push(rule) - 1;
    }
    return index + 1;
  }
  const candidate = () => readerOf({ struct: 'ContactCandidate' })();
  function asked(rule, from) {
    if (thrown) return 0;
    inMemory();
    at = from >>> 3;
    try {
      return rules[rule - 1](candidate()) ? 1 : 0;
    } catch (error) {  // not through the module, which could not go on
      thrown = { error };
      return 0;
    }
  }

  // ---- calls

  const decoder = new TextDecoder();
  function refusal() {
    const bytes = new Uint8Array(exports.memory.buffer, exports.refusalAt(), exports.refusalLength());
    return new Error(decoder.decode(bytes));
  }
  let room = exports.room(1024), capacity = 1024;
  function send() {
    if (length > capacity) {
      capacity = 2 * length;
      room = exports.room(capacity);
      if (!room) {
        capacity = 0;
        throw refusal();
      }
    }
    const to = inMemory(), start = room >>> 3;
    for (let i = 0; i < length; ++i) to[start + i] = row[i];
  }
  /** Runs one function of the module; its result is then at `at`. */
  function run(act) {
    if (busy) throw new Error('a contact rule was asked by the kit, and may not call it');
    busy = true;
    let count;
    try { count = act(); } finally { busy = false; }
    if (thrown) {
      const { error } = thrown;
      thrown = null;
      throw error;
    }
    if (count < 0) throw refusal();
    inMemory();
    at = exports.resultAt() >>> 3;
    return count;
  }

  /** A parameter: its name, and how it is written when it is given and when it is not. */
  function parameterOf(text, kind) {
    const [name, preset] = text.split(' = ');
    const optional = name.endsWith('?') || preset !== undefined;
    const plain = name.replace('?', '');
    const empty = kind.maybe || idClasses[kind.struct] ? null : kind.struct ? {} : preset === undefined ? undefined :
      kind === 'number' || kind.integer ? Number(preset) : preset;
    return { name: plain, kind, optional, empty, write: writerOf(kind),
             // What is wrong with a struct is told by its type's name, as in the kit's own texts.
             root: kind.struct && !idClasses[kind.struct] ? kind.struct : plain };
  }

  /** Does a value look like this kind, as far as functions of one name differ? */
  const looksLike = (value, kind) => {
    if (value instanceof View) return idClasses[kind.struct] !== undefined && value.id() instanceof idClasses[kind.struct];
    for (const name in idClasses) if (value instanceof idClasses[name]) return kind.struct === name;
    return !idClasses[kind.struct] || value == null;
  };

  function functionFor(number, { owner, name, parameters, kinds, result, changesState }) {
    const hasSelf = owner !== '' && name !== 'new', texts = parameters ? parameters.split(', ') : [];
    const self = hasSelf ? writerOf(kinds[0]) : null;
    const given = texts.map((text, i) => parameterOf(text, kinds[i + (hasSelf ? 1 : 0)]));
    const title = (owner ? owner + '.' : '') + name, worldIndex = given.findIndex(p => p.kind === 'world');
    const finish = result.view ? viewOf(result.view) : readerOf(result);
    const call = (object, args) => {
      if (args.length > given.length)
        throw new Error(`${title}: ${args.length} arguments were given, at most ${given.length} are wanted`);
      length = 0;
      if (self) self(object);
      for (let i = 0; i < given.length; ++i) {
        const p = given[i], value = args[i];
        try {
          if (value !== undefined) p.write(value);
          else if (p.optional) p.write(p.empty);
          else throw new Refusal('is missing');
        } catch (error) {
          throw p.root === p.name ? told(error, title, p.name) : within(error, p.root);
        }
      }
      send();
      const world = worldIndex >= 0 ? args[worldIndex] : object instanceof World ? object : object?.world;
      run(() => exports.call(number, length));
      if (world) ids = world.ids;
      const value = finish(world);
      if (changesState) for (let i = 0; i < object.words.length; ++i) object.words[i] = read();
      return value;
    };
    call.fits = args => args.length <= given.length &&
      given.every((p, i) => (args[i] === undefined ? p.optional : looksLike(args[i], p.kind)));
    call.title = title;
    return call;
  }

  const viewOf = name => {
    const id = readerOf(idKindOf(name));
    return world => new views[name](world, id());
  };

  // ---- the classes

  class View {
    #id;
    constructor(world, id) {
      this.world = world;
      this.#id = id;
    }
    id() { return this.#id; }
  }
  const views = { Body: class Body extends View {}, BodyShape: class BodyShape extends View {},
                  Joint: class Joint extends View {}, Field: class Field extends View {} };

  const gone = new FinalizationRegistry(free => free());
  class World {
    #box;
    #rows = [];
    ids = new Ids();
    constructor(def = {}) {
      this.#box = { address: def === fromCopy ? copied : functions.World.new[0](null, [def]) };
      const box = this.#box;
      gone.register(this, () => free(box), this);
    }
    get address() { return this.#box.address; }
    /** A copy goes on as this world would, to the last bit, and its objects have the same ids. */
    copy() {
      copied = functions.World.copy[0](this, []);
      const world = new World(fromCopy);
      world.ids = this.ids;
      return world;
    }
    /** Gives back the world's memory, and that of its movers. A world that is no longer used is freed some time. */
    free() {
      gone.unregister(this);
      free(this.#box);
    }
    #all(which) {
      const count = run(() => exports.rowsOf(this.address, which));
      let all = this.#rows[which];
      if (!all || all.length < count) all = this.#rows[which] = new Float64Array(Math.max(2 * count, 32));
      for (let i = 0; i < count; ++i) all[i] = numbers[at + i];
      const last = this.#views[which];
      if (last && last.buffer === all.buffer && last.length === count) return last;
      return (this.#views[which] = all.subarray(0, count));
    }
    #views = [];
    poses() { return this.#all(0); }
    velocities() { return this.#all(1); }
    contacts() { return this.#all(2); }
    events() { return this.#all(3); }
  }
  let copied = 0;
  const fromCopy = Symbol('copy');
  const freeCall = schema.calls.findIndex(c => c.owner === 'World' && c.name === 'free');
  function free(box) {
    if (!box.address) return;
    length = 0;
    write(box.address);
    box.address = 0;
    send();
    run(() => exports.call(freeCall, length));
  }

  /** Movers live in a world, and are freed with it. */
  class Mover {
    constructor(name, world, rest) {
      if (!(world instanceof World)) throw new Error(`${name}.new: world: ${show(world)} is not a World`);
      this.world = world;
      this.slot = functions[name].new[0](null, [world, ...rest]);
      const held = { world, slot: this.slot };
      gone.register(this, () => held.world.address && functions[name].free[0](held, []), this);
    }
  }
  const moverClass = name => ({ [name]: class extends Mover {
    constructor(world, ...rest) { super(name, world, rest); }
    free() {
      gone.unregister(this);
      functions[name].free[0](this, []);
    }
  } })[name];
  const movers = { GridMover: moverClass('GridMover'), PlatformMover: moverClass('PlatformMover'),
                   PathMover: moverClass('PathMover') };

  /** Objects whose state is a few numbers, which lie here and go along with each call. */
  const stateClass = name => ({ [name]: class {
    constructor(...args) {
      this.words = args.length === 1 && Array.isArray(args[0]) ? args[0] : functions[name].new[0](null, args).words;
    }
    copy() { return new this.constructor([...this.words]); }
  } })[name];
  const states = { FixedClock: stateClass('FixedClock'), Random: stateClass('Random') };

  const classes = { World, ...views, ...movers, ...states };
  const functions = {}, free_ = {};
  schema.calls.forEach((entry, number) => {
    const group = (functions[entry.owner || 'plain'] ??= {});
    (group[entry.name] ??= []).push(functionFor(number, entry));
  });
  const choose = (overloads, object, args) => {
    if (overloads.length === 1) return overloads[0](object, args);
    const fitting = overloads.find(one => one.fits(args));
    if (!fitting) throw new Error(`${overloads[0].title}: (${args.map(show).join(', ')}) fits none of its forms`);
    return fitting(object, args);
  };
  for (const owner in functions)
    for (const name in functions[owner]) {
      if (name === 'new' || name === 'free' || name === 'copy') continue;
      const overloads = functions[owner][name];
      if (owner === 'plain') free_[name] = (...args) => choose(overloads, null, args);
      else
        Object.defineProperty(classes[owner].prototype, name, {
          configurable: true, writable: true, value(...args) { return choose(overloads, this, args); } });
    }

  class MotionPath {
    constructor(start) {
      this.start = start;
      this.pieces = [];
    }
    #add(piece) {
      this.pieces.push(piece);
      try { free_.pathLength(this); } catch (error) {
        this.pieces.pop();
        throw error;
      }
      return this;
    }
    lineTo(end) { return this.#add({ lineTo: { end } }); }
    arcAround(center, angle) { return this.#add({ arcAround: { center, angle } }); }
    curveTo(first, second, end) { return this.#add({ curveTo: { first, second, end } }); }
    close() { return this.#add({ close: {} }); }
    length() { return free_.pathLength(this); }
    at(along) { return free_.pathPlaceAt(this, along); }
  }
  const splineThrough = (points, closed = false) => {
    const path = new MotionPath(points[0]);
    path.pieces = [{ splineThrough: { points: points.slice(1), closed } }];
    free_.pathLength(path);
    return path;
  };
  const { pathLength, pathPlaceAt, ...plain } = free_;
  return { ...plain, ...classes, MotionPath, splineThrough, BodyId, ShapeId, JointId, FieldId, contactColumns,
           eventColumns, eventKinds, unlimited, memory: exports.memory };
}

async function compiled(source) {
  source = await source;
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
  if (typeof Response !== 'undefined' && source instanceof Response) return WebAssembly.compileStreaming(source);
  const url = new URL(source, globalThis.location?.href);
  if (url.protocol === 'file:' && typeof process !== 'undefined') {
    const files = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:fs/promises');
    return WebAssembly.compile(await files.readFile(url));
  }
  return WebAssembly.compileStreaming(fetch(url));
}

export default load;
