// SPDX-License-Identifier: MIT
// Can the games be played in Chromium, by keys and by touch, to the bits that they come to natively?
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { codesOf, keyName } from '../../games/shell/web/js/keys.js';
import { games, openedGame, root, served, site } from './site.mjs';

const folder = join(root, 'build/web-records');
mkdirSync(folder, { recursive: true });

/** A short round of each game. */
const rounds = { maze: ['--levels', '1'], artillery: ['--rival', 'weak'], runner: ['--from', '3'] };
const phone = { viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true };

function native(game, ...args) {
  return JSON.parse(execFileSync(join(root, `build/release/bin/plumb-${game}`), ['--headless', ...args], { encoding: 'utf8' }));
}

/** A round of the computer's, as a record: its head, its runs of ticks and actions, its hash. */
function roundOf(game, seed) {
  const file = join(folder, `${game}.native.record`);
  const { result } = native(game, '--player', 'computer', '--seed', String(seed), '--record', file, ...rounds[game]);
  const text = readFileSync(file, 'utf8'), lines = text.trim().split('\n');
  const runs = lines.filter(line => /^\d/.test(line)).map(line => line.split(' '))
    .map(([ticks, names]) => ({ ticks: Number(ticks), names: names === '-' ? [] : names.split('+') }));
  return { file, result, runs, head: lines.filter(line => /^(plumb|seed|option)/.test(line)).join('\n') + '\n',
           hash: /^end (\w+)$/m.exec(text)[1] };
}

/** Plays a round's runs in a page; hold(names) presses what its actions need, and lets go of the rest. */
async function play(page, { head, runs }, hold) {
  await page.evaluate(text => gamePage.game.begin(text), head);
  for (const { ticks, names } of runs) {
    await hold(names);
    await page.evaluate(count => pump(count), ticks);
  }
  await hold([]);
  return page.evaluate(() => ({ hash: gamePage.game.hash(), screen: gamePage.game.screen(), ticks: gamePage.game.ticks() }));
}

async function keysOn(page) {
  const keys = await page.evaluate(() => gamePage.info.actions.map(({ name, keys: [first] }) => [name, first]));
  const codes = Object.fromEntries(keys.map(([name, key]) => [name, codesOf[key][0]]));
  let down = new Set();
  return async names => {
    const wanted = new Set(names.map(name => codes[name]));
    for (const code of down) if (!wanted.has(code)) await page.keyboard.up(code);
    for (const code of wanted) if (!down.has(code)) await page.keyboard.down(code);
    down = wanted;
  };
}

/** Thumbs: one on the pad of directions, between two of them if need be, and one on each button. */
async function thumbsOn(page, context) {
  const session = await context.newCDPSession(page);
  const pads = await page.evaluate(() => Object.fromEntries(gamePage.info.actions.map(({ name, pads: list }) => [name, list[0]])));
  const middle = async selector => {
    const box = await page.locator(selector).boundingBox();
    return { x: box.x + box.width / 2, y: box.y + box.height / 2, reach: box.width / 3 };
  };
  const cross = await middle('.pad'), ways = [[-1, 0], [1, 0], [0, -1], [0, 1]], buttons = new Map();
  const pointsOf = async numbers => {
    const points = [], [x, y] = [0, 1].map(axis => numbers.filter(n => n < 4).reduce((sum, n) => sum + ways[n][axis], 0));
    if (x || y) points.push({ x: cross.x + x * cross.reach, y: cross.y + y * cross.reach, id: 1 });
    for (const number of numbers.filter(n => n >= 4)) {
      if (!buttons.has(number)) buttons.set(number, await middle(`.pad${number}`));
      points.push({ x: buttons.get(number).x, y: buttons.get(number).y, id: number });
    }
    return points;
  };
  const send = (type, touchPoints) => session.send('Input.dispatchTouchEvent', { type, touchPoints });
  let down = false;
  return async names => {
    if (down) await send('touchEnd', []);
    const points = await pointsOf([...new Set(names.map(name => pads[name]))]);
    down = points.length > 0;
    if (down) await send('touchStart', points);
  };
}

/** Saves the record by the panel, and replays it natively. */
async function replayNatively(page, game) {
  await page.evaluate(() => document.querySelector('dialog').showModal());
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('dialog .save')]);
  const file = join(folder, `${game}.page.record`);
  await download.saveAs(file);
  return native(game, '--replay', file);
}

/** In a page: how far its picture after so many ticks is from another: levels of 255, and the share of pixels that are off by 64. */
async function differenceFrom([base64, ticks]) {
  pump(ticks);
  gamePage.paint(1);
  const image = new Image();
  image.src = `data:image/png;base64,${base64}`;
  await image.decode();
  const { width, height } = gamePage.canvas, other = new OffscreenCanvas(width, height).getContext('2d');
  if (image.width !== width || image.height !== height) throw new Error(`${width} x ${height} pixels`);
  other.drawImage(image, 0, 0);
  const a = gamePage.canvas.getContext('2d').getImageData(0, 0, width, height).data, b = other.getImageData(0, 0, width, height).data;
  let sum = 0, far = 0;
  for (let i = 0; i < a.length; i += 4) {
    const most = Math.max(Math.abs(a[i] - b[i]), Math.abs(a[i + 1] - b[i + 1]), Math.abs(a[i + 2] - b[i + 2]));
    sum += most;
    far += most > 64;
  }
  return { mean: sum / (a.length / 4), far: far / (a.length / 4) };
}

