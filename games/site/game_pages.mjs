// SPDX-License-Identifier: MIT
// The pages of the games: in the site, and each as one file to send and to open from disk.
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';

import { joined } from '../../kit/web/js/join.mjs';
import { gameInfoOf, loadGame } from '../shell/web/js/module.js';
import { fontFaces } from './fonts.mjs';
import { filled } from './template.mjs';

const scripts = ['module.js', 'keys.js', 'painter.js', 'sound.js', 'store.js', 'touch.js', 'panel.js', 'game.js'];

/** The bytes of a module in its page, packed: a page from disk may not fetch. */
function unpacked(wasm) {
  const packed = gzipSync(readFileSync(wasm), { level: 9 }).toString('base64');
  return `new Response(new Blob([Uint8Array.from(atob('${packed}'), letter => letter.charCodeAt(0))]).stream()` +
    `.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer()`;
}

/** The games of list.txt, with the title and the line about each that their modules tell. */
export async function gamesOf(root, modules) {
  const names = readFileSync(join(root, 'games/list.txt'), 'utf8').match(/^[a-z]\w*(?=:)/gm);
  return Promise.all(names.map(async name => {
    const game = await loadGame(readFileSync(join(modules, `${name}.wasm`)));
    const { title, about } = gameInfoOf(game.describe());
    return { name, title, about };
  }));
}

/** @param game as gamesOf() gives it */
export function writeGamePages({ root, modules, fonts, site }, game) {
  const shell = join(root, 'games/shell/web'), template = readFileSync(join(shell, 'game.html'), 'utf8');
  const style = readFileSync(join(shell, 'game.css'), 'utf8');
  const script = joined(join(shell, 'js'), scripts).replace(/^export /gm, '');
  const wasm = join(modules, `${game.name}.wasm`);
  const page = parts => filled(template, { ...game, script, ...parts });

  const folder = join(site, game.name);
  mkdirSync(folder, { recursive: true });
  copyFileSync(wasm, join(folder, `${game.name}.wasm`));
  writeFileSync(join(folder, 'index.html'), page({
    style: fontFaces(weight => `../fonts/${fonts[weight]}`) + style,
    home: '<a href="../">‹ Plumb</a>', homeLink: "'../'", source: `fetch('${game.name}.wasm')`,
  }));

  const inline = weight => `data:font/woff2;base64,${readFileSync(join(site, 'fonts', fonts[weight])).toString('base64')}`;
  mkdirSync(join(site, 'single'), { recursive: true });
  writeFileSync(join(site, 'single', `${game.name}.html`), page({
    style: fontFaces(inline) + style, home: '', homeLink: 'null', source: unpacked(wasm),
  }));
}
