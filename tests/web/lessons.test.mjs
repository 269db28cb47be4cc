// SPDX-License-Identifier: MIT
// Does each lesson go as a class needs it, with the kit's numbers, from a file without a network too?
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { opened, root, served } from './site.mjs';

const folder = join(root, 'compare/lesson/data');
const files = readdirSync(folder).filter(name => name.endsWith('.json')).sort();
const lessons = files.map(file => JSON.parse(readFileSync(join(folder, file), 'utf8')));
const axe = readFileSync(createRequire(join(root, 'build/node/node_modules/x.js')).resolve('axe-core'), 'utf8');
const scratch = mkdtempSync(join(tmpdir(), 'plumb-lessons-'));

/** What the command says of each lesson's run, by its name. */
const told = new Map();
before(() => {
  const json = join(scratch, 'told.json');
  execFileSync(join(root, 'build/release/bin/plumb-compare'), ['lesson', ...files.map(file => join(folder, file)), '--json', json]);
  for (const lesson of JSON.parse(readFileSync(json, 'utf8')).lessons) told.set(lesson.name, lesson);
});

const ready = page => page.waitForFunction(() => document.body.dataset.ready === 'yes', null, { polling: 30 });
const known = page => page.waitForFunction(() => document.body.dataset.known === 'yes' && lessonPage.isMeasured, null, { polling: 30 });

/** Opens a lesson while act(page) runs. */
const openedLesson = (address, name, act, options = {}) => opened(`${address}lessons/#lesson=${name}&lang=en`,
  { viewport: { width: 1280, height: 800 }, ...options }, async (page, context) => {
    await ready(page);
    await act(page, context);
  });

/** Opens these lessons one after the other on three pages, which mostly wait for pictures. */
const eachLesson = (address, chosen, act) => Promise.all([0, 1, 2].map(part => onePage(address, chosen.filter((_, i) => i % 3 === part), act)));
const onePage = (address, chosen, act) => openedLesson(address, chosen[0].name, async (page, context) => {
  for (const lesson of chosen) {
    await page.evaluate(name => { location.hash = `#lesson=${name}&lang=en`; }, lesson.name);
    await page.waitForFunction(name => lessonPage.scene && lessonPage.lesson.name === name, lesson.name, { polling: 30 });
    await act(page, lesson, context);
  }
});

/** Says something in the widget: far from the truth, or the truth. */
const predict = (page, isRight) => page.evaluate(right => {
  const { lesson, widget, scene, values } = lessonPage, { predict } = lesson;
  if (predict.number) {
    const { value } = values.truth(scene, predict.number.value);
    widget.set(right ? value : value + Math.max(1, Math.abs(value)));
  } else if (predict.choice) {
    const { options, right: holds } = predict.choice;
    widget.set(right ? holds : holds % options.length + 1);
  } else {
    const curve = lessonPage.curveOf(predict.curve.value), times = [...scene.times];
    const { low, high } = { low: Math.min(...curve), high: Math.max(...curve) };
    widget.set(lessonPage.widget.pad.points.map(([t]) => {
      const at = times.findIndex(time => time >= t - 1e-9);
      return [t, right ? curve[at] : high + low - curve[at] + 0.5 * (high - low)];
    }));
  }
}, isRight);

const toTheEnd = page => page.evaluate(() => { lessonPage.player.pause(); lessonPage.player.seek(lessonPage.player.end); });