for (const game of games) {
  test(`${game} is played by keys to the end of a round, and the record replays natively to the same bits`, () => served(async base => {
    const round = roundOf(game, 2);
    await openedGame(`${base}${game}/`, { stopped: true }, async page => {
      const told = await play(page, round, await keysOn(page));
      assert.deepEqual([told.screen, told.hash], ['over', round.hash]);
      const again = await replayNatively(page, game);
      assert.equal(again.ticks, told.ticks);
      assert.equal(again.result, round.result);
    });
  }));

  test(`${game} is played by touch to the end of a round, to the same bits`, () => served(async base => {
    const round = roundOf(game, 3);
    await openedGame(`${base}${game}/`, { stopped: true, ...phone }, async (page, context) => {
      const told = await play(page, round, await thumbsOn(page, context));
      assert.deepEqual([told.screen, told.hash], ['over', round.hash]);
    });
  }));

  test(`${game}: a record that was made natively is opened in the page, and replays to the same bits`, () => served(async base => {
    const round = roundOf(game, 4);
    await openedGame(`${base}${game}/`, { stopped: true }, async page => {
      await page.click('header .open');
      await page.setInputFiles('dialog .file', round.file);
      await page.waitForFunction(() => gamePage.game.isReplay(), null, { polling: 20 });
      await page.evaluate(count => pump(count), round.runs.reduce((sum, { ticks }) => sum + ticks, 1));
      assert.match(await page.textContent('#status'), /has ended as it was recorded/);
      assert.equal(await page.evaluate(() => gamePage.game.hash()), round.hash);
    });
  }));

  test(`${game} looks in the page as it does natively`, () => served(async base => {
    const round = roundOf(game, 5), at = 600, picture = join(folder, `${game}.png`);
    native(game, '--replay', round.file, '--ticks', String(at + 1), '--screenshot', picture, '--at', String(at), '--size', '640x360');
    await openedGame(`${base}${game}/`, { stopped: true }, async page => {
      await page.evaluate(text => gamePage.game.begin(text), readFileSync(round.file, 'utf8'));
      const { mean, far } = await page.evaluate(differenceFrom, [readFileSync(picture).toString('base64'), at]);
      assert.ok(mean < 2 && far < 0.02, `${game}: levels differ by ${mean}, ${far} of the pixels by a lot`);
    });
  }));

  test(`${game} as one file is opened from disk, and runs`, () =>
    openedGame(pathToFileURL(join(site, 'single', `${game}.html`)).href, {}, async page => {
      await page.waitForFunction(() => gamePage.game.ticks() > 60);
      await page.keyboard.press('Enter');
      await page.waitForFunction(() => gamePage.game.screen() === 'play');
    }));
}

test('a broken record, and one of another game, are refused with the line that is wrong', () => served(base =>
  openedGame(`${base}maze/`, {}, async page => {
    for (const [text, wanted] of [['plumb-record 1 runner\n', /first line/], ['plumb-record 1 maze\nx\n', /record:2: "x"/],
      ['plumb-record 1 maze\noption nope 3\n', /nope/]]) {
      const file = join(folder, 'broken.record');
      writeFileSync(file, text);
      await page.click('header .open');
      await page.setInputFiles('dialog .file', file);
      await page.waitForFunction(text => RegExp(text).test(document.querySelector('#status').textContent), wanted.source);
      const ticks = await page.evaluate(() => gamePage.game.ticks());
      await page.waitForFunction(before => gamePage.game.ticks() > before, ticks);  // and the game goes on
    }
  })));

test('a menu is chosen from by a click: an option changes to both sides, and Play begins', () => served(base =>
  openedGame(`${base}runner/`, { viewport: { width: 640, height: 400 } }, async page => {
    const click = async (x, y) => {  // in the units of the screen
      const box = await page.locator('canvas').boundingBox();
      const unit = Math.min(box.width / 640, box.height / 360);
      await page.mouse.click(box.x + box.width / 2 + (x - 320) * unit, box.y + box.height / 2 + (y - 180) * unit);
      await page.waitForTimeout(400);
    };
    const level = async () => /option from (\d)/.exec(await page.evaluate(() => gamePage.game.toKeep()))[1];
    await click(360, 160 + 2 * 26);
    assert.equal(await level(), '2');
    await click(280, 160 + 2 * 26);
    assert.equal(await level(), '1');
    await click(100, 160);
    assert.equal(await page.evaluate(() => gamePage.game.screen()), 'title');
    await click(320, 160);
    assert.equal(await page.evaluate(() => gamePage.game.screen()), 'play');
  })));

test('a page that is left pauses its game, and the record has the pause', () => served(base =>
  openedGame(`${base}artillery/`, {}, async page => {
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => gamePage.game.screen() === 'play');
    await page.evaluate(() => dispatchEvent(new Event('blur')));
    await page.waitForFunction(() => gamePage.game.screen() === 'pause');
    assert.match(await page.evaluate(() => gamePage.game.record()), /^1 pause$/m);
  })));

