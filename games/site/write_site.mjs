// SPDX-License-Identifier: MIT
// Writes the site: node write_site.mjs ROOT BUILD REPORT SITE. BUILD is the build folder of the preset web, REPORT the
// comparison's report.
import { copyFileSync, cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { coloured } from './code.mjs';
import { writeDocs } from './docs.mjs';
import { fontFaces, writeFonts } from './fonts.mjs';
import { gamesOf, writeGamePages } from './game_pages.mjs';
import { writePackage } from './package.mjs';
import { navOf, Pages } from './pages.mjs';
import { writeReference } from './reference.mjs';
import { withNav } from './report.mjs';
import { filled } from './template.mjs';

const [root, build, report, site] = process.argv.slice(2);
const here = join(root, 'games/site');

rmSync(site, { recursive: true, force: true });
mkdirSync(site, { recursive: true });
const fonts = writeFonts(join(site, 'fonts'));
const games = await gamesOf(root, join(build, 'games/shell/web'));
for (const game of games) writeGamePages({ root, modules: join(build, 'games/shell/web'), fonts, site }, game);

cpSync(join(build, 'package'), join(site, 'module'), { recursive: true });
mkdirSync(join(site, 'report'));
writeFileSync(join(site, 'report/index.html'), withNav(root, readFileSync(report, 'utf8')));
mkdirSync(join(site, 'live'));
writeFileSync(join(site, 'live/index.html'), withNav(root, readFileSync(join(build, 'live/index.html'), 'utf8')));
copyFileSync(join(build, 'live/live.wasm'), join(site, 'live/live.wasm'));
mkdirSync(join(site, 'lessons'));
writeFileSync(join(site, 'lessons/index.html'), withNav(root, readFileSync(join(build, 'lessons/index.html'), 'utf8')));
writeFileSync(join(site, 'site.css'), fontFaces(weight => `fonts/${fonts[weight]}`) + readFileSync(join(here, 'site.css'), 'utf8'));
copyFileSync(join(here, 'page.js'), join(site, 'page.js'));
const pages = new Pages(root, site);
writeDocs(pages, root, site);
writeReference(pages, root, join(build, 'package/plumb.d.ts'));
pages.writeIndex();

const cards = games.map(({ name, title, about }) => {
  const picture = join(root, 'games', name, 'picture.png');
  if (!existsSync(picture)) throw new Error(`${picture} is not there: a game's card shows it`);
  copyFileSync(picture, join(site, name, 'picture.png'));
  return `<a class="game" href="${name}/"><span class="picture"><img src="${name}/picture.png" alt="" width="960" height="540">` +
    `<span class="play">Play</span></span><strong>${title}</strong><span>${about}</span></a>`;
}).join('\n');
const singles = games.map(({ name, title }) => `<a href="single/${name}.html" download>${title}</a>`).join(', ');
const [, first] = /```js\n([^]*?)```/.exec(readFileSync(join(root, 'kit/web/README.md'), 'utf8'));
const program = coloured(first.trim().replace("'plumb-physics'", "'./module/plumb.js'"), 'js');
const file = writePackage(join(build, 'package'), site);
const example = (text, language) => `<pre><code>${coloured(text, language)}</code></pre>`;
const install = example(`npm install ./${file}`, 'sh');
const script = example('<script src="plumb.inline.js"></script>\n<script type="module">\n  const { World } = await plumb.load();\n</script>', 'html');
const cmake = example('add_subdirectory(plumb)\ntarget_link_libraries(game PRIVATE plumb::plumb)', 'cmake');
copyFileSync(join(here, 'front.js'), join(site, 'front.js'));
writeFileSync(join(site, 'index.html'), filled(readFileSync(join(here, 'front.html'), 'utf8'), { cards, singles, program, file, install, script, cmake, nav: navOf(root, '.') }));