test('each lesson is predicted wrong and right, run, paused, stepped back and exported, with the kit\'s numbers', { timeout: 900_000 }, async () => {
  await served(async address => {
    await eachLesson(address, lessons, async (page, lesson) => {
      const say = `${lesson.name}: `;
      await page.click('#run');
      assert.match(await page.textContent('#judged'), /Say first/, say);
      for (const isRight of [false, true]) {
        await predict(page, isRight);
        const at = await page.evaluate(() => { document.getElementById('run').click(); return document.body.dataset.known; });
        assert.equal(at, 'run', say);
        await page.waitForFunction(() => lessonPage.player.frame > 0, null, { polling: 30 });
        // A run of half a second may be over by now: then this button would start it anew.
        await page.evaluate(() => { if (lessonPage.player.playing) document.getElementById('play').click(); });
        const frame = await page.evaluate(() => lessonPage.player.frame);
        assert.ok(await page.evaluate(() => !lessonPage.player.playing), say);
        if (await page.evaluate(() => document.body.dataset.known) === 'run' && frame > 0) {
          await page.click('#step-back');
          assert.equal(await page.evaluate(() => lessonPage.player.frame), frame - 1, say);
        }
        await toTheEnd(page);
        await known(page);
        assert.equal(await page.getAttribute('#judged', 'data-right'), String(isRight), say + await page.textContent('#judged'));
        await page.click('#again');
      }
      if (lesson.predict.number?.tries) await page.click('#reset');
      await page.click('#show');
      await known(page);
      const numbers = told.get(lesson.name).numbers.map(({ query, value }) => [query, value]);
      const shown = await page.evaluate(queries => queries.map(query => lessonPage.values.truth(lessonPage.scene, query).value), numbers.map(([query]) => query));
      numbers.forEach(([query, value], i) => assert.ok(shown[i] === value || Math.abs(shown[i] - value) <= 1e-9 * Math.max(1, Math.abs(value)), `${say}${query}: ${shown[i]}, the command says ${value}`));
      assert.equal(await page.locator('#formula .refused').count(), 0, say);
      const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#files button').first().click()]);
      const csv = readFileSync(await download.path(), 'utf8').split('\n');
      assert.match(csv[0], /^t \[s\],/, say);
      assert.equal(csv.length, await page.evaluate(() => lessonPage.scene.times.length) + 2, say);
    });
  });
});

test('each worse engine is chosen by its box, runs, and says a sentence without a gap', { timeout: 600_000 }, async () => {
  await served(async address => {
    await eachLesson(address, lessons.filter(({ worse }) => worse?.length), async (page, lesson) => {
      await page.click('#show');
      await known(page);
      const built = await page.evaluate(() => [...lessonPage.list.engines, ...lessonPage.list.onDemand].map(({ name }) => name));
      for (const [i, each] of lesson.worse.entries()) {
        if (!built.includes(each.engine)) {
          assert.ok(/^box2d-3/.test(each.engine), `${lesson.name}: ${each.engine} is in each build`);
          assert.ok(await page.locator('#worse input').nth(i).isDisabled());
          assert.equal(await page.locator('#worse .says').nth(i).textContent(), 'This build does not have it.');
          continue;
        }
        await page.locator('#worse input').nth(i).check();
        await page.waitForFunction(at => document.querySelectorAll('#worse .says')[at].textContent, i, { polling: 30 });
        const says = await page.locator('#worse .says').nth(i).textContent();
        assert.ok(says.length > 20 && !says.includes('–') && !/[{}]/.test(says), `${lesson.name}, ${each.title}: ${says}`);
        await page.locator('#worse input').nth(i).uncheck();
        await known(page);
      }
    });
  });
});

test('the angle that is said is tried in the run, and one that the control does not take is refused', { timeout: 60_000 }, async () => {
  await served(async address => {
    await openedLesson(address, 'firing', async page => {
      const angle = page.locator('#controls .control', { hasText: 'Angle' }).locator('input[type="number"]');
      const hits = () => page.evaluate(() => lessonPage.values.of(lessonPage.scene.engines.find(({ name }) => name === 'plumb'), 'probe hits').value);
      for (const [said, hit] of [['36', 1], ['63.3', 1], ['50', 0]]) {
        await page.fill('#said', said);
        await page.click('#run');
        await toTheEnd(page);
        await known(page);
        assert.equal(await angle.inputValue(), said);
        assert.equal(await hits(), hit, said);
        await page.click('#again');
      }
      await page.fill('#said', '99');
      await page.click('#run');
      assert.equal(await page.textContent('#judged'), 'Angle: 99 is not between 5 and 85');
      assert.equal(await page.evaluate(() => document.body.dataset.known), 'no');
    });
  });
});

