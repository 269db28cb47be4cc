// SPDX-License-Identifier: MIT
// The live page of the comparison: does it compute what the program computes, and can a person turn it?
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { opened, root, served, site } from './site.mjs';

const live = join(site, 'live');
const folder = mkdtempSync(join(tmpdir(), 'plumb-live-'));
process.on('exit', () => rmSync(folder, { recursive: true }));

/** What the program writes for these arguments of check. */
function checked(...args) {
  const file = join(folder, 'check.json');
  try {
    execFileSync(join(root, 'build/release/bin/plumb-compare'), ['check', ...args, '--json', file], { stdio: 'pipe' });
  } catch (error) {
    if (error.status !== 1) throw error;  // a check that fails is a result
  }
  return JSON.parse(readFileSync(file, 'utf8'));
}

/** Opens the page at an address while act(page) runs in it. */
const openedLive = (hash, act, options = {}) => served(base => opened(`${base}${hash}`, { viewport: { width: 1280, height: 900 }, ...options }, async page => {
  await page.waitForFunction(() => document.body.dataset.ready, null, { polling: 20 });
  await act(page, base);
}), live);

/** Waits until the run has ended and was judged. */
const judged = page => page.waitForFunction(() => !document.body.classList.contains('pending'), null, { polling: 20 });

/** Turns the open page to another scene, and waits for its run. */
async function turned(page, name) {
  await page.evaluate(hash => { location.hash = hash; }, `scene=${name}`);
  await page.waitForFunction(wanted => livePage.runs.data?.name === wanted && livePage.runs.isOver, name, { polling: 20 });
}

/** In the page: runs the open scene to its end, and gives what check --json would write of it. */
const verdictOf = (page, inDetail) => page.evaluate(detail => livePage.runs.verdict(detail), inDetail);

/** The engines that page and program share; Box2D 3.2 where the program was built with it. */
let shared, program;
before(() => {
  const has = Object.keys(checked('free_fall').scenes[0].engines);
  shared = ['plumb', 'box2d-3', 'closed-form'].filter(engine => has.includes(engine));
  program = checked('--engines', shared.join());
});

test('every scene of the list starts, runs, and ends with the bits of the program', () => openedLive('', async page => {
  const scenes = await page.evaluate(() => livePage.list.scenes.filter(({ bench }) => !bench).map(({ name }) => name));
  assert.deepEqual(scenes, program.scenes.map(({ name }) => name));
  for (const { name, engines } of program.scenes) {
    await turned(page, name);
    assert.equal((await verdictOf(page, false)).engines.plumb.hash, engines.plumb.hash, name);
  }
}));

/** Everything but times, and but what hangs on the last bits of Box2D's single precision. */
function compared(mine, theirs, path = '') {
  if (/ms_per_step$/.test(path)) return;
  if (typeof mine === 'number' && typeof theirs === 'number') {
    assert.ok(Math.abs(mine - theirs) <= 1e-6 + 1e-5 * Math.abs(theirs), `${path}: ${mine}, and ${theirs} in the program`);
  } else if (mine && theirs && typeof mine === 'object') {
    assert.deepEqual(Object.keys(mine), Object.keys(theirs), path);
    for (const key of Object.keys(mine)) compared(mine[key], theirs[key], `${path}.${key}`);
  } else assert.equal(mine, theirs, path);
}

const ten = ['free_fall', 'projectile', 'bounce_08', 'head_on_05', 'oblique_1', 'block_slides', 'slide_to_roll', 'pendulum_150',
  'spring_undamped', 'atwood_machine'];

test('ten scenes have the errors, partings, horizons and answers of the program', () => openedLive('', async page => {
  const theirs = checked(...ten, '--engines', shared.join()).scenes;
  for (const scene of theirs) {
    await turned(page, scene.name);
    compared(await verdictOf(page, true), scene, scene.name);
  }
}));

/** A slider of the panel, by what it sets and as which number. */
const slider = (set, as = 'number') => `.control[data-set="${set}"][data-as="${as}"] input[type="range"]`;
const box = (set, as = 'number') => `.control[data-set="${set}"][data-as="${as}"] input[type="number"]`;

async function typed(page, selector, value) {
  await page.fill(selector, String(value));
  await page.press(selector, 'Enter');
}