test('scores, options, keys and silence are there again when the page is opened again', () => served(base =>
  openedGame(`${base}runner/`, {}, async page => {
    await page.evaluate(() => {
      gamePage.store.write({ scores: [420, 70], options: { profile: '1985', from: '2' } });
      gamePage.keep = () => {};
      gamePage.mute();
    });
    await page.click('header .open');
    await page.locator('table.keys tr', { hasText: 'jump' }).locator('button').click();
    await page.keyboard.press('KeyU');
    await page.click('dialog .close');
    await page.reload();
    await page.waitForFunction(() => globalThis.gamePage);
    const kept = await page.evaluate(() => gamePage.game.toKeep());
    assert.match(kept, /score 420\nscore 70\n/);
    assert.match(kept, /option profile 1985/);
    assert.equal(await page.evaluate(() => gamePage.sound.on), false);
    const jump = () => page.evaluate(() => gamePage.own.find(({ name }) => name === 'jump').keys);
    assert.deepEqual((await jump()).map(keyName), ['U']);
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => gamePage.game.screen() === 'play');
    await page.keyboard.down('KeyU');
    await page.waitForFunction(() => /jump/.test(gamePage.game.record()));
    await page.click('header .open');
    await page.click('dialog .reset');
    assert.deepEqual((await jump()).map(keyName), ['Space', 'Z', 'K']);
  })));

test('best scores that another page of the game has kept since are not lost', () => served(base =>
  openedGame(`${base}maze/`, {}, async page => {
    await page.evaluate(() => {
      gamePage.store.write({ scores: [500, 20, 20] });  // by the other page
      gamePage.keep();
    });
    assert.deepEqual(await page.evaluate(() => gamePage.store.read().scores), [500, 20, 20]);
    await page.evaluate(() => gamePage.keep());
    assert.deepEqual(await page.evaluate(() => gamePage.store.read().scores), [500, 20, 20]);
  })));

test('what a browser refuses to keep lasts for a visit', () => served(base =>
  openedGame(`${base}maze/`, {}, async page => {
    const read = await page.evaluate(() => {
      Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); };
      gamePage.store.write({ scores: [30] });
      gamePage.mute();
      return gamePage.store.read();
    });
    assert.deepEqual([read.scores, read.sound], [[30], false]);
  })));

test('options of another version of a game do not keep it from starting', () => served(base =>
  openedGame(`${base}artillery/`, {}, async page => {
    await page.evaluate(() => gamePage.store.write({ options: { rival: 'ladder', gone: 'yes' } }));
    await page.evaluate(() => { gamePage.keep = () => {}; });
    await page.reload();
    await page.waitForFunction(() => globalThis.gamePage?.game.ticks() > 5);
  })));

test('a gamepad plays: its South button begins, its stick steers', () => served(base =>
  openedGame(`${base}maze/`, {}, async page => {
    const pad = (button, x) => page.evaluate(([pressed, axis]) => {
      const buttons = Array.from({ length: 16 }, (_, i) => ({ pressed: i === pressed }));
      navigator.getGamepads = () => [{ connected: true, buttons, axes: [axis, 0] }];
    }, [button, x]);
    await pad(0, 0);
    await page.waitForFunction(() => gamePage.game.screen() === 'play');
    await pad(-1, 0.9);
    await page.waitForFunction(() => /^\d+ right$/m.test(gamePage.game.record()));
  })));

test('a keyboard alone reaches the panel and comes back', () => served(base =>
  openedGame(`${base}runner/`, {}, async page => {
    const reached = () => page.evaluate(() => document.activeElement.matches('header .open'));
    for (let i = 0; i < 10 && !(await reached()); ++i) await page.keyboard.press('Tab');
    assert.ok(await reached());
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => gamePage.panel.isOpen());
    await page.keyboard.press('Escape');
    await page.waitForFunction(() => !gamePage.panel.isOpen());
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => gamePage.game.screen() === 'play');
  })));

test('a key that is pressed twice between two pictures counts twice', () => served(base =>
  openedGame(`${base}maze/`, { stopped: true }, async page => {
    for (let i = 0; i < 2; ++i) await page.keyboard.press('ArrowDown');
    await page.evaluate(() => pump(5));
    const presses = await page.evaluate(() => gamePage.game.record().match(/^1 down$/mg).length);
    assert.equal(presses, 2);
  })));

test('a touch that is shorter than a tick presses for one', () => served(base =>
  openedGame(`${base}maze/`, { stopped: true, ...phone }, async (page, context) => {
    const hold = await thumbsOn(page, context);
    await hold(['confirm']);
    await hold([]);
    await page.evaluate(() => pump(2));
    assert.equal(await page.evaluate(() => gamePage.game.screen()), 'play');
  })));

test('a game that was started by a key is heard', () => served(base =>
  openedGame(`${base}maze/`, {}, async page => {
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => gamePage.sound.context?.state === 'running' && gamePage.sound.next > 0.2);
  })));