test('a lesson as one file, of 2 MB at most, opens from disk without a network and gives the same numbers', { timeout: 300_000 }, async () => {
  await served(async address => {
    for (const name of ['stone', 'firing', 'many_tests']) {
      const file = join(scratch, `${name}.html`);
      const numbersOf = page => page.evaluate(() => document.getElementById('numbers').innerText);
      let online;
      await openedLesson(address, name, async page => {
        await page.click('#show');
        await known(page);
        online = await numbersOf(page);
        const [download] = await Promise.all([page.waitForEvent('download'), page.click('#give-page')]);
        await download.saveAs(file);
      });
      assert.ok(statSync(file).size <= 2_000_000, `${name}: ${statSync(file).size} bytes`);
      await opened(pathToFileURL(file).href, { viewport: { width: 1280, height: 800 } }, async (page, context) => {
        await context.setOffline(true);
        await ready(page);
        await page.click('#show');
        await known(page);
        assert.equal(await numbersOf(page), online, name);
        assert.ok(online.length > 20);
      });
    }
  });
});

test('the keyboard alone predicts, runs, turns, steps and chooses, a curve too', { timeout: 120_000 }, async () => {
  await served(async address => {
    await openedLesson(address, 'stone', async page => {
      await page.focus('#said');
      await page.keyboard.type('5');
      await page.keyboard.press('Tab');
      assert.equal(await page.evaluate(() => document.activeElement.id), 'run');
      await page.keyboard.press('Enter');
      await toTheEnd(page);
      await known(page);
      assert.equal(await page.getAttribute('#judged', 'data-right'), 'true');
      await page.focus('#controls input[type="range"]');
      const at = await page.inputValue('#controls input[type="number"]');
      await page.keyboard.press('ArrowRight');
      assert.notEqual(await page.inputValue('#controls input[type="number"]'), at);
      await page.focus('#worse input');
      await page.keyboard.press('Space');
      await page.waitForFunction(() => document.querySelector('#worse .says').textContent);
    });
    const drawn = lessons.find(({ predict }) => predict.curve).name;
    await openedLesson(address, drawn, async page => {
      await page.focus('.curve-pad');
      for (const key of ['ArrowRight', 'ArrowUp', 'ArrowUp', 'ArrowRight', 'ArrowDown']) await page.keyboard.press(key);
      const points = await page.evaluate(() => lessonPage.widget.said());
      assert.ok(points[1][1] > points[0][1] && points[2][1] < points[0][1]);
      await page.focus('#run');
      await page.keyboard.press('Enter');
      assert.equal(await page.evaluate(() => document.body.dataset.known), 'run');
    });
  });
});

test('a question asks about the values that are turned to, before the run and after it', { timeout: 60_000 }, async () => {
  await served(address => openedLesson(address, 'firing', async page => {
    assert.match(await page.textContent('#question'), /20\sm\/s/);
    await page.locator('[data-as="size"] input[type="number"]').fill('25');
    await page.locator('[data-as="size"] input[type="number"]').press('Enter');
    await page.waitForFunction(() => /25\sm\/s/.test(document.getElementById('question').textContent), null, { timeout: 5000 });
    await page.click('#show');
    await known(page);
    assert.match(await page.textContent('#question'), /25\sm\/s/);
  }));
});

test('an engine that refuses its number is said, and the lesson goes on as it was', { timeout: 60_000 }, async () => {
  await served(address => opened(`${address}lessons/#lesson=bisection&set=${encodeURIComponent('bisection:solver.probes=99')}&lang=en`,
    { viewport: { width: 1280, height: 800 } }, async page => {
      await ready(page);
      assert.match(await page.textContent('#refused'), /bisection.solver.probes: 99 is not from 0 to 30/);
      await page.click('#show');
      await known(page);
      assert.match(await page.textContent('#numbers'), /0.4063/);
    }));
});

