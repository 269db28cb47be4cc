// SPDX-License-Identifier: MIT
// How does code stand in a page, in colours?
import { createRequire } from 'node:module';
import { basename, extname } from 'node:path';

import { escaped } from './template.mjs';

const packages = '/usr/share/nodejs/prismjs';
const require = createRequire(import.meta.url);
const prism = require(packages);
require(`${packages}/components/`)(['cpp', 'bash', 'cmake', 'python', 'json', 'yaml', 'ini', 'typescript', 'css']);

const languages = {
  h: 'cpp', cc: 'cpp', sh: 'bash', mjs: 'javascript', js: 'javascript', ts: 'typescript', py: 'python', yml: 'yaml', html: 'markup',
};

/** The language of a file, by its name; of a script without an ending, by its first line. */
export function languageOf(path, text) {
  if (basename(path) === 'CMakeLists.txt') return 'cmake';
  const ending = extname(path).slice(1);
  return ending ? languages[ending] ?? ending : /^#!.*\b(ba)?sh\b/.test(text) ? 'bash' : '';
}

/** @param language as it stands after ``` in a page, or as languageOf() gives it */
export function coloured(text, language) {
  const grammar = prism.languages[languages[language] ?? language];
  return grammar ? prism.highlight(text, grammar, language) : escaped(text);
}

/** A text that was escaped, as it was before. */
export const unescaped = html => html.replace(/&(amp|lt|gt|quot);/g, (all, name) => ({ amp: '&', lt: '<', gt: '>', quot: '"' })[name]);
