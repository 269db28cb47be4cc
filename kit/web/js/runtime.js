// SPDX-License-Identifier: MIT
// The kit for JavaScript. The build puts the schema before this text, and the other files of this folder that it
// includes: what the kit's structs and functions are called, and of which kinds their members and parameters are.
// Nothing but numbers crosses to the module.

import { guardMethods } from './guards.js';
import { BodyId, FieldId, idClasses, idKindOf, Ids, JointId, ShapeId, View } from './ids.js';
import { PosesBefore } from './poses_before.js';
import { rowReader } from './reader.js';
import { Refusal, show, told, within } from './refusals.js';
import { showObjects } from './shown.js';
import { rowWriter } from './writer.js';

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

  const row = rowWriter(schema, value => value instanceof World, numberOfRule);
  const reader = rowReader(schema, (name, words) => new states[name](words), number => rules[number - 1] ?? null);

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
  const candidate = () => reader.readerOf({ struct: 'ContactCandidate' })();
  function asked(rule, from) {
    if (thrown) return 0;
    reader.begin(inMemory(), from >>> 3);
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
    if (row.length() > capacity) {
      capacity = 2 * row.length();
      room = exports.room(capacity);
      if (!room) {
        capacity = 0;
        throw refusal();
      }
    }
    row.copyTo(inMemory(), room >>> 3);
  }
  /** Runs one function of the module; the reader is then at its result. */
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
    reader.begin(inMemory(), exports.resultAt() >>> 3);
    return count;
  }

  /** A parameter: its name, and how it is written when it is given and when it is not. */
  function parameterOf(text, kind) {
    const [name, preset] = text.split(' = ');
    const optional = name.endsWith('?') || preset !== undefined;
    const plain = name.replace('?', '');
    const empty = kind.maybe || idClasses[kind.struct] ? null : kind.struct ? {} : preset === undefined ? undefined :
      kind === 'number' || kind.integer ? Number(preset) : preset;
    return { name: plain, kind, optional, empty, write: row.writerOf(kind),
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
    const self = hasSelf ? row.writerOf(kinds[0]) : null;
    const given = texts.map((text, i) => parameterOf(text, kinds[i + (hasSelf ? 1 : 0)]));
    const title = (owner ? owner + '.' : '') + name, worldIndex = given.findIndex(p => p.kind === 'world');
    const finish = result.view ? viewOf(result.view) : reader.readerOf(result);
    const call = (object, args) => {
      if (args.length > given.length)
        throw new Error(`${title}: ${args.length} arguments were given, at most ${given.length} are wanted`);
      row.clear();
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
      run(() => exports.call(number, row.length()));
      if (world) reader.useIds(world.ids);
      const value = finish(world);
      if (changesState) for (let i = 0; i < object.words.length; ++i) object.words[i] = reader.read();
      return value;
    };
    call.fits = args => args.length <= given.length &&
      given.every((p, i) => (args[i] === undefined ? p.optional : looksLike(args[i], p.kind)));
    call.title = title;
    call.parameters = given.map(p => p.name);
    return call;
  }

  const viewOf = name => {
    const id = reader.readerOf(idKindOf(name));
    return world => new views[name](world, id());
  };

  // ---- the classes

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
      if (!this.address) throw new Error('this world has been freed');
      const count = run(() => exports.rowsOf(this.address, which));
      let all = this.#rows[which];
      if (!all || all.length < count) all = this.#rows[which] = new Float64Array(Math.max(2 * count, 32));
      reader.copyTo(all, count);
      const last = this.#views[which];
      if (last && last.buffer === all.buffer && last.length === count) return last;
      return (this.#views[which] = all.subarray(0, count));
    }
    #views = [];
    poses() { return this.#all(0); }
    /** From the first call on each step keeps them. */
    posesBefore() { return (this.#before ??= new PosesBefore()).beside(this.poses()); }
    #before = null;
    step(...args) {
      this.#before?.keep(this.poses());
      choose(functions.World.step, this, args);
    }
    add(...args) {
      const id = choose(functions.World.add, this, args);
      if (id instanceof BodyId) this.#before?.forget(id.index);
      return id;
    }
    velocities() { return this.#all(1); }
    contacts() { return this.#all(2); }
    events() { return this.#all(3); }
  }
  let copied = 0;
  const fromCopy = Symbol('copy');
  const freeCall = schema.calls.findIndex(c => c.owner === 'World' && c.name === 'free');
  function free(box) {
    if (!box.address) return;
    row.clear();
    row.write(box.address);
    box.address = 0;
    send();
    run(() => exports.call(freeCall, row.length()));
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
      const overloads = functions[owner][name];
      if (name === 'new' || owner !== 'plain' && Object.hasOwn(classes[owner].prototype, name)) continue;
      if (owner === 'plain') free_[name] = (...args) => choose(overloads, null, args);
      else
        Object.defineProperty(classes[owner].prototype, name, {
          configurable: true, writable: true, value(...args) { return choose(overloads, this, args); } });
    }

  showObjects(classes);
  guardMethods('View', View.prototype, () => '');
  for (const owner in classes)
    guardMethods(owner, classes[owner].prototype, name => functions[owner][name]?.at(-1).parameters.join(', ') ?? '');

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
