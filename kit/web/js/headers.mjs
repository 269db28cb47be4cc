// SPDX-License-Identifier: MIT
// What do the kit's headers say of a struct, a member or a function?
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

const textOf = lines => lines.map(line => line.replace(/^\s*\/\/\/<?\s?/, '').trim()).join(' ').trim();

/** As JavaScript says it, and without what tests and sources say. */
const inJavaScript = text => text.replace(/\bstd::invalid_argument\b/g, 'an Error').replace(/ ?\b(Tests?|Source): .*$/, '')
  .replace(/std::nullopt/g, 'null').replace(/std::/g, '').trim();

/** The name that a declaration of the house's style declares, or undefined. */
function functionIn(line) {
  const found = /^[\w:<>&*,\s[\]().]*?[\s&*](\w+)\(/.exec(line);
  return found && !/^\s*(return|if|for|while|else|friend|using)\b/.test(line) ? found[1] : undefined;
}

/** The name of a function, and the name with that of its first parameter, for functions of one name. */
function functionNames(declaration) {
  const name = functionIn(declaration), first = /(\w+)(?: = [^,)]*)?$/.exec(/\(([^,)]*)/.exec(declaration)[1].trim());
  return [`${name}(${first ? first[1] : ''}`, name];
}

function membersIn(line) {
  const found = /^[\w:<>,\s]+?[\s>&](\w+(?:\s*(?:=[^;,]*|\{[^;]*\})?\s*,\s*\w+)*)\s*(?:=.*|\{.*\})?;/.exec(line);
  return found ? found[1].split(',').map(part => /\w+/.exec(part)[0]) : [];
}

/** Adds to `docs` the comments of one header, by "Struct", "Struct.member", "Class.function" or "function". */
function readHeader(text, docs) {
  let owner = '', before = [], open = '', last = [];
  const add = (names, comment) => {
    for (const name of names) if (comment && !docs.has(name)) docs.set(name, comment);
  };
  for (const line of text.split('\n')) {
    const type = /^(?:struct|class|enum class) (\w+)[^;]*\{/.exec(line);
    if (/^\s*\/\/\/(?!<)/.test(line)) {
      before.push(line);
      continue;
    }
    if (/^\s*\/\/\/</.test(line)) {
      for (const name of last) docs.set(name, `${docs.get(name) ?? ''} ${textOf([line])}`.trim());
      continue;
    }
    if (type) {
      owner = type[1];
      add([owner], textOf(before));
      before = [];
      continue;
    }
    if (line.startsWith('}')) owner = '';
    const [code, after] = line.split('///<');
    open += ` ${code.trim()}`;
    const names = open.includes('(') && functionIn(open) ? functionNames(open) : membersIn(open);
    last = names.map(name => (owner ? `${owner}.${name}` : name));
    add(last, textOf(before) + (after ? ` ${after.trim()}` : ''));
    if (/[;{}]\s*$/.test(code.trim()) || code.trim() === '') {
      open = '';
      before = [];
    }
  }
}

function headersUnder(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap(entry =>
    entry.isDirectory() ? headersUnder(join(folder, entry.name)) : entry.name.endsWith('.h') ? [join(folder, entry.name)] : []);
}

/** A Map from names to what the headers under a folder say of them. */
export function commentsOf(folder) {
  const docs = new Map();
  for (const header of headersUnder(folder).sort()) readHeader(readFileSync(header, 'utf8'), docs);
  for (const [key, value] of docs) docs.set(key, inJavaScript(value));
  return docs;
}