test('axe finds nothing in the list and in each kind of lesson, before and after the run, on light and dark', { timeout: 300_000 }, async () => {
  const faultsOf = async page => {
    await page.evaluate(axe);
    return page.evaluate(async () => (await axe.run()).violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`));
  };
  const kinds = ['number', 'choice', 'curve'].map(kind => lessons.find(({ predict }) => predict[kind]).name);
  await served(async address => {
    for (const colorScheme of ['light', 'dark']) {
      await opened(`${address}lessons/`, { colorScheme }, async page => {
        await ready(page);
        assert.deepEqual(await faultsOf(page), []);
      });
      for (const name of [...kinds, 'bounding', 'many_tests']) await openedLesson(address, name, async page => {
        assert.deepEqual(await faultsOf(page), [], name);
        await page.click('#show');
        await known(page);
        assert.deepEqual(await faultsOf(page), [], name);
      }, { colorScheme });
    }
  });
});

test('each slide from 7 to 27 has a lesson in the table, and each lesson of the folder stands there', { timeout: 60_000 }, async () => {
  const slides = JSON.parse(readFileSync(join(root, 'compare/lesson/slides.json'), 'utf8'));
  assert.deepEqual(slides.map(({ slide }) => slide), Array.from({ length: 21 }, (_, i) => i + 7));
  await served(address => opened(`${address}lessons/#lang=en`, {}, async page => {
    await ready(page);
    const rows = await page.evaluate(() => [...document.querySelectorAll('#menu tbody tr')].map(row => [Number(row.cells[0].textContent),
      [...row.querySelectorAll('a')].map(link => new URLSearchParams(link.getAttribute('href').slice(1)).get('lesson'))]));
    for (const [slide, names] of rows) {
      assert.ok(names.length > 0, `slide ${slide}`);
      assert.deepEqual([...names].sort(), lessons.filter(lesson => lesson.slides.includes(slide)).map(({ name }) => name).sort());
    }
    assert.equal(new Set(rows.flatMap(([, names]) => names)).size, files.length);
  }));
});

test('a table that is opened is an engine of its own; a wrong one is refused by line, and changes nothing', { timeout: 60_000 }, async () => {
  const good = join(scratch, 'throw.csv'), bad = join(scratch, 'bad.csv');
  // Explicit Euler by hand at ten steps a second: x + v h, then v - g h. After 2 s it is g h t / 2 = 1 m too high.
  const rows = ['t,x,y'];
  for (let i = 0, y = 0, v = 10; i <= 20; ++i, y += v * 0.1, v -= 1) rows.push(`${i / 10},0,${y}`);
  writeFileSync(good, rows.join('\n'));
  writeFileSync(bad, 't,x,y\n0,0,abc\n');
  await served(address => openedLesson(address, 'stone', async page => {
    await page.click('#show');
    await known(page);
    await page.setInputFiles('#take-csv', good);
    await page.waitForFunction(() => /Mine/.test(document.getElementById('numbers').textContent) && lessonPage.isMeasured);
    const far = await page.evaluate(() => lessonPage.scene.running.find(({ name }) => name === 'mine').metrics.error_max);
    assert.ok(Math.abs(far - 1) < 0.01, `${far} m`);
    await page.setInputFiles('#take-csv', bad);
    await page.waitForFunction(() => document.getElementById('csv-refused').textContent);
    assert.equal(await page.textContent('#csv-refused'), 'bad.csv:2: y: "abc" is not a number');
    assert.match(await page.textContent('#numbers'), /Mine/);
  }));
});

test('a lesson of one\'s own opens from its file, is in its link, and a wrong one says its line', { timeout: 60_000 }, async () => {
  const json = readFileSync(join(root, 'compare/lesson/example.json'), 'utf8');
  const good = join(scratch, 'dropped.json'), bad = join(scratch, 'wrong.json');
  writeFileSync(good, json);
  writeFileSync(bad, json.replace('drop of y of ball"', 'drop of z of ball"'));
  await served(address => opened(`${address}lessons/#lang=en`, { viewport: { width: 1280, height: 800 } }, async page => {
    await ready(page);
    await page.setInputFiles('#take-lesson', bad);
    await page.waitForFunction(() => document.getElementById('file-refused').textContent);
    assert.match(await page.textContent('#file-refused'), /^wrong\.json:9: predict.number.value: "z" is not the name of a value of a body/);
    await page.setInputFiles('#take-lesson', good);
    await page.waitForFunction(() => document.body.dataset.view === 'lesson');
    assert.match(await page.textContent('#question'), /^How far does it fall in 2\ss\?$/);
    await page.goto(page.url());
    await page.reload();
    await ready(page);
    assert.equal(await page.textContent('#lesson-title'), 'A dropped ball');
  }));
});