const turns = [
  ['free_fall', 'bodies.ball.position', 'y', 45], ['projectile', 'bodies.ball.velocity', 'direction', 70],
  ['projectile_damped', 'bodies.ball.linearDamping', 'number', 0.5], ['bounce_08', 'bodies.ball.restitution', 'number', 0.6],
  ['head_on_1', 'bodies.disc_a.mass', 'number', 5], ['oblique_1', 'bodies.disc_a.position', 'y', -0.2],
  ['block_slides', 'bodies.incline.angle', 'degreesDown', 40], ['pendulum_150', 'bodies.bob.position', 'hanging', 170],
  ['spring_undamped', 'joints.spring_of_weight.distance.spring.stiffness', 'number', 90], ['terminal_speed', 'gravity.1', 'downwards', 3.7],
];

/** The run of the page is the program's with --set, and the scene that it gives away is that one. */
async function isAsSet(page, name) {
  await judged(page);
  const changed = await page.evaluate(() => [...livePage.changed].map(([path, text]) => `${path}=${text}`));
  assert.ok(changed.length > 0, name);
  const mine = await verdictOf(page, true);
  const [theirs] = checked(name, ...changed.flatMap(text => ['--set', text]), '--engines', shared.join()).scenes;
  compared(mine, theirs, name);
  assert.equal(mine.engines.plumb.hash, theirs.engines.plumb.hash, name);
  assert.notEqual(mine.engines.plumb.hash, program.scenes.find(scene => scene.name === name).engines.plumb.hash, name);
  const file = join(folder, `${name}.json`);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#give-json')]);
  await download.saveAs(file);
  assert.equal(checked(file, '--engines', 'plumb').scenes[0].engines.plumb.hash, mine.engines.plumb.hash, `${name}, exported`);
}

test('ten scenes that a person changes by a box give what --set gives, and run as exported', () => openedLive('', async page => {
  for (const [name, set, as, value] of turns) {
    await turned(page, name);
    await judged(page);
    await typed(page, box(set, as), value);
    await isAsSet(page, name);
  }
}));

test('ten scenes that a person changes by the keys of a slider give what --set gives', () => openedLive('', async page => {
  for (const [name, set, as] of turns) {
    await turned(page, name);
    await judged(page);
    await page.focus(slider(set, as));
    for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowLeft']) await page.keyboard.press(key);
    await isAsSet(page, name);
  }
}));

test('an arrow key on a slider begins the run anew, with the whole path at once', () => openedLive('#scene=projectile', async page => {
  const range = () => page.evaluate(() => { const { poses, ticks } = livePage.scene.running[0]; return poses[3 * (ticks - 1)]; });
  await judged(page);
  const first = await range();
  await page.focus(slider('bodies.ball.velocity', 'size'));
  for (let i = 0; i < 10; ++i) await page.keyboard.press('ArrowRight');
  assert.ok(await range() > first + 0.5);
  assert.match(await page.textContent('#clock'), /^0\.000\ss$/);
  await page.click('#reset');
  assert.equal(await range(), first);
}));

/** The place of a body on the stage, of the page. */
const placeOf = (page, body) => page.evaluate(name => {
  const { view, player } = livePage.page, { scene, camera } = view;
  const index = scene.bodies.findIndex(each => each.name === name), engine = scene.running[0];
  const at = 3 * (player.frame * engine.bodies.length + engine.slots.get(index)), stage = document.querySelector('#stage').getBoundingClientRect();
  return [stage.left + camera.x(engine.poses[at]), stage.top + camera.y(engine.poses[at + 1]), camera.scale];
}, body);

/** Takes a body by the mouse and moves it by so many metres; lets go. */
async function dragged(page, body, dx, dy) {
  const [x, y, scale] = await placeOf(page, body);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx * scale, y - dy * scale, { steps: 6 });
  await page.mouse.up();
}

test('a body that is dragged while the scene stands is placed, and its address holds it', () => openedLive('#scene=projectile', async page => {
  await judged(page);
  await dragged(page, 'ball', 3, 2);
  await judged(page);
  const [{ position }] = JSON.parse(await page.evaluate(() => livePage.comparison.exported(true))).bodies;
  assert.ok(Math.hypot(position[0] - 3, position[1] - 2) < 0.1, position.join());
  assert.match(page.url(), /set=bodies\.ball\.position/);
  const mine = await verdictOf(page, false);
  const address = page.url();
  await page.goto('about:blank');
  await page.goto(address);
  await page.waitForFunction(() => document.body.dataset.ready, null, { polling: 20 });
  assert.equal((await verdictOf(page, false)).engines.plumb.hash, mine.engines.plumb.hash);
}));

