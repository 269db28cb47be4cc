// SPDX-License-Identifier: MIT
// What does a header, or a file of TypeScript types, declare, and what do its comments say of it?
//
// This is no compiler: it knows comments, brackets and where a declaration ends, and that is enough for this kit.

const container = /^(?:export |declare )*(namespace|struct|class|union|interface|enum class|enum)\b/;

/** A declaration without its template<...>, its conditions, its [[attributes]] and its alignas(). */
function withoutTemplate(code) {
  let text = code.replace(/\[\[[^\]]*\]\]\s*|\balignas\([^)]*\)\s*/g, '');
  while (/^template\s*</.test(text)) {
    let at = text.indexOf('<'), depth = 0;
    do {
      if (text[at] === '<') ++depth;
      if (text[at] === '>') --depth;
    } while (++at < text.length && depth > 0);
    text = text.slice(at).trim();
  }
  const condition = /\brequires\s*\([^()]*(?:\([^()]*\)[^()]*)*\)\s*|^requires\b[^()]*?(?=\b(?:struct|class)\b)/g;
  return hasValue(text) ? text : text.replace(condition, '');
}

/** Is a value given, so that a brace or a parenthesis that follows belongs to the value? */
const hasValue = code => /(?<![=!<>])=(?!=)/.test(code.replace(/operator\s*[^\w\s(]+/g, '').split('(')[0]);

/** Does a brace after this code begin the body of a function, and no list of values? */
function beginsFunction(code) {
  const text = withoutTemplate(code);
  const inMemberList = /\)[^:]*(?<!:):(?!:)[^]*\w$/.test(text);
  return text.includes('(') && !hasValue(text) && !inMemberList;
}

class Reader {
  constructor(text) {
    this.text = text;
    this.at = 0;
  }

