// SPDX-License-Identifier: MIT
// A game's module: its functions, with texts as strings.

const screens = ['title', 'play', 'pause', 'over', 'scores'];
const notThere = 52, noSuchFile = 8;  // WASI's numbers: for a function that is not there, and for a file that is not open

/** @param source the bytes of the module, or a promise of the response that brings them. */
export async function loadGame(source) {
  let exports;
  const system = new Proxy({
    clock_time_get(clock, precision, at) {
      new DataView(exports.memory.buffer).setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    fd_prestat_get: () => noSuchFile,  // no folder is open: the C library asks until it hears this
  }, { get: (known, name) => known[name] ?? (() => notThere) });
  const imports = { wasi_snapshot_preview1: system }, given = await source;
  const made = given instanceof Response ? WebAssembly.instantiateStreaming(given, imports) : WebAssembly.instantiate(given, imports);
  exports = (await made).instance.exports;
  exports._initialize();

  const decoder = new TextDecoder(), encoder = new TextEncoder();
  const bytes = (at, length) => new Uint8Array(exports.memory.buffer, at, length);
  const text = () => decoder.decode(bytes(exports.textAt(), exports.textLength()));
  const give = words => {
    const letters = encoder.encode(words);
    bytes(exports.room(letters.length), letters.length).set(letters);
  };
  const told = call => (call(), text());

  return {
    describe: () => told(exports.describe),
    /** What the title lists as the keys of a game's action, by their numbers. */
    listKeys(action, keys) { give(keys.join(',')); exports.listKeys(action); },
    /** Begins a run, or replays a record. Throws an Error when the record is wrong. */
    begin(record, scores = []) {
      for (const score of scores) exports.addScore(score);
      give(record);
      if (!exports.begin()) throw new Error(text());
    },
    /** False when the run is over. */
    tick(buttons) {
      const state = exports.tick(buttons);
      if (state < 0) throw new Error(text());
      return state === 1;
    },
    tap: exports.tap,
    /** The marks' numbers, and a function that gives the words of one. They hold until the next call. */
    draw(width, height, between, footer = []) {
      for (const column of footer) { give(column); exports.addFooter(); }
      const count = exports.draw(width, height, between);
      if (count < 0) throw new Error(text());
      const words = exports.textAt();
      return { numbers: new Float64Array(exports.memory.buffer, exports.numbersAt(), count),
               words: (at, length) => decoder.decode(bytes(words + at, length)) };
    },
    mix(count) {
      const at = exports.mix(count);  // it may grow the memory: then what was its buffer is no more
      return new Float32Array(exports.memory.buffer, at, count);
    },
    record: () => told(exports.record),
    toKeep: () => told(exports.toKeep),
    isReplay: () => exports.isReplay() === 1,
    replayAgrees: () => exports.replayAgrees() === 1,
    screen: () => screens[exports.screen()],
    ticks: exports.ticks,
    hash: () => BigInt.asUintN(64, exports.hash()).toString(16).padStart(16, '0'),
    showDebug: shown => exports.showDebug(shown ? 1 : 0),
  };
}

/** What describe() tells, as an object. */
export function gameInfoOf(text) {
  const info = { actions: [] };
  const numbers = list => list ? list.split(',').map(Number) : [];
  for (const line of text.split('\n')) {
    const [what, ...rest] = line.split('\t');
    if (what === 'action') info.actions.push({ name: rest[0], about: rest[1], keys: numbers(rest[2]), pads: numbers(rest[3]) });
    else if (what === 'colors') [info.background, info.panel, info.text, info.quiet, info.accent] = rest;
    else info[what] = rest[0];
  }
  return info;
}