const drags = [
  ['free_fall', 'ball', 1, 2], ['projectile', 'ball', 3, 2], ['projectile_damped', 'ball', 1, 1], ['bounce_08', 'ball', 0.5, 1],
  ['head_on_1', 'disc_a', -1, 0.2], ['oblique_1', 'disc_a', -0.5, 0.1], ['box_at_rest', 'box', 0.5, 1], ['pendulum_150', 'bob', 0.3, 0.2],
  ['stack_of_ten', 'box_10', 0.3, 0.4], ['dominoes', 'domino_1', -0.2, 0.1],
];

test('ten scenes in which a person drags a body give what --set gives', () => openedLive('', async page => {
  for (const [name, body, dx, dy] of drags) {
    await turned(page, name);
    await judged(page);
    await dragged(page, body, dx, dy);
    await isAsSet(page, name);
  }
}));

test('a body that is dragged while the scene plays is pulled in all engines alike', () => openedLive('#scene=box_at_rest&play=1', async page => {
  await page.waitForFunction(() => livePage.player.frame > 5, null, { polling: 20 });
  const [x, y, scale] = await placeOf(page, 'box');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 1.5 * scale, { steps: 10 });
  await page.waitForTimeout(700);
  const heights = () => page.evaluate(() => livePage.scene.running.filter(({ slots, pushesAt }) => pushesAt && slots.size > 0)
    .map(({ poses, ticks }) => poses[3 * (ticks - 1) + 1]));
  const up = await heights();
  assert.equal(up.length, shared.length - 1);  // a closed form cannot be pulled
  for (const height of up) assert.ok(height > 1.2, up.join());
  assert.ok(Math.abs(up[0] - up.at(-1)) < 0.1, up.join());
  await page.mouse.up();
  await judged(page);
  for (const height of await heights()) assert.ok(height < 0.6);
  assert.ok(await page.isVisible('#held'));
}));

test('Box2D 3.2 in the page stays within a micrometre of the one in the program for the first second', async test => {
  if (!shared.includes('box2d-3')) return test.skip('this build has no Box2D 3.2');
  await openedLive('', async page => {
    const names = ['projectile', 'stack_of_ten', 'pendulum_45', 'dominoes', 'oblique_08', 'bridge_under_load'];
    const csv = mkdtempSync(join(folder, 'csv-'));
    checked(...names, '--engines', 'box2d-3', '--csv', csv);
    for (const name of names) {
      const [head, ...rows] = readFileSync(join(csv, `${name}.box2d-3.csv`), 'utf8').trim().split('\n').map(line => line.split(','));
      await turned(page, name);
      const mine = await page.evaluate(() => {
        const { scene } = livePage, engine = scene.running.find(({ name }) => name === 'box2d-3');
        const last = Math.min(engine.ticks - 1, Math.round(1 / scene.dt));
        return { last, names: engine.bodies.map(body => scene.bodies[body].name), poses: [...engine.poses.slice(0, 3 * engine.bodies.length * (last + 1))] };
      });
      let farthest = 0;
      for (let tick = 0; tick <= mine.last; ++tick)
        mine.names.forEach((body, slot) => ['x', 'y'].forEach((axis, i) => {
          const theirs = Number(rows[tick][head.findIndex(title => title.startsWith(`${body}.${axis} `))]);
          farthest = Math.max(farthest, Math.abs(mine.poses[3 * (tick * mine.names.length + slot) + i] - theirs));
        }));
      assert.ok(farthest <= 1e-6, `${name}: ${farthest} m`);
    }
  });
});

test('the page as one file opens without a network, with the scene as it was changed', () => openedLive('#scene=projectile', async page => {
  await typed(page, box('gravity.1', 'downwards'), 1.62);
  await judged(page);
  const mine = await verdictOf(page, false);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#give-page')]);
  const file = join(folder, 'offline.html');
  await download.saveAs(file);
  await opened(`file://${file}`, {}, async offline => {
    await offline.waitForFunction(() => document.body.dataset.ready, null, { polling: 20 });
    assert.equal((await verdictOf(offline, false)).engines.plumb.hash, mine.engines.plumb.hash);
    for (const id of ['panel', 'look-closer', 'gifts']) assert.equal(await offline.locator(`#${id}`).count(), 1, id);
    assert.equal(await offline.textContent('#scene-changed'), 'Changed: gravity.1 = -1.62');
  });
}));

