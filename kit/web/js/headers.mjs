// SPDX-License-Identifier: MIT
// What do the kit's headers say of a struct, a member or a function?
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

import { declarationsIn, parametersOf } from './declarations.mjs';

const textOf = lines => lines.map(line => line.trim()).join(' ').trim();

/** As JavaScript says it, and without what tests and sources say. */
const inJavaScript = text => text.replace(/\bstd::invalid_argument\b/g, 'an Error').replace(/ ?\b(Tests?|Source): .*$/, '')
  .replace(/std::nullopt/g, 'null').replace(/std::/g, '').trim();

/** What a function is looked up by: the name with all parameters, with the first of them, and alone. */
function functionNames(name, code) {
  const { names } = parametersOf(code);
  return [`${name}(${names.join(',')})`, `${name}(${names[0]}`, name];
}

/** Adds to `docs` the comments of declarations, by "Struct", "Struct.member", "Class.function" or "function". */
function collect(declarations, owner, docs) {
  for (const { kind, names, code, doc, after, members } of declarations.filter(one => !one.note)) {
    const said = textOf([...doc, ...after]);
    for (const name of kind === 'function' && names.length ? functionNames(names[0], code) : names) {
      const key = owner ? `${owner}.${name}` : name;
      if (said && !docs.has(key)) docs.set(key, said);
    }
    if (members) collect(members, kind === 'namespace' ? owner : names[0], docs);
  }
}

function headersUnder(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap(entry =>
    entry.isDirectory() ? headersUnder(join(folder, entry.name)) : entry.name.endsWith('.h') ? [join(folder, entry.name)] : []);
}

/** A Map from names to what the headers under a folder say of them. */
export function commentsOf(folder) {
  const docs = new Map();
  for (const header of headersUnder(folder).sort()) collect(declarationsIn(readFileSync(header, 'utf8')), '', docs);
  for (const [key, value] of docs) docs.set(key, inJavaScript(value));
  return docs;
}