test('every text that lessons and their page say has a German one, and a German page says numbers with a comma', { timeout: 60_000 }, async () => {
  const words = JSON.parse(readFileSync(join(root, 'compare/lesson/words/de.json'), 'utf8'));
  const texts = new Set();
  for (const lesson of lessons) {
    for (const text of [lesson.title, lesson.about, lesson.question, lesson.because]) texts.add(text);
    for (const { label } of [...lesson.controls ?? [], ...lesson.charts ?? [], ...lesson.numbers ?? [], ...Object.values(lesson.predict)]) if (label) texts.add(label);
    for (const text of lesson.predict.choice?.options ?? []) texts.add(text);
    for (const line of lesson.formula ?? []) for (const [, words] of line.matchAll(/\\text\{([^}]*)\}/g)) if (/[A-Za-z]{2}/.test(words)) texts.add(words.trim());
    for (const { title, says } of lesson.worse ?? []) texts.add(title).add(says);
    for (const { ask, answer } of lesson.questions) texts.add(ask).add(answer);
  }
  const scripts = ['compare/web/lesson', 'compare/view/stage', 'compare/view/page'].flatMap(place => readdirSync(join(root, place))
    .filter(name => name.endsWith('.js')).map(name => readFileSync(join(root, place, name), 'utf8')));
  for (const script of scripts) for (const [, text] of script.matchAll(/\bsay(?:With)?\(\s*"((?:[^"\\]|\\.)*)"/g)) texts.add(text);
  for (const script of scripts) for (const [, text] of script.matchAll(/const [A-Z_]+ = "([^"]*\{0\}[^"]*)"/g)) texts.add(text);
  const html = readFileSync(join(root, 'compare/web/lesson/lesson.html'), 'utf8');
  for (const [, text] of html.matchAll(/data-say>([^<]+)</g)) texts.add(text.trim());
  for (const [, text] of html.matchAll(/aria-label="([^"]+)"/g)) texts.add(text);
  for (const { subject } of JSON.parse(readFileSync(join(root, 'compare/lesson/slides.json'), 'utf8'))) texts.add(subject);
  const missing = [...texts].filter(text => !(text in words) && text !== 'decimal point');
  assert.deepEqual(missing, []);
  const queries = text => [...text.matchAll(/\{[^{}]*\}/g)].map(([query]) => query).sort();
  for (const text of texts) if (words[text]) assert.deepEqual(queries(words[text]), queries(text), text);
  await served(address => opened(`${address}lessons/#lesson=stone&lang=de`, { viewport: { width: 1280, height: 800 } }, async page => {
    await ready(page);
    assert.equal(await page.getAttribute('html', 'lang'), 'de');
    assert.match(await page.textContent('#clock'), /^0,000/);
    assert.equal(await page.textContent('#run'), words.Run);
  }));
});

test('the first picture of a lesson is there within a second, and all graphs move at 60 pictures a second', { timeout: 120_000 }, async () => {
  await served(address => opened(`${address}lessons/`, { viewport: { width: 1280, height: 800 } }, async page => {
    await ready(page);
    const first = await page.evaluate(async () => {
      const from = performance.now();
      location.hash = '#lesson=stone&lang=en';
      while (document.body.dataset.view !== 'lesson') await new Promise(requestAnimationFrame);
      return performance.now() - from;
    });
    assert.ok(first < 1000, `${first} ms`);
    await page.click('#show');
    await known(page);
    const rate = await page.evaluate(async () => {
      lessonPage.player.repeat = true;
      lessonPage.player.play();
      for (let i = 0; i < 20; ++i) await new Promise(requestAnimationFrame);
      const from = performance.now();
      for (let i = 0; i < 120; ++i) await new Promise(requestAnimationFrame);
      return 120_000 / (performance.now() - from);
    });
    console.log(`first picture after ${first.toFixed(0)} ms, ${rate.toFixed(1)} pictures a second`);
    assert.ok(rate > 30, `${rate} pictures a second`);
  }));
});
