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
  assert.match(bodyOf('World'), /Moves the world forward by dt, at most 1 \[s\]/);
});

test('a program with mistakes is refused, one without is not', () => {
  const start = "import { load } from 'plumb-physics';\nconst { World, box } = await load();\nconst world = new World();\n";
  assert.equal(check(`${start}const id = world.add({ shapes: [box([1, 1])] });\nconst [x] = world.body(id).position();\nworld.body(id).setVelocity([x, 0]);`), '');
  for (const [line, text] of [["world.add({ positon: [0, 0] });", 'positon'], ["world.add({ type: 'statik' });", 'statik'],
                              ["world.step('1');", 'number'], ["world.body(3);", 'BodyId'],
                              ["world.join({ revolute: {}, weld: {} , spring: {}});", 'spring']])
    assert.match(check(start + line), new RegExp(text), line);
});

const start = `import { load } from 'plumb-physics';
const { World, PlatformMover, box, circle } = await load();
const world = new World(), ball = world.add({ shapes: [circle(1)] });
const weld = world.join({ weld: { bodyB: ball } }), wind = world.addField({ law: { drag: { linear: 1 } } });
`;
const wrong = {
  'world.joint(ball);': /'BodyId' is not assignable to parameter of type 'JointId'/,
  'world.body(weld);': /'JointId' is not assignable to parameter of type 'BodyId'/,
  'world.shape(wind);': /'FieldId' is not assignable to parameter of type 'ShapeId'/,
  'world.field(ball.shape(0));': /'ShapeId' is not assignable to parameter of type 'FieldId'/,
  'world.join({ revolute: { bodyA: weld } });': /type 'JointId'.* type 'BodyId'/,
  'world.join({ revolute: { bodyB: ball }, weld: { bodyB: ball } });': /not assignable to parameter of type 'JointDef'/,
  'world.add({ shapes: [{ shape: { circle: { radius: 1 }, segment: {} } }] });': /not assignable to type 'undefined'/,
  'world.addField({ law: { drag: { linear: 1 }, pool: {} } });': /not assignable to type 'undefined'/,
  'world.add({ position: [1, 2, 3] });': /'number' is not assignable to type 'undefined'/,
  'world.add({ shapes: [{ circle: { radius: 1 } }] });': /'circle' does not exist in type 'ShapeDef'/,
  'world.body(ball).position = [0, 0];': /not assignable to type '\(\) => Vector'/,
  'world.gravity = [0, 0];': /not assignable to type '\(\) => Vector'/,
  'new PlatformMover(world, ball).profile = {};': /not assignable to type '\(\) => /,
  'world.body(ball).position()[0] = 1;': /'0' because it is a read-only property/,
  'world.body(ball).position().z;': /Property 'z' does not exist on type/,
  'world.body(ball).tag() & 1n;': /cannot be applied to types 'number \| bigint' and 'bigint'/,
};

test('each wrong program is refused, and for the reason it should be', () => {
  const lines = Object.keys(wrong), said = check(start + lines.join('\n'));
  const first = start.split('\n').length;
  for (const [i, line] of lines.entries()) {
    const here = [...said.matchAll(/\((\d+),\d+\): ([\s\S]*?)(?=\n\S|$)/g)].filter(match => Number(match[1]) === first + i);
    assert.ok(here.length > 0, `not refused: ${line}\n${said}`);
    assert.match(here.map(match => match[2]).join('\n'), wrong[line], line);
  }
});

test('what a program reads can be used, and given back', () => {
  assert.equal(check(`${start}
const body = world.body(ball), at = body.position(), [x, y] = at;
body.setPose({ x: at.x + 1, y: at[1] }, 0);
body.setPose(at, 0);
body.setVelocity([x, y]);
const drag = world.field(wind).def().law.drag;
if (drag) world.addField({ law: { drag: { ...drag, linear: drag.linear + drag.wind.x } } });
world.add({ shapes: [world.shape(ball.shape(0)).def()] });
world.join(world.joint(weld).def());
console.log(body.tag() === 5, world.shape(ball.shape(0)).filter().mask & 1n, ball.kind === 'BodyId');`), '');
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
