// SPDX-License-Identifier: MIT
// Do the types say what the module has? And do the programs of its page pass the strictest check?
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { folder, nodeModules, plumb } from './plumb.mjs';

const types = readFileSync(join(folder, 'plumb.d.ts'), 'utf8');
const bodyOf = name => new RegExp(`export interface ${name} \\{\\n([\\s\\S]*?)\\n\\}`).exec(types)[1];

function written(program) {
  const file = join(mkdtempSync(join(tmpdir(), 'plumb-types-')), 'program.mjs');
  writeFileSync(file, program.replaceAll("'plumb-physics'", `'${folder}/plumb.js'`));
  return file;
}

/** Checks one program, and returns what the compiler says. */
function check(program) {
  const compiler = join(nodeModules, 'typescript/bin/tsc');
  try {
    execFileSync(process.execPath, [compiler, '--strict', '--allowJs', '--checkJs', '--noEmit', '--target', 'es2022', '--module', 'nodenext',
      '--lib', 'es2022,dom', written(program)], { encoding: 'utf8' });
    return '';
  } catch (error) { return error.stdout; }
}

test('each function and class of the module has a type, and the other way round', () => {
  const declared = [...bodyOf('Plumb').matchAll(/^  (?:readonly )?(\w+)[:(]/gm)].map(match => match[1]);
  assert.deepEqual(new Set(declared), new Set([...Object.keys(plumb), 'BodyId', 'ShapeId', 'JointId', 'FieldId']
    .filter(name => !/Id$/.test(name))));
  for (const owner of ['World', 'Body', 'BodyShape', 'Joint', 'Field', 'GridMover', 'PlatformMover', 'PathMover', 'FixedClock'])
    for (const name of Object.getOwnPropertyNames(plumb[owner].prototype))
      if (!['constructor', 'address'].includes(name)) assert.match(bodyOf(owner), new RegExp(`^  ${name}\\(`, 'm'), `${owner}.${name}`);
});

test('units, defaults and meanings stand in the types', () => {
  assert.match(bodyOf('BodyDef'), /\/\*\* of the body's origin \[m\]; default \[0,0\] \*\/\n {2}position\?: Vec2;/);
  assert.match(bodyOf('Shot'), /\[m\/s\]/);
  assert.match(bodyOf('World'), /Moves the world forward by dt \[s\]/);
});

test('a program with mistakes is refused, one without is not', () => {
  const start = "import { load } from 'plumb-physics';\nconst { World, box } = await load();\nconst world = new World();\n";
  assert.equal(check(`${start}const id = world.add({ shapes: [box([1, 1])] });\nconst [x] = world.body(id).position();\nworld.body(id).setVelocity([x, 0]);`), '');
  for (const [line, text] of [["world.add({ positon: [0, 0] });", 'positon'], ["world.add({ type: 'statik' });", 'statik'],
                              ["world.step('1');", 'number'], ["world.body(3);", 'BodyId'],
                              ["world.join({ revolute: {}, weld: {} , spring: {}});", 'spring']])
    assert.match(check(start + line), new RegExp(text), line);
});

for (const [i, program] of programs().entries())
  test(`program ${i + 1} of the page passes the strictest check, and runs`, () => {
    assert.equal(check(program), '');
    assert.match(execFileSync(process.execPath, [written(program)], { encoding: 'utf8' }), /\S/, 'it prints nothing');
  });

function programs() {
  const page = readFileSync(join(folder, 'README.md'), 'utf8');
  return [...page.matchAll(/```js\n([\s\S]*?)```/g)].map(match => match[1]);
}