test('a scene from a file is read, and what is wrong with one is said', () => openedLive('', async page => {
  await page.setInputFiles('#take-json', { name: 'bad.json', mimeType: 'application/json', buffer: Buffer.from('{"name": "mine", "bodies": [{"name": "a", "shapes": [{"circle": {"radius": -1}}]}]}') });
  await page.waitForFunction(() => /radius: -1 is not positive/.test(document.querySelector('#file-refused').textContent), null, { polling: 20 });
  const scene = execFileSync(join(root, 'build/release/bin/plumb-compare'), ['export', 'bounce_1', '--set', 'duration=3']);
  await page.setInputFiles('#take-json', { name: 'good.json', mimeType: 'application/json', buffer: scene });
  await page.waitForFunction(() => livePage.runs.data?.name === 'bounce_1', null, { polling: 20 });
  // Its address holds the scene.
  const address = page.url(), mine = await verdictOf(page, false);
  assert.match(address, /#json=/);
  await page.goto('about:blank');
  await page.goto(address);
  await page.waitForFunction(() => document.body.dataset.ready, null, { polling: 20 });
  assert.equal((await verdictOf(page, false)).engines.plumb.hash, mine.engines.plumb.hash);
}));

test('an address that was cut, names no scene, or sets what is not there opens the page, and it says why', async () => {
  const told = async (page, id) => {
    await page.waitForFunction(wanted => document.querySelector(wanted).textContent, id, { polling: 20 });
    return page.textContent(id);
  };
  for (const [hash, fault] of [['#json=q1YqSk', /link was cut/], ['#json=%%%', /link was cut/], ['#scene=free_fal', /"free_fal": the nearest is free_fall/]])
    await openedLive(hash, async page => {
      assert.match(await told(page, '#file-refused'), fault);
      await turned(page, 'free_fall');
      assert.equal(await page.textContent('#refused'), '');
    });
  await openedLive('#scene=projectile&set=gravity.1=abc&set=gravity.1=-5&set=bodies.nobody.mass=3', async page => {
    assert.match(await told(page, '#refused'), /"abc" is not a number; .*"nobody" is not the name of one of them/);
    assert.equal(await page.evaluate(() => JSON.parse(livePage.comparison.exported(true)).gravity[1]), -5);
    await turned(page, 'free_fall');
    assert.equal(await page.textContent('#refused'), '');
  });
});

/** Runs look(name) at the menu and at two scenes of the open page. */
async function atMenuAndScenes(page, look) {
  await look('the menu');
  for (const name of ['block_slides', 'oblique_1']) {
    await turned(page, name);
    await judged(page);
    await look(name);
  }
}

test('neither the menu nor a scene has a fault that axe finds, light and dark, large and small', async () => {
  const axe = readFileSync(join(root, 'build/node/node_modules/axe-core/axe.min.js'), 'utf8');
  for (const [colorScheme, width, height] of [['light', 1280, 800], ['dark', 1280, 800], ['light', 390, 844], ['dark', 390, 844]])
    await openedLive('', async page => {
      await page.evaluate(script => (0, eval)(script), axe);  // the page itself may load no script
      await atMenuAndScenes(page, async name => {
        const faults = await page.evaluate(async () => (await axe.run(document, { resultTypes: ['violations'] })).violations
          .map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).slice(0, 4).join(', ')}`));
        assert.deepEqual(faults, [], `${colorScheme} ${width} ${name}`);
      });
    }, { colorScheme, viewport: { width, height }, bypassCSP: true });
});

test('no part of the page is wider than its window at four sizes', async () => {
  for (const [width, height] of [[390, 844], [820, 1180], [1280, 800], [1920, 1080]])
    await openedLive('', page => atMenuAndScenes(page, async name => {
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= width, `${name} at ${width}: ${wide}`);
    }), { viewport: { width, height } });
});

test('what is typed and is no number is refused, with the name of the control', () => openedLive('#scene=projectile', async page => {
  const speed = box('bodies.ball.velocity', 'size');
  await typed(page, speed, '');
  assert.equal(await page.textContent('#refused'), 'Speed: a number is wanted');
  await typed(page, speed, -3);
  assert.match(await page.textContent('#refused'), /^Speed: it is not negative/);
  await typed(page, speed, 0);
  await typed(page, speed, 12);
  const [{ velocity: [x, y] }] = JSON.parse(await page.evaluate(() => livePage.comparison.exported(true))).bodies;
  assert.ok(Math.abs(Math.hypot(x, y) - 12) < 1e-9 && Math.abs(x - y) < 1e-9, 'the direction is kept');
  assert.equal(await page.textContent('#refused'), '');
}));

test('the module and the page take no more than 1.5 MB, packed', () => {
  const packed = ['index.html', 'live.wasm'].map(name => gzipSync(readFileSync(join(live, name)), { level: 9 }).length);
  assert.ok(packed[0] + packed[1] <= 1.5e6, packed.join());
});