  next(pattern) {
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text);
    if (found) this.at = pattern.lastIndex;
    return found;
  }

  /** Declarations and notes up to the end of a block. */
  block(access, ofEnum) {
    const found = [];
    let doc = [];
    while (this.at < this.text.length) {
      const space = this.next(/\s*/y)[0];
      // What is followed by an empty line is said of no single declaration.
      if (doc.length && /\n\s*\n/.test(space)) {
        found.push({ note: doc });
        doc = [];
      }
      let part;
      if ((part = this.next(/\/\/\/(?!<) ?(.*)/y))) doc.push(part[1]);
      else if ((part = this.next(/\/\*\*([^]*?)\*\//y))) doc = part[1].split('\n').map(line => line.replace(/^\s*\* ?/, '').trim()).filter(Boolean);
      else if ((part = this.next(/(?:\/\/(?!\/).*\n?[ \t]*)+/y))) found.push({ note: part[0].trim().split(/\n\s*/).map(line => line.replace(/^\/\/ ?/, '')) });
      else if (this.next(/#(?:.*\\\n)*.*/y) || this.next(/\/\*[^]*?\*\//y) || this.next(/;/y)) continue;
      else if ((part = this.next(/(public|private|protected)\s*:(?!:)/y))) access = part[1];
      else if (this.next(/\}/y)) break;
      else {
        const declaration = this.declaration(ofEnum);
        if (declaration.code) found.push({ ...declaration, doc, access });
        doc = [];
      }
    }
    return found;
  }

  declaration(ofEnum) {
    let code = '', after = [], depth = 0, part;
    const made = more => ({ code: code.replace(/\s+/g, ' ').trim(), after: after.concat(this.commentsAfter()), ...more });
    while (this.at < this.text.length) {
      if ((part = this.next(/\/\/\/<\s*(.*)/y))) after.push(part[1]);
      else if (this.next(/\/\/.*/y) || this.next(/\/\*[^]*?\*\//y)) continue;
      else if ((part = this.next(/"(?:\\.|[^"\\])*"|(?<!\w)'(?:\\.|[^'\\])+'/y))) code += part[0];
      else {
        const letter = this.text[this.at];
        if (depth === 0 && letter === '}') return made();
        ++this.at;
        if (depth === 0 && (letter === ';' || (ofEnum && letter === ','))) return made();
        if (depth === 0 && letter === '{') {
          const type = container.exec(withoutTemplate(code.trim()))?.[1];
          if (type) return this.container(type, made);
          if (beginsFunction(code.trim())) {
            const body = this.skipBody();
            return made({ refused: /\bdetail::never\b/.test(body) });
          }
        }
        if ('([{'.includes(letter)) ++depth;
        if (')]}'.includes(letter)) --depth;
        code += letter;
      }
    }
    return made();
  }

  container(type, made) {
    const members = this.block(type === 'class' ? 'private' : 'public', type.startsWith('enum'));
    this.next(/\s*;/y);
    return made({ members });
  }

  skipBody() {
    const start = this.at;
    for (let depth = 1; depth > 0 && this.at < this.text.length;) {
      if (this.next(/\/\/.*|\/\*[^]*?\*\/|"(?:\\.|[^"\\])*"|(?<!\w)'(?:\\.|[^'\\])+'/y)) continue;
      const letter = this.text[this.at++];
      if (letter === '{') ++depth;
      if (letter === '}') --depth;
    }
    return this.text.slice(start, this.at);
  }

  /** The rest of the line, and lines that go on with it. */
  commentsAfter() {
    const found = [];
    let part = this.next(/[ \t]*\/\/\/<\s*(.*)/y);
    for (; part; part = this.next(/\n[ \t]*\/\/\/<\s*(.*)/y)) found.push(part[1]);
    if (!found.length) this.next(/[ \t]*\/\/.*/y);
    return found;
  }
}

const kinds = { struct: 'struct', class: 'class', union: 'struct', interface: 'interface', 'enum class': 'enum', enum: 'enum', namespace: 'namespace' };

function functionName(text) {
  const operator = /operator\s*(?:[^\w\s(]+|\(\)|\w+)(?=\s*\()/.exec(text);
  return operator ? operator[0] : (/(?:^|[\s&*:~])([\w]+)\s*\(/.exec(text.replace(/\bdecltype\(auto\)/g, 'auto')) ?? [])[1];
}

/** Cuts at commas outside of brackets. */
function parts(text) {
  const found = [''];
  let depth = 0;
  for (const letter of text) {
    if ('<([{'.includes(letter)) ++depth;
    if ('>)]}'.includes(letter)) --depth;
    if (letter === ',' && depth === 0) found.push('');
    else found[found.length - 1] += letter;
  }
  return found;
}

/** Of a function: the names of its parameters, and where its list of them ends. */
export function parametersOf(code) {
  const start = code.indexOf('(', code.includes('operator()') ? code.indexOf('operator()') + 'operator()'.length : 0);
  let end = start, depth = 0;
  do {
    if (code[end] === '(') ++depth;
    if (code[end] === ')') --depth;
  } while (++end < code.length && depth > 0);
  const names = parts(code.slice(start + 1, end - 1)).map(part => (/(\w+)\s*$/.exec(part.split('=')[0]) ?? ['', ''])[1]);
  return { names, end };
}

/** What kind of thing a declaration declares, and which names. */
function namesIn(code, members) {
  const text = withoutTemplate(code);
  const type = container.exec(text);
  if (type) return { kind: kinds[type[1]], names: [(/^[\w:]+(?:<.*?>)?(?=\s|$)/.exec(text.slice(type[0].length).trim()) ?? [''])[0]], forward: !members };
  const alias = /^(?:export )?(using|type|(?:inline )?(?:constexpr )?concept) (\w+)\s*(?:<.*?>)?\s*=/.exec(text);
  if (alias) return { kind: alias[1] === 'concept' ? 'concept' : 'type', names: [alias[2]] };
  if (/^(friend|using|static_assert|export \{|extern)\b/.test(text)) return { kind: 'other', names: [] };
  const call = /^[^=]*?(?:^|[\s&*:~])(?:\w+|operator\s*\S+?)\s*\(/.test(text) && !hasValue(text);
  if (call) return { kind: 'function', names: [functionName(text)].filter(Boolean) };
  if (/^[\w?\s]+:(?!:)/.test(text)) return { kind: 'variable', names: [/(\w+)\??\s*:/.exec(text)[1]] };
  return { kind: 'variable', names: parts(text).map(part => (/(\w+)\s*(?:\[.*\]\s*)?$/.exec(part.split(/(?<![=!<>])=|\{/)[0].trim()) ?? [])[1]).filter(Boolean) };
}

function named(list, ofEnum) {
  return list.map(item => {
    if (item.note) return item;
    const names = ofEnum ? { kind: 'enumerator', names: [/^\w*/.exec(item.code)[0]] } : namesIn(item.code, item.members);
    return { ...item, ...names, ...(item.members && { members: named(item.members, names.kind === 'enum') }) };
  });
}

/**
 * A list of { kind, names, code, doc, after, access, members, refused }, where doc are the lines before a declaration,
 * after those behind it, and refused says that who calls it is told to write something else; between them { note }, the
 * lines of other comments.
 */
export const declarationsIn = text => named(new Reader(text).block('public', false), false);
