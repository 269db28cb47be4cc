// SPDX-License-Identifier: MIT
// What is told when a program assigns to a method, as in body.position = [0, 0]?

/** What changes the answer of a method, where it is not called as the method, with "set" before it. */
const changers = { position: ['setPose'], angle: ['setPose'], pose: ['setPose'], awake: ['wake', 'sleep'], def: ['set'],
                   paused: ['pause', 'resume'] };

/** "Body.position is a method: call setPose(position, angle)" */
function textOf(owner, name, prototype, parametersOf) {
  const setter = `set${name[0].toUpperCase()}${name.slice(1)}`;
  const known = [...changers[name] ?? [], setter].filter(one => one in prototype);
  const calls = known.length || !parametersOf(name) ? known : [name];
  const said = calls.map(one => `${one}(${parametersOf(one)})`).join(' or ');
  return `${owner}.${name} is a method${said ? `: call ${said}` : ', and nothing can be assigned to it'}`;
}

/**
 * Lets an assignment to a method of a class throw.
 * @param parametersOf the parameters of the method of a name: "position, angle"
 */
export function guardMethods(owner, prototype, parametersOf) {
  for (const name of Object.getOwnPropertyNames(prototype)) {
    const { value } = Object.getOwnPropertyDescriptor(prototype, name);
    if (name === 'constructor' || typeof value !== 'function') continue;
    Object.defineProperty(prototype, name, {
      configurable: true,
      get: () => value,
      set() { throw new Error(textOf(owner, name, prototype, parametersOf)); },
    });
  }
}
