// SPDX-License-Identifier: MIT
// What do console.log and JSON.stringify show of a world, of a view and of a mover?

/** The methods whose answers are shown. */
const shownMethods = {
  World: ['gravity', 'counts'],
  Body: ['type', 'position', 'angle', 'velocity', 'angularVelocity'],
  BodyShape: ['def'],
  Joint: ['def', 'coordinate'],
  Field: ['def'],
  GridMover: ['cell', 'heading', 'stopped'],
  PlatformMover: ['body', 'slide'],
  PathMover: ['period'],
  FixedClock: ['interval', 'tick', 'time', 'paused'],
};

/** Of an object that is gone, the text of the error. */
function answersOf(object, methods) {
  const answers = object.id ? { id: object.id() } : {};
  try {
    for (const method of methods) answers[method] = object[method]();
  } catch (error) { answers.error = error.message; }
  return answers;
}

/** JSON has no BigInt and no infinite numbers: they are texts there. */
const forJson = (key, value) =>
  typeof value === 'bigint' || typeof value === 'number' && !Number.isFinite(value) ? String(value) : value;

/** Gives classes what console.log of Node, and JSON.stringify, ask for. */
export function showObjects(classes) {
  const define = (name, key, value) =>
    Object.defineProperty(classes[name].prototype, key, { configurable: true, writable: true, value });
  for (const [name, methods] of Object.entries(shownMethods)) {
    define(name, 'toJSON', function () { return JSON.parse(JSON.stringify(answersOf(this, methods), forJson)); });
    define(name, Symbol.for('nodejs.util.inspect.custom'), function (depth, options, inspect) {
      return depth < 0 ? `[${name}]` : `${name} ${inspect(answersOf(this, methods), options)}`;
    });
  }
}
