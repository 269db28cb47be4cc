// SPDX-License-Identifier: MIT
// The site: do its pages open, do its links lead somewhere, does a keyboard suffice, does nothing overlap?
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { request } from 'node:http';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { games, opened, openedGame, root, served, site } from './site.mjs';

const sizes = [[390, 844], [820, 1180], [1920, 1080], [844, 390], [320, 568]];
const touch = { hasTouch: true, isMobile: true };

function htmlFiles(folder = site) {
  return readdirSync(folder, { withFileTypes: true }).flatMap(entry => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? htmlFiles(path) : path.endsWith('.html') ? [path] : [];
  });
}

test('every link of every page leads to a file of the site, and to a heading that is there', () => {
  const pages = htmlFiles().filter(file => !/report|single/.test(file.slice(site.length)));
  assert.ok(pages.length > 20);
  let links = 0;
  for (const page of pages) {
    for (const [, link] of readFileSync(page, 'utf8').matchAll(/ (?:href|src)="([^"]*)"/g)) {
      if (/^(https?|data|mailto):/.test(link)) continue;
      const [target, anchor] = link.split('#');
      let file = target ? resolve(dirname(page), target) : page;
      if (existsSync(join(file, 'index.html'))) file = join(file, 'index.html');
      assert.ok(file.startsWith(site) && existsSync(file), `${page}: ${link}`);
      if (anchor) assert.ok(readFileSync(file, 'utf8').includes(` id="${anchor}"`), `${page}: ${link}`);
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
    for (let i = 0; i < 20 && !(await page.evaluate(() => document.activeElement.matches('a.game'))); ++i) await page.keyboard.press('Tab');
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
      for (const path of ['', 'docs/', 'docs/kit/', 'docs/kit/web/', 'docs/games/', 'docs/compare/', 'docs/kit/plumb/dynamics/joints.html']) {
        await page.goto(base + path);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= width, `${path || 'front page'} at ${width}: ${wide}`);
      }
    });
}));

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
