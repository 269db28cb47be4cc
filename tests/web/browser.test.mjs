// SPDX-License-Identifier: MIT
// Does a page that is opened from disk play, by keys, without an error? In Debian's Chromium.
import assert from 'node:assert/strict';
import { copyFileSync, existsSync, mkdirSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { folder, nodeModules, plumb, root } from './plumb.mjs';

const { chromium } = createRequire(`${nodeModules}/x.js`)('playwright-core');
const args = ['--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-background-networking', '--disable-sync'];

async function withPage(act) {
  assert.ok(existsSync('/usr/bin/chromium'), 'Chromium is not installed');
  const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args });
  try {
    const page = await browser.newPage({ viewport: { width: 720, height: 760 } }), errors = [];
    page.on('pageerror', error => errors.push(error.message));
    page.on('console', message => message.type() === 'error' && errors.push(message.text()));
    await act(page);
    assert.deepEqual(errors, []);
  } finally { await browser.close(); }
}

test('a breakout in one page, opened from disk, is played by keys', async () => {
  const place = `${root}build/web-pages`;
  mkdirSync(place, { recursive: true });
  copyFileSync(`${root}tests/web/breakout.html`, `${place}/breakout.html`);
  copyFileSync(`${folder}/plumb.inline.js`, `${place}/plumb.inline.js`);
  await withPage(async page => {
    await page.goto(pathToFileURL(`${place}/breakout.html`).href);
    await page.waitForFunction(() => /of 50/.test(document.querySelector('#score').textContent));
    for (let i = 0; i < 12; ++i) {
      const key = i % 2 ? 'ArrowLeft' : 'ArrowRight';
      await page.keyboard.down(key);
      await page.waitForTimeout(300);
      await page.keyboard.up(key);
    }
    await page.waitForFunction(() => parseInt(document.querySelector('#score').textContent) > 0);
    await page.screenshot({ path: `${place}/breakout.png` });
  });
});

test('the module that is fetched comes to the same bits in the browser', async () => {
  const program = async load => {
    const { World, box, circle, stateHash } = await load();
    const world = new World();
    world.add({ type: 'static', shapes: [box([20, 0.5])] });
    for (let i = 0; i < 60; ++i)
      world.add({ position: [-8 + 1.1 * (i % 15), 2 + Math.floor(i / 15)], angle: i, shapes: [i % 2 ? circle(0.4) : box([0.4, 0.3])] });
    for (let i = 0; i < 300; ++i) world.step(1 / 60);
    return stateHash(world).toString(16);
  };
  const types = { js: 'text/javascript', wasm: 'application/wasm', html: 'text/html' };
  const server = createServer(async (request, response) => {
    const name = request.url === '/' ? 'index.html' : request.url.slice(1);
    response.setHeader('Content-Type', types[name.split('.').pop()] ?? 'text/plain');
    response.end(name === 'index.html' ? '<!doctype html><link rel="icon" href="data:,">' : await readFile(`${folder}/${name}`));
  });
  await new Promise(done => server.listen(0, '127.0.0.1', done));
  try {
    await withPage(async page => {
      await page.goto(`http://127.0.0.1:${server.address().port}/`);
      const there = await page.evaluate(`import('/plumb.js').then(({ load }) => (${program})(load))`);
      assert.equal(there, await program(async () => plumb));
    });
  } finally { server.close(); }
});
