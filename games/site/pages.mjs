// SPDX-License-Identifier: MIT
// What do all pages of text share: the links on top, a list of contents, and names that the search finds?
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';

import { filled } from './template.mjs';

const plain = html => html.replace(/<[^>]*>/g, '').trim();

/** The links and the search on top of a page. @param up from the page to the site's folder */
export function navOf(root, up, searches = true) {
  const from = name => readFileSync(join(root, 'games/site', name), 'utf8').trim();
  return filled(from('nav.html'), { up, search: searches ? from('search.html') : '' });
}

/** A list of a page's headings, when there are enough of them to get lost. */
function contentsOf(body) {
  const headings = [...body.matchAll(/<h([23]) id="([^"]*)"[^>]*>(.*?)<\/h\1>/g)];
  if (headings.length < 3) return '';
  const items = headings.map(([, level, id, text]) => `<li class="level${level}"><a href="#${id}">${plain(text)}</a></li>`).join('\n');
  return `<details class="contents"><summary>On this page</summary>\n<ul>\n${items}\n</ul>\n</details>\n`;
}

export class Pages {
  constructor(root, site) {
    this.root = root;
    this.site = site;
    this.template = readFileSync(join(root, 'games/site/page.html'), 'utf8');
    this.found = [];
  }

  /** @param place in the site, as docs/kit/index.html */
  write(place, title, body) {
    const file = join(this.site, place), up = posix.relative(posix.dirname(place), '.') || '.';
    mkdirSync(dirname(file), { recursive: true });
    const contents = contentsOf(body);
    writeFileSync(file, filled(this.template, { title, body, contents, nav: navOf(this.root, up), up, kind: contents ? 'with-contents' : '' }));
  }

  /** Adds a name for the search. @param kind a word that tells what it is */
  add(name, kind, place) {
    this.found.push([name, kind, place]);
  }

  /** Adds a page's title and headings for the search. */
  addHeadings(place, title, body) {
    this.add(plain(title), 'page', place);
    for (const [, id, text] of body.matchAll(/<h[23] id="([^"]*)"[^>]*>(.*?)<\/h[23]>/g)) this.add(plain(text), `in ${plain(title)}`, `${place}#${id}`);
  }

  /** A script, not a file of data: a page that is opened from disk may load it. */
  writeIndex() {
    const rows = this.found.map(row => JSON.stringify(row)).join(',\n');
    writeFileSync(join(this.site, 'search_index.js'), `globalThis.searchIndex = [\n${rows}\n];\n`);
  }
}
