// SPDX-License-Identifier: MIT
// The pages of the repository, as pages of the site. A link to a source leads to a page with its text.
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { dirname, extname, join, posix, relative } from 'node:path';

import { coloured, languageOf, unescaped } from './code.mjs';
import { escaped } from './template.mjs';

const folders = ['kit', 'games', 'compare'];
const pictures = ['.png', '.svg', '.gif', '.webp'];

function pagesIn(root) {
  const found = ['README.md'];
  const walk = folder => {
    for (const entry of readdirSync(join(root, folder), { withFileTypes: true })) {
      const path = posix.join(folder, entry.name);
      if (entry.isDirectory()) walk(path);
      else if (extname(path) === '.md') found.push(path);
    }
  };
  folders.forEach(walk);
  return found;
}

/** Where a file of the repository is in the site, from docs on. */
function placeOf(path) {
  if (posix.basename(path) === 'README.md') return posix.join(posix.dirname(path), 'index.html');
  if (pictures.includes(extname(path))) return path;
  return path.replace(/\.md$/, '') + '.html';
}

/** A heading's name in links, as the pages have it: letters and digits in small, with - for spaces. */
const anchorOf = heading => heading.replace(/<[^>]*>/g, '').replace(/&\w+;/g, '').toLowerCase()
  .replace(/[^\p{L}\p{N}\s_-]/gu, '').replace(/\s/g, '-');

class Docs {
  constructor(pages, root, site) {
    this.pages = pages;
    this.root = root;
    this.folder = join(site, 'docs');
    this.sources = new Set();
  }

  page(path) {
    const html = execFileSync('cmark-gfm', ['--extension', 'table', '--extension', 'autolink', '--unsafe', join(this.root, path)],
      { encoding: 'utf8', maxBuffer: 1 << 26 });
    const body = html
      .replace(/<pre><code class="language-(\w+)">([^]*?)<\/code><\/pre>/g,
        (all, language, code) => `<pre><code>${coloured(unescaped(code), language)}</code></pre>`)
      .replace(/<h([1-6])>(.*?)<\/h\1>/g, (all, level, text) => `<h${level} id="${anchorOf(text)}">${text}</h${level}>`)
      .replace(/ (href|src)="([^"]*)"/g, (all, kind, link) => ` ${kind}="${this.linkFrom(path, link)}"`)
      .replace(/<table>/g, '<div class="wide"><table>').replace(/<\/table>/g, '</table></div>');
    const place = posix.join('docs', placeOf(path)), title = /<h1[^>]*>(.*?)<\/h1>/.exec(body)?.[1].replace(/<[^>]*>/g, '') ?? path;
    this.pages.write(place, title, body);
    this.pages.addHeadings(place, title, body);
  }

  /** A link of a page, in the site: to another page, a picture, or a source. */
  linkFrom(path, link) {
    if (/^(\w+:|#)/.test(link)) return link;
    const [target, anchor] = link.split('#');
    let to = posix.normalize(posix.join(posix.dirname(path), decodeURIComponent(target)));
    if (!existsSync(join(this.root, to))) throw new Error(`${path}: the link to ${link} leads nowhere`);
    if (statSync(join(this.root, to)).isDirectory()) to = posix.join(to, 'README.md');
    if (!existsSync(join(this.root, to))) return relative(dirname(placeOf(path)), '.') || '.';
    if (extname(to) !== '.md') this.sources.add(to);
    return posix.relative(posix.dirname(placeOf(path)), placeOf(to)) + (anchor ? `#${anchor}` : '');
  }

  source(path) {
    const from = join(this.root, path), to = join(this.folder, placeOf(path));
    mkdirSync(dirname(to), { recursive: true });
    if (pictures.includes(extname(path))) return copyFileSync(from, to);
    const text = readFileSync(from, 'utf8');
    this.pages.write(posix.join('docs', placeOf(path)), path,
      `<h1>${escaped(path)}</h1>\n<pre><code>${coloured(text, languageOf(path, text))}</code></pre>`);
  }
}

export function writeDocs(pages, root, site) {
  const docs = new Docs(pages, root, site);
  for (const path of pagesIn(root)) docs.page(path);
  for (const path of docs.sources) docs.source(path);
}
