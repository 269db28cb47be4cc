// SPDX-License-Identifier: MIT
// Runs every engine on every scene, in turn, and writes the tables.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { gzipSync } from 'node:zlib';

import { engines, filesOf } from './engines.mjs';
import { scenes } from './scenes.mjs';

const { values } = parseArgs({ options: { readme: { type: 'string' }, node: { type: 'string', default: process.execPath },
                                          rounds: { type: 'string', default: '3' } } });
const measure = fileURLToPath(new URL('measure.mjs', import.meta.url));
const tooSlow = 300e3;  // a run that takes longer is told as such [ms]

function run(engine, scene) {
  try {
    return JSON.parse(execFileSync(values.node, ['--no-warnings', measure, engine, scene],
                                   { encoding: 'utf8', timeout: tooSlow, stdio: ['ignore', 'pipe', 'ignore'] }));
  } catch { return null; }
}

const short = ms => (ms < 1 ? ms.toFixed(3) : ms < 100 ? ms.toFixed(2) : ms.toFixed(0));
const best = runs => runs.filter(Boolean).sort((a, b) => a.median - b.median)[0] ?? null;

function measureAll() {
  const results = {};
  for (const scene in scenes) {
    const runs = Object.fromEntries(Object.keys(engines).map(name => [name, []]));
    for (let round = 0; round < Number(values.rounds); ++round)
      for (const engine in engines)
        if (round === 0 || runs[engine][0]) runs[engine].push(run(engine, scene));
    results[scene] = Object.fromEntries(Object.entries(runs).map(([name, all]) => [name, best(all)]));
    console.error(scene, Object.entries(results[scene]).map(([n, r]) => `${n} ${r ? short(r.median) : '-'}`).join(', '));
  }
  return results;
}

function tables(results) {
  const names = Object.keys(engines);
  const cell = r => (r ? `${short(r.median)} (${r.highest.toFixed(2)})` : 'over 5 min');
  const rows = Object.entries(results).map(([scene, r]) => `| ${scene} | ${names.map(n => cell(r[n])).join(' | ')} |`);
  const ratios = Object.values(results).map(r => r['box2d3-wasm'].median / r.plumb.median);
  const mean = Math.exp(ratios.reduce((sum, r) => sum + Math.log(r), 0) / ratios.length);
  const sizes = names.map(n => `${(filesOf[n].reduce((sum, file) => sum + gzipSync(readFileSync(file), { level: 9 }).length, 0) / 1000).toFixed(0)} KB`);
  const version = execFileSync(values.node, ['--version'], { encoding: 'utf8' }).trim();
  return [
    `| ms a step (highest body, m) | ${names.join(' | ')} |`, `|---|${names.map(() => '---').join('|')}|`, ...rows,
    `| size, gzip | ${sizes.join(' | ')} |`, '',
    `Node ${version}, one thread, best median of ${values.rounds} rounds in turn. Plumb is ${mean.toFixed(2)} times as fast as ` +
    `box2d3-wasm with SIMD (geometric mean; ${ratios.map(r => r.toFixed(2)).join(', ')} in the order of the rows).`,
  ].join('\n');
}

const text = tables(measureAll());
console.log(text);
if (values.readme) {
  const page = readFileSync(values.readme, 'utf8'), mark = /(<!-- browser: speed -->\n)[\s\S]*?(<!-- end -->)/;
  if (!mark.test(page)) throw new Error(`${values.readme}: there is no <!-- browser: speed --> in it`);
  writeFileSync(values.readme, page.replace(mark, (_, begin, end) => `${begin}\n${text}\n\n${end}`));
}
