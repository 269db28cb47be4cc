// SPDX-License-Identifier: MIT
// What can a program call? Pages of all public classes and functions, from the kit's headers and from the module's
// types. A header is public when it lies in a module's own folder, as kit/plumb/dynamics/world.h.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

import { declarationsIn, parametersOf } from '../../kit/web/js/declarations.mjs';
import { coloured } from './code.mjs';
import { escaped } from './template.mjs';

const types = ['struct', 'class', 'enum', 'interface', 'type', 'concept'];

/** Is it for users: named, public, no part of the kit's own work, no definition of what is declared elsewhere, and not
 * there only to say what to write instead? */
const isPublic = one => one.note || (one.access === 'public' && one.names.length > 0 && !one.forward && one.kind !== 'other' &&
  !one.refused && !/\)\s*= delete$/.test(one.code) &&
  !/\bdetail::|~/.test(one.code.split(' : ')[0]) && one.names.every(name => !name.includes('<') && !one.code.includes(`::${name}(`) &&
  !one.code.includes(`::${name}{`) && name !== 'operator='));

/** The declarations of a namespace or a class, with notes between them. */
const publicIn = list => list.filter(one => isPublic(one) && one.kind !== 'namespace')
  .map(one => (one.members ? { ...one, members: publicIn(one.members) } : one));

/** A function without the values that a constructor gives to its members. */
function withoutMemberList(code) {
  const { end } = parametersOf(code);
  return code.slice(0, end) + code.slice(end).replace(/\s*(?<!:):(?!:).*$/, '');
}

