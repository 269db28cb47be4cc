// SPDX-License-Identifier: MIT
// Writes the site: node write_site.mjs ROOT BUILD REPORT SITE. BUILD is the build folder of the preset web, REPORT the
// comparison's report.
import { copyFileSync, cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { writeDocs } from './docs.mjs';
import { fontFaces, writeFonts } from './fonts.mjs';
import { gamesOf, writeGamePages } from './game_pages.mjs';
import { escaped, filled } from './template.mjs';

const [root, build, report, site] = process.argv.slice(2);
const here = join(root, 'games/site');

rmSync(site, { recursive: true, force: true });
mkdirSync(site, { recursive: true });
const fonts = writeFonts(join(site, 'fonts'));
const games = await gamesOf(root, join(build, 'games/shell/web'));
for (const game of games) writeGamePages({ root, modules: join(build, 'games/shell/web'), fonts, site }, game);

cpSync(join(build, 'package'), join(site, 'module'), { recursive: true });
mkdirSync(join(site, 'report'));
copyFileSync(report, join(site, 'report/index.html'));
writeFileSync(join(site, 'site.css'), fontFaces(weight => `fonts/${fonts[weight]}`) + readFileSync(join(here, 'site.css'), 'utf8'));
writeDocs(root, site);

const cards = games.map(({ name, title, about }) => {
  const picture = join(root, 'games', name, 'picture.png');
  if (!existsSync(picture)) throw new Error(`${picture} is not there: a game's card shows it`);
  copyFileSync(picture, join(site, name, 'picture.png'));
  return `<a class="game" href="${name}/"><span class="picture"><img src="${name}/picture.png" alt="" width="960" height="540">` +
    `<span class="play">Play</span></span><strong>${title}</strong><span>${about}</span></a>`;
}).join('\n');
const singles = games.map(({ name, title }) => `<a href="single/${name}.html" download>${title}</a>`).join(', ');
const [, first] = /```js\n([^]*?)```/.exec(readFileSync(join(root, 'kit/web/README.md'), 'utf8'));
const program = escaped(first.trim().replace("'plumb-physics'", "'./module/plumb.js'"));
const nav = filled(readFileSync(join(here, 'nav.html'), 'utf8'), { up: '.', docs: 'docs' });
copyFileSync(join(here, 'front.js'), join(site, 'front.js'));
writeFileSync(join(site, 'index.html'), filled(readFileSync(join(here, 'front.html'), 'utf8'), { cards, singles, program, nav }));
