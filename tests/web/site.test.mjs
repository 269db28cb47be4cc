// SPDX-License-Identifier: MIT
// The site: do its pages open, do its links lead somewhere, does a keyboard suffice, does nothing overlap?
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { withNav } from '../../games/site/report.mjs';
import { games, opened, openedGame, root, served, site } from './site.mjs';

const sizes = [[390, 844], [820, 1180], [1920, 1080], [844, 390], [320, 568]];
const touch = { hasTouch: true, isMobile: true };

function htmlFiles(folder = site) {
  return readdirSync(folder, { withFileTypes: true }).flatMap(entry => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? htmlFiles(path) : path.endsWith('.html') ? [path] : [];
  });
}

const anchors = new Map();
/** The names that links to a page may have after #. */
function anchorsOf(file) {
  if (!anchors.has(file))
    anchors.set(file, new Set([...readFileSync(file, 'utf8').matchAll(/ id="([^"]*)"/g)].map(([, id]) => id.replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&amp;/g, '&'))));
  return anchors.get(file);
}

const textOf = path => readFileSync(join(site, path), 'utf8');

test('every link of every page leads to a file of the site, and to a heading that is there', () => {
  const pages = htmlFiles().filter(file => !/^\/?(report|single)\//.test(file.slice(site.length)));
  assert.ok(pages.length > 20);
  let links = 0;
  for (const page of pages) {
    for (const [, link] of readFileSync(page, 'utf8').matchAll(/ (?:href|src)="([^"]*)"/g)) {
      if (/^(https?|data|mailto):/.test(link)) continue;
      const [target, anchor] = link.split('#');
      let file = target ? resolve(dirname(page), target) : page;
      if (existsSync(join(file, 'index.html'))) file = join(file, 'index.html');
      assert.ok(file.startsWith(site) && existsSync(file), `${page}: ${link}`);
      // After # the live page has its state: which scene, and what was changed.
      if (anchor && !/^(live|lessons)\/$/.test(target)) assert.ok(anchorsOf(file).has(decodeURIComponent(anchor)), `${page}: ${link}`);
      ++links;
    }
  }
  assert.ok(links > 200);
});

test('a game\'s page with its module and fonts takes no more than 500 KB, packed; so does its one file', () => {
  for (const game of games) {
    const fonts = readdirSync(join(site, 'fonts')).map(name => join(site, 'fonts', name));
    const files = [join(site, game, 'index.html'), join(site, game, `${game}.wasm`), ...fonts];
    const packed = list => list.reduce((sum, file) => sum + gzipSync(readFileSync(file), { level: 9 }).length, 0);
    assert.ok(packed(files) <= 500e3, `${game}: ${packed(files)}`);
    assert.ok(packed([join(site, 'single', `${game}.html`)]) <= 500e3);
  }
});

test('on the front page a keyboard throws a box, and opens the first game', () => served(base =>
  opened(base, { viewport: { width: 1280, height: 900 } }, async page => {
    await page.waitForFunction(() => /28 boxes/.test(document.querySelector('#count').textContent));
    await page.focus('#world');
    await page.keyboard.press('Space');
    await page.waitForFunction(() => /29 boxes/.test(document.querySelector('#count').textContent));
    await page.evaluate(() => document.activeElement.blur());
    for (let i = 0; i < 40 && !(await page.evaluate(() => document.activeElement.matches('a.game'))); ++i) await page.keyboard.press('Tab');
    await Promise.all([page.waitForURL(/maze/), page.keyboard.press('Enter')]);
    await page.waitForFunction(() => globalThis.gamePage?.game.ticks() > 5);
  })));

test('on the front page a pull with the mouse throws a box the other way', () => served(base =>
  opened(base, { viewport: { width: 1280, height: 1400 } }, async page => {
    await page.waitForFunction(() => /28 boxes/.test(document.querySelector('#count').textContent));
    const box = await page.locator('#world').boundingBox();
    await page.mouse.move(box.x + 100, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + 40, box.y + box.height / 2 + 20, { steps: 4 });
    await page.mouse.up();
    await page.waitForFunction(() => /29 boxes/.test(document.querySelector('#count').textContent));
  })));

test('no page is wider than its window at five sizes, light and dark', () => served(async base => {
  for (const [width, height] of sizes)
    await opened(base, { viewport: { width, height }, colorScheme: width % 4 ? 'dark' : 'light' }, async page => {
      for (const path of ['', 'reference/', 'reference/dynamics.html', 'reference/javascript.html', 'docs/', 'docs/kit/', 'docs/kit/web/', 'docs/games/', 'docs/compare/', 'docs/kit/plumb/dynamics/joints.html', 'report/', 'live/', 'live/#scene=oblique_1', 'lessons/', 'lessons/#lesson=stone']) {
        await page.goto(base + path);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= width, `${path || 'front page'} at ${width}: ${wide}`);
      }
    });
}));

test('every class, struct and enumeration of a public header has an entry in the reference', () => {
  const kit = join(root, 'kit/plumb');
  let count = 0;
  for (const folder of readdirSync(kit, { withFileTypes: true }).filter(entry => entry.isDirectory()))
    for (const name of readdirSync(join(kit, folder.name)).filter(file => file.endsWith('.h'))) {
      // What stands in namespace plumb itself, at the start of a line.
      const [, plumb] = /^namespace plumb \{$([^]*?)^\}/m.exec(readFileSync(join(kit, folder.name, name), 'utf8')) ?? [, ''];
      for (const [, type] of plumb.matchAll(/^(?:struct|class|enum class) (\w+)[^;<]*?\{/gm)) {
        assert.ok(anchorsOf(join(site, 'reference', `${folder.name}.html`)).has(type), `${folder.name}/${name}: ${type}`);
        ++count;
      }
    }
  assert.ok(count > 100, `${count} types`);
});

test('the reference tells of the classes that programs use most, with members, units and the line to include', () => {
  const wanted = {
    dynamics: ['World', 'World.add', 'World.castRay', 'Body', 'Body.setVelocity', 'BodyView.position', 'Joint', 'BodyDef', 'BodyDef.position',
      'RevoluteJointDef', 'RevoluteJointDef.maxMotorTorque', 'Limit.lower', 'Limit.upper', 'WheelJointDef', 'GearJointDef', 'JointDef'],
    space: ['ShapeDef'], stepping: ['FixedClock', 'FixedClock.advance'], record: ['forecast', 'Forecast.poses'],
    movers: ['GridMover', 'GridMover.want', 'PlatformMover', 'PathMover', 'PathMover.at'], kinematics: ['solveMotion'],
    javascript: ['World', 'World.castRay', 'BodyDef', 'BodyDef.position', 'GridMover', 'PlatformMover', 'PathMover', 'FixedClock'],
  };
  for (const [page, names] of Object.entries(wanted)) {
    const ids = anchorsOf(join(site, 'reference', `${page}.html`));
    for (const name of names) assert.ok(ids.has(name), `${page}: ${name}`);
  }
  const dynamics = textOf('reference/dynamics.html'), plain = dynamics.replace(/<[^>]*>/g, '');
  assert.match(plain, /#include &lt;plumb\/dynamics\/world\.h/);
  assert.match(plain, /double maxMotorTorque = 0the motor's greatest torque, &gt;= 0, may be infinite; 0: no motor \[N m\]/);
  assert.match(dynamics, /<span class="unit">\[N m\]<\/span>/);
  assert.doesNotMatch(plain, /WorldState\* world_|step_\b|EmptyBraces|Tests?: &quot;|SPDX/);
});

/** Writes into the search of a page, and gives the lines that it shows. */
async function searched(page, text) {
  await page.fill('.search input', text);
  await page.waitForFunction(() => document.querySelector('.search ul li'));
  return page.$$eval('.search li a', all => all.map(one => one.textContent));
}

test('the search finds a member, a class and a heading, and a keyboard leads there', () => served(base =>
  opened(`${base}docs/kit/`, { viewport: { width: 1280, height: 900 } }, async page => {
    assert.deepEqual((await searched(page, 'castRay')).slice(0, 3).sort(), ['World.castRay C++', 'World.castRay JavaScript', 'castRay C++']);
    assert.match((await searched(page, 'gridmover'))[0], /^GridMover /);
    assert.match((await searched(page, 'easily got wrong'))[0], /^What is easily got wrong in /);
    await page.fill('.search input', 'World.castRayAll');
    await page.waitForFunction(() => /castRayAll C/.test(document.querySelector('.search ul li')?.textContent));
    await page.keyboard.press('ArrowDown');
    await Promise.all([page.waitForURL(/reference\/\w+\.html#World\.castRayAll$/), page.keyboard.press('Enter')]);
    assert.ok(await page.evaluate(() => document.querySelector(':target').getBoundingClientRect().top < innerHeight));
  })));

test('code has colours that can be read, light and dark, and 120 letters of it fit at 1280 px', () => served(async base => {
  for (const colorScheme of ['light', 'dark'])
    await opened(`${base}docs/kit/web/`, { viewport: { width: 1280, height: 900 }, colorScheme }, async page => {
      const colours = await page.$$eval('pre .token', all => [...new Set(all.map(one => getComputedStyle(one).color))]);
      assert.ok(colours.length >= 5, colours.join());
      const contrasts = await page.evaluate(list => {
        const light = colour => colour.match(/[\d.]+/g).slice(0, 3).map(v => v / 255).map(v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
          .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
        const back = light(getComputedStyle(document.querySelector('pre')).backgroundColor);
        return list.map(colour => (Math.max(light(colour), back) + 0.05) / (Math.min(light(colour), back) + 0.05));
      }, colours);
      contrasts.forEach((contrast, i) => assert.ok(contrast >= 4.5, `${colorScheme}: ${colours[i]} has a contrast of ${contrast}`));
      const fits = await page.evaluate(() => {
        const pre = document.querySelector('article pre');
        pre.firstChild.textContent = 'x'.repeat(120);
        return pre.scrollWidth <= pre.clientWidth;
      });
      assert.ok(fits);
    });
}));

test('a long page has a list of its contents: beside it, and on a phone on top and folded', () => served(async base => {
  for (const path of ['docs/kit/', 'docs/kit/web/', 'reference/dynamics.html', 'reference/javascript.html'])
    for (const [width, height] of [[1280, 900], [390, 844]])
      await opened(base + path, { viewport: { width, height } }, async page => {
        const { open, links, list, text } = await page.evaluate(() => {
          const box = selector => document.querySelector(selector).getBoundingClientRect().toJSON();
          return { open: document.querySelector('.contents').open, links: document.querySelectorAll('.contents a').length, list: box('.contents'), text: box('article') };
        });
        assert.equal(open, width === 1280, `${path} at ${width}`);
        assert.ok(links >= 3 && (open ? list.right < text.left : list.bottom <= text.top && list.height < 60), `${path} at ${width}`);
      });
}));

test('the module is there as one file, and a program can use what npm installs of it', () => {
  const [file] = readdirSync(join(site, 'download')), front = textOf('index.html');
  assert.match(file, /^plumb-physics-\d+\.\d+\.\d+\.tgz$/);
  assert.ok(front.includes(`href="download/${file}"`) && front.replace(/<[^>]*>/g, '').includes(`npm install ./${file}`));
  const folder = mkdtempSync(join(tmpdir(), 'plumb-'));
  try {
    writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
    execFileSync('npm', ['install', '--offline', '--no-audit', '--no-fund', '--silent', join(site, 'download', file)], { cwd: folder });
    writeFileSync(join(folder, 'x.js'), "import { load } from 'plumb-physics';\nconst { World } = await load();\nconsole.log(new World().bodies().length);\n");
    assert.equal(execFileSync('node', ['x.js'], { cwd: folder, encoding: 'utf8' }).trim(), '0');
    for (const name of ['plumb.d.ts', 'README.md', 'LICENSE']) assert.ok(existsSync(join(folder, 'node_modules/plumb-physics', name)), name);
  } finally { rmSync(folder, { recursive: true }); }
});

test('the report has the links of the site on top, and its own page takes them', () => served(base =>
  opened(`${base}report/`, { viewport: { width: 390, height: 844 } }, async page => {
    const template = withNav(root, readFileSync(join(root, 'compare/report/page/page.html'), 'utf8'));
    assert.match(template, /<body data-view="">\s*<nav class="site-nav"[^]*<noscript>/);
    assert.ok(template.indexOf('.site-nav {') < template.indexOf('</head>'));
    const nav = await page.locator('.site-nav').boundingBox();
    assert.ok(nav.y === 0 && nav.width === 390 && nav.height < 60, JSON.stringify(nav));
    await Promise.all([page.waitForURL(base), page.click('.site-nav .home')]);
  })));

/** The boxes on the page of what the selector finds and shows. */
const boxesOf = (page, selector) => page.$$eval(selector, all => all.map(one => one.getBoundingClientRect())
  .filter(({ width }) => width > 0).map(({ left, right, top, bottom }) => ({ left, right, top, bottom })));
const meet = (a, b) => a.left < b.right - 0.5 && b.left < a.right - 0.5 && a.top < b.bottom - 0.5 && b.top < a.bottom - 0.5;

test('on a phone or tablet, upright and turned, no control covers the picture or another, and all are large enough', () => served(async base => {
  for (const game of games)
    await openedGame(`${base}${game}/`, { viewport: { width: 390, height: 844 }, ...touch }, async page => {
      for (const [width, height] of sizes) {
        await page.setViewportSize({ width, height });
        await page.waitForFunction(([w, h]) => innerWidth === w && innerHeight === h, [width, height]);
        await page.waitForTimeout(100);
        const [picture] = await boxesOf(page, 'canvas');
        const controls = await boxesOf(page, '.pad, .button:not(label), header button');
        assert.ok(controls.length >= 6, `${game} at ${width} x ${height}: ${controls.length}`);
        controls.forEach((control, i) => {
          const told = `${game} at ${width} x ${height}: ${JSON.stringify(control)}`;
          assert.ok(!meet(control, picture), `${told} covers the picture`);
          assert.ok(control.left >= 0 && control.top >= 0 && control.right <= width && control.bottom <= height, `${told} is cut off`);
          assert.ok(control.right - control.left >= 40 && control.bottom - control.top >= 40, `${told} is small`);
          controls.slice(i + 1).forEach(other => assert.ok(!meet(control, other), `${told} meets ${JSON.stringify(other)}`));
        });
        const area = (picture.right - picture.left) * (picture.bottom - picture.top);
        assert.ok(area >= 0.4 * width * height, `${game} at ${width} x ${height}: the picture is small`);
      }
    });
}));

/** The parts of the picture's width at which a row of pixels first and last differs from its edge. */
const drawnWidth = (page, at) => page.evaluate(at => {
  const canvas = document.querySelector('canvas'), { width, height } = canvas;
  const row = canvas.getContext('2d').getImageData(0, Math.round(at * height), width, 1).data;
  const differs = [...Array(width).keys()].filter(x => [0, 1, 2].some(i => Math.abs(row[4 * x + i] - row[i]) > 8));
  return [differs[0] / width, differs.at(-1) / width];
}, at);

test('on an upright phone each game is as wide as the display, and nobody is asked to turn it', () => served(async base => {
  for (const game of games)
    await openedGame(`${base}${game}/`, { viewport: { width: 390, height: 844 }, stopped: true, ...touch }, async page => {
      assert.equal(await page.textContent('#status'), '', game);
      for (const press of ['press', 'release', 'press', 'release']) await page.evaluate(what => { gamePage.devices[what]('Enter'); pump(30); }, press);
      assert.equal(await page.evaluate(() => gamePage.game.screen()), 'play', game);
      await page.evaluate(() => pump(60));
      const [left, right] = await drawnWidth(page, game === 'maze' ? 0.3 : 0.05);  // the maze, or the displays above the others
      assert.ok(left < 0.05 && right > 0.95, `${game}: ${left} to ${right}`);
    });
}));

test('the picture has the pixels of the display, also after the window was turned', () => served(base =>
  openedGame(`${base}runner/`, { viewport: { width: 500, height: 700 }, deviceScaleFactor: 2 }, async page => {
    for (const [width, height] of [[500, 700], [700, 500]]) {
      await page.setViewportSize({ width, height });
      await page.waitForFunction(([w, h]) => {
        const canvas = document.querySelector('canvas');
        return canvas.width === 2 * w && canvas.height === 2 * canvas.clientHeight && canvas.clientHeight > h - 60;
      }, [width, height]);
    }
  })));

test('the server answers for the files of the site alone, and to this machine alone', async () => {
  const server = spawn('python3', [join(root, 'games/site/serve.py'), site, '8400']);
  try {
    const said = await new Promise(done => server.stdout.once('data', data => done(String(data))));
    const port = Number(/^http:\/\/127\.0\.0\.1:(\d+)\//.exec(said)[1]);
    const status = (path, host = '127.0.0.1') => new Promise((done, failed) => request({ port, path, host }, response => {
      response.resume();
      done(response.statusCode);
    }).on('error', failed).end());
    assert.equal(await status('/'), 200);
    assert.equal(await status('/maze/maze.wasm'), 200);
    await assert.rejects(status('/', '127.0.0.2'), /ECONNREFUSED/);
    for (const path of ['/../CMakeCache.txt', '/..%2fCMakeCache.txt', '/%2e%2e/CMakeCache.txt']) assert.equal(await status(path), 404);
  } finally { server.kill(); }
});