/** What tests prove is told in the headers, for those who change them. */
const withoutTests = text => text.replace(/\s*\bTests?: (?:"[^"]*"(?:, )?)+\.?/g, '');

/** Comments as HTML: formulas that are indented keep their lines, and units stand out. */
function prose(lines) {
  const blocks = [];
  for (const line of lines) {
    const formula = /^\s{2,}\S/.test(line), last = blocks.at(-1);
    if (!line.trim()) blocks.push({ text: '' });
    else if (last?.text && last.formula === formula) last.text += (formula ? '\n' : ' ') + line.trim();
    else blocks.push({ formula, text: line.trim() });
  }
  return blocks.map(({ formula, text }) => ({ formula, text: withoutTests(text).trim() })).filter(block => block.text)
    .map(({ formula, text }) => (formula ? `<pre class="formula">${escaped(text)}</pre>` :
      `<p>${escaped(text).replace(/\[[^\]]{1,24}\]/g, '<span class="unit">$&</span>')}</p>`)).join('');
}

/** One page of a reference; `links` are the places of the types that it may name. */
class Page {
  constructor(pages, place, language, links) {
    Object.assign(this, { pages, place, language, links, used: new Map() });
  }

  /** A name for links to a declaration: World.add, then World.add-2 for another of that name. */
  idOf(name) {
    const id = name.replace(/\s/g, ''), count = (this.used.get(id) ?? 0) + 1;
    this.used.set(id, count);
    if (count > 1) return `${id}-${count}`;
    this.pages.add(name, this.language === 'cpp' ? 'C++' : 'JavaScript', `${this.place}#${encodeURIComponent(id)}`);
    return id;
  }

  /** Code in colours, in which each name of a type leads to it. */
  code(text) {
    return coloured(text, this.language).split(/(<[^>]*>)/).map(part => (part.startsWith('<') ? part :
      part.replace(/\b[A-Z]\w*/g, name => (this.links.has(name) ? `<a href="${this.links.get(name)}">${name}</a>` : name)))).join('');
  }

  declaration(one) {
    const code = one.code.replace(/^export (declare )?/, '');
    return this.code(one.kind === 'function' && this.language === 'cpp' ? withoutMemberList(code) : code);
  }

  members(owner, list = []) {
    return list.length ? `<div class="members">${list.map(one => this.member(owner, one)).join('\n')}</div>` : '';
  }

  member(owner, one) {
    if (one.note) return `<div class="note">${prose(one.note)}</div>`;
    const [id, ...others] = one.names.map(name => this.idOf(`${owner}.${name}`));
    const also = others.map(other => `<span id="${escaped(other)}"></span>`).join('');
    const inner = this.members(`${owner}.${one.names[0]}`, one.members);
    return `<div class="member" id="${escaped(id)}">${also}<code>${this.declaration(one)}</code>${prose([...one.doc, ...one.after])}${inner}</div>`;
  }

  /** A class, a function or a constant; functions of one name share a heading. */
  entry([first, ...others], include) {
    const [name] = first.names, isType = types.includes(first.kind), ids = first.names.map(one => this.idOf(one));
    const title = isType ? `${first.kind} ${name}` : first.kind === 'function' ? `${name}()` : first.names.join(', ');
    const also = ids.slice(1).map(id => `<span id="${escaped(id)}"></span>`).join('');
    const before = include ? `${coloured(`#include <${include}>`, 'cpp')}\n` : '';
    const body = [first, ...others].map(one =>
      `<pre class="declared"><code>${one === first ? before : ''}${this.declaration(one)}</code></pre>${prose([...one.doc, ...one.after])}`).join('\n');
    return `<h3 id="${escaped(ids[0])}">${escaped(title)}</h3>${also}\n${body}${this.members(name, first.members)}\n`;
  }

  /** @param include the header that a program includes for them, if it is one */
  entries(list, include) {
    const groups = [];
    for (const one of list) {
      const last = groups.at(-1)?.[0];
      if (!one.note && last?.kind === 'function' && one.kind === 'function' && last.names[0] === one.names[0]) groups.at(-1).push(one);
      else groups.push([one]);
    }
    return groups.map(group => (group[0].note ? `<div class="note">${prose(group[0].note)}</div>` : this.entry(group, include))).join('\n');
  }
}

/** A header: its question, what else its first comment says, and what it declares in namespace plumb. */
function headerOf(root, path) {
  const list = declarationsIn(readFileSync(join(root, 'kit', path), 'utf8'));
  const lines = list[0].note.slice(1), end = lines.findIndex(line => line.includes('?'));
  const spaces = list.filter(one => one.kind === 'namespace' && one.names[0] === 'plumb');
  const declared = spaces.flatMap(one => publicIn(one.members));
  return { path, question: lines.slice(0, end + 1).join(' '), more: lines.slice(end + 1), declared };
}

/** The public headers by their folder. */
export function publicHeaders(root) {
  const kit = join(root, 'kit/plumb');
  return readdirSync(kit, { withFileTypes: true }).filter(entry => entry.isDirectory()).map(({ name }) => ({
    name, headers: readdirSync(join(kit, name)).filter(file => file.endsWith('.h')).sort()
      .map(file => headerOf(root, `plumb/${name}/${file}`)).filter(header => header.declared.some(one => !one.note)),
  })).filter(folder => folder.headers.length).sort((a, b) => (a.name < b.name ? -1 : 1));
}

const typesIn = list => list.filter(one => types.includes(one.kind));

function folderPage(pages, root, { name, headers }, links) {
  const place = `reference/${name}.html`, page = new Page(pages, place, 'cpp', links);
  const hasPage = existsSync(join(root, 'kit/plumb', name, 'README.md'));
  const about = hasPage ? `<p><a href="../docs/kit/plumb/${name}/">What ${name} is for, and how it works</a></p>\n` : '';
  const parts = headers.map(({ path, question, more, declared }) =>
    `<h2 id="${path.split('/').pop()}">${path.split('/').pop()}</h2>\n<p>${escaped(question)}</p>\n${prose(more)}\n${page.entries(declared, path)}`);
  pages.write(place, `${name}, in C++`, `<h1>${name}, in C++</h1>\n${about}${parts.join('\n')}`);
  pages.add(name, 'C++', place);
}

/** The types of the module in groups: those with functions, those that are data alone, and the rest. */
function scriptGroups(list) {
  const isClass = one => one.kind === 'interface' && one.members.some(member => member.kind === 'function');
  return {
    'Classes and functions': list.filter(isClass),
    'Definitions and results': list.filter(one => one.kind === 'interface' && !isClass(one)),
    'Other types and constants': list.filter(one => one.kind !== 'interface'),
  };
}

function scriptPage(pages, text) {
  const list = publicIn(declarationsIn(text)).filter(one => !one.note), place = 'reference/javascript.html';
  const page = new Page(pages, place, 'typescript', new Map(typesIn(list).map(one => [one.names[0], `#${one.names[0]}`])));
  const body = Object.entries(scriptGroups(list)).map(([title, group]) =>
    `<h2 id="${title.toLowerCase().replace(/ /g, '-')}">${title}</h2>\n${page.entries(group)}`).join('\n');
  pages.write(place, 'The module for JavaScript', '<h1>The module for JavaScript</h1>\n' +
    '<p>From <code>plumb.d.ts</code>. <a href="../docs/kit/web/">The module\'s page</a> tells how to use it.</p>\n' +
    `<pre><code>${coloured("import { load } from 'plumb-physics';", 'javascript')}</code></pre>\n${body}`);
}

function firstPage(pages, folders) {
  const listOf = ({ name, headers }) => {
    const names = headers.flatMap(header => typesIn(header.declared).map(one => one.names[0]));
    const functions = [...new Set(headers.flatMap(header => header.declared.filter(one => one.kind === 'function').map(one => one.names[0])))];
    const link = (id, text) => `<a href="${name}.html#${encodeURIComponent(id)}">${escaped(text)}</a>`;
    return `<h2 id="${name}"><a href="${name}.html">${name}</a></h2>\n<p class="names">${names.map(one => link(one, one)).join(' ')}</p>\n` +
      `<p class="names quiet">${functions.map(one => link(one.replace(/\s/g, ''), `${one}()`)).join(' ')}</p>`;
  };
  pages.write('reference/index.html', 'Reference', '<h1>Reference</h1>\n<p>Every class and function that a program can use, with its members, ' +
    'defaults and units: in C++ by folder, and <a href="javascript.html">the module for JavaScript</a> on one page. ' +
    `The search on top finds each of these names. All of C++ is in the namespace <code>plumb</code>.</p>\n${folders.map(listOf).join('\n')}`);
  pages.add('Reference', 'page', 'reference/index.html');
}

/** @param types the file plumb.d.ts */
export function writeReference(pages, root, types) {
  const folders = publicHeaders(root), links = new Map();
  for (const { name, headers } of folders)
    for (const { declared } of headers) for (const one of typesIn(declared)) links.set(one.names[0], `${name}.html#${one.names[0]}`);
  for (const folder of folders) folderPage(pages, root, folder, links);
  scriptPage(pages, readFileSync(types, 'utf8'));
  firstPage(pages, folders);
}
