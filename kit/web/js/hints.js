// SPDX-License-Identifier: MIT
// A definition has a member that its struct does not have: what was meant?
import { idClasses } from './ids.js';
import { nearestTo } from './refusals.js';

const membersOf = (schema, kind) => {
  if (kind.either) return Object.entries(kind.either);
  if (!kind.struct || idClasses[kind.struct]) return [];
  return schema.types[kind.struct].map(member => [member.name, member.kind]);
};

/** How a member is written that stands in a value of a kind, so many levels deep: "{ shape: { circle: ... } }" */
function written(schema, kind, key, depth) {
  if (kind.maybe) return written(schema, kind.maybe, key, depth);
  if (kind.listOf) {
    const one = written(schema, kind.listOf, key, depth);
    return one && `[${one}]`;
  }
  const members = membersOf(schema, kind);
  if (depth === 0) return members.some(([name]) => name === key) ? `{ ${key}: ... }` : undefined;
  for (const [name, of] of members) {
    const one = written(schema, of, key, depth - 1);
    if (one) return `{ ${name}: ${one} }`;
  }
}

/** "; did you mean position?", or nothing. */
export function hintFor(schema, struct, key) {
  const own = schema.types[struct].map(member => member.name);
  const isMaterial = schema.types.Material.some(member => member.name === key);
  if (struct === 'BodyDef' && isMaterial) return `; a shape's material has it: circle(radius, { ${key}: ... })`;
  for (const depth of [1, 2, 3]) {
    const text = written(schema, { struct }, key, depth);
    if (text) return `; ${text.slice(2, -2)} was meant`;
  }
  if (schema.calls.some(call => call.owner === '' && call.name === key && call.result.struct === struct))
    return `; call ${key}(...), which makes a ${struct}`;
  const near = nearestTo(key, own);
  return near ? `; did you mean ${near}?` : '';
}
