// SPDX-License-Identifier: MIT
// Does a page that is opened from disk play, by keys, without an error? In Debian's Chromium.
import assert from 'node:assert/strict';
import { copyFileSync, mkdirSync } from 'node:fs';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { folder, plumb, root } from './plumb.mjs';
import { opened, served } from './site.mjs';

test('a breakout in one page, opened from disk, is played by keys', async () => {
  const place = `${root}build/web-pages`;
  mkdirSync(place, { recursive: true });
  copyFileSync(`${root}tests/web/breakout.html`, `${place}/breakout.html`);
  copyFileSync(`${folder}/plumb.inline.js`, `${place}/plumb.inline.js`);
  await opened(pathToFileURL(`${place}/breakout.html`).href, { viewport: { width: 720, height: 760 } }, async page => {
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
  await served(base => opened(`${base}README.md`, {}, async page => {  // any file of the package: the module is beside it
    const there = await page.evaluate(`import('/plumb.js').then(({ load }) => (${program})(load))`);
    assert.equal(there, await program(async () => plumb));
  }), folder);
});
