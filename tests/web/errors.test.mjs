// SPDX-License-Identifier: MIT
// Is what is wrong refused with an Error that says where and what, and is the world as it was?
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { folder, plumb } from './plumb.mjs';

const { World, box, circle } = plumb;

const refusals = {
  'BodyDef.position: (nan, 0) is not finite': w => w.add({ position: [NaN, 0], shapes: [circle(0.5)] }),
  'BodyDef.positon: a BodyDef has no such member; did you mean position?': w => w.add({ positon: [0, 0] }),
  'BodyDef.position: "left" is not [x, y]': w => w.add({ position: 'left' }),
  'BodyDef.position: [1] is not [x, y]': w => w.add({ position: [1] }),
  'BodyDef.position: [1, 2, 3] is not [x, y]': w => w.add({ position: [1, 2, 3] }),
  'World.castRay: to: [1, 2, 3] is not [x, y]': w => w.castRay([0, 0], [1, 2, 3]),
  'BodyDef.shapes[0].circle: a ShapeDef has no such member; shape: { circle: ... } was meant':
    w => w.add({ shapes: [{ circle: { radius: 0.5 } }] }),
  'BodyDef.shapes[0].capsule: a ShapeDef has no such member; shape: { capsule: ... } was meant':
    w => w.add({ shapes: [{ capsule: { radius: 0.5 } }] }),
  'BodyDef.shapes[0].box: a ShapeDef has no such member; call box(...), which makes a ShapeDef':
    w => w.add({ shapes: [{ box: [1, 1] }] }),
  'BodyDef.shapes[0].friction: a ShapeDef has no such member; material: { friction: ... } was meant':
    w => w.add({ shapes: [{ ...box([1, 1]), friction: 1 }] }),
  "BodyDef.friction: a BodyDef has no such member; a shape's material has it: circle(radius, { friction: ... })":
    w => w.add({ friction: 1 }),
  "BodyDef.restitution: a BodyDef has no such member; a shape's material has it: circle(radius, { restitution: ... })":
    w => w.add({ restitution: 1 }),
  'BodyDef.sensor: a BodyDef has no such member; shapes: [{ sensor: ... }] was meant': w => w.add({ sensor: true }),
  'BodyDef.color: a BodyDef has no such member': w => w.add({ color: 'red' }),
  'BodyDef.shapes[0].shape: only one of circle, capsule can be given':
    w => w.add({ shapes: [{ shape: { circle: {}, capsule: {} } }] }),
  'World.join: def: only one of revolute, weld can be given': w => w.join({ revolute: {}, weld: {} }),
  'World.joint: joint: a BodyId is not a JointId': w => w.joint(w.bodies()[0]),
  'Body.position is a method: call setPose(position, angle)': w => (w.body(w.bodies()[1]).position = [0, 0]),
  'Body.velocity is a method: call setVelocity(velocity)': w => (w.body(w.bodies()[1]).velocity = [0, 0]),
  'Body.awake is a method: call wake() or sleep()': w => (w.body(w.bodies()[1]).awake = true),
  'Body.applyForce is a method: call applyForce(force, at)': w => (w.body(w.bodies()[1]).applyForce = [0, 1]),
  'Body.contacts is a method, and nothing can be assigned to it': w => (w.body(w.bodies()[1]).contacts = []),
  'BodyShape.filter is a method: call setFilter(filter)': w => (w.shape(w.shapes()[1]).filter = {}),
  'Joint.def is a method: call set(def)': w => (plumb.Joint.prototype.def = {}),
  'Field.def is a method: call set(def)': w => (plumb.Field.prototype.def = {}),
  'World.gravity is a method: call setGravity(gravity)': w => (w.gravity = [0, 0]),
  'World.step is a method: call step(dt)': w => (w.step = 1),
  'World.poses is a method, and nothing can be assigned to it': w => (w.poses = []),
  'PlatformMover.profile is a method: call setProfile(profile)':
    w => (new plumb.PlatformMover(w, w.bodies()[1]).profile = {}),
  'GridMover.cell is a method, and nothing can be assigned to it': w => (new plumb.GridMover(w).cell = {}),
  'FixedClock.timeScale is a method: call setTimeScale(timeScale)': () => (new plumb.FixedClock().timeScale = 2),
  'Cannot add property motorSpeed, object is not extensible': w => (w.body(w.bodies()[1]).motorSpeed = 3),
  'this world has been freed': w => {
    const other = w.copy();
    other.free();
    other.poses();
  },
  'BodyDef.angle: "1" is not a number': w => w.add({ angle: '1' }),
  'BodyDef.awake: 1 is neither true nor false': w => w.add({ awake: 1 }),
  'BodyDef.type: "statik" is none of static, kinematic, dynamic': w => w.add({ type: 'statik' }),
  'BodyDef.tag: -1 is not within 0 to 2^64 - 1': w => w.add({ tag: -1 }),
  'BodyDef.shapes[1].shape.circle.radius: "x" is not a number':
    w => w.add({ shapes: [circle(1), { shape: { circle: { radius: 'x' } } }] }),
  'BodyDef.shapes[0].shape: circel is not one of circle, capsule, polygon, segment, chain, tiles; did you mean circle?':
    w => w.add({ shapes: [{ shape: { circel: {} } }] }),
  'BodyDef.shapes[0].shape.radius: -1 is not positive': w => w.add({ shapes: [{ shape: { circle: { radius: -1 } } }] }),
  'Material.friktion: a Material has no such member; did you mean friction?': () => box([1, 1], { friktion: 1 }),
  'BodyDef.shapes[0].material.dense: a Material has no such member; did you mean density?':
    w => w.add({ shapes: [{ shape: { circle: {} }, material: { dense: 1 } }] }),
  'World.step: dt: -1 is negative': w => w.step(-1),
  'World.step: dt: "x" is not a number': w => w.step('x'),
  'World.step: dt: is missing': w => w.step(),
  'World.step: 2 arguments were given, at most 1 are wanted': w => w.step(1, 2),
  'World.castRay: from: 3 is not [x, y]': w => w.castRay(3, 4),
  'World.castRay: ignored: an object is not a BodyId': w => w.castRay([0, 0], [1, 0], {}, {}),
  'Capacity.bodies: 4294967295 is more than 4294967294': w => w.reserve({ bodies: 4294967295 }),
  'Capacity.bodies: 300000000 is more than there is memory for': w => w.reserve({ bodies: 3e8 }),
  'Capacity.bodies: 1.5 is not a whole number from 0 to 4294967295': w => w.reserve({ bodies: 1.5 }),
  'WorldDef.solver.subSteps: 0 is not within 1 to 64': () => new World({ solver: { subSteps: 0 } }),
  'RevoluteJointDef.motorSpeed: 3 does nothing while maxMotorTorque is 0': w => {
    const [a, b] = w.bodies();
    w.join({ revolute: { bodyA: a, bodyB: b, motorSpeed: 3 } });
  },
};

function someWorld() {
  const world = new World();
  world.add({ type: 'static', shapes: [box([10, 0.5])] });
  world.add({ position: [0, 2], shapes: [circle(0.5)] });
  return world;
}

for (const [text, act] of Object.entries(refusals))
  test(`refused: ${text}`, () => {
    const world = someWorld(), hash = plumb.stateHash(world);
    let caught;
    try { act(world); } catch (error) { caught = error; }
    assert.ok(caught instanceof Error, 'nothing was refused');
    assert.equal(caught.message, text);
    assert.equal(plumb.stateHash(world), hash);
  });

test('the id of another world is refused, and one of a removed body', () => {
  const one = someWorld(), other = someWorld();
  assert.throws(() => other.body(one.bodies()[1]), /BodyId.*world/);
  const [, ball] = one.bodies();
  one.remove(ball);
  assert.throws(() => one.body(ball), /BodyId/);
});

test('200,000 refusals later, no memory is lost', () => {
  const world = someWorld();
  const refuse = () => { try { world.step(-1); } catch { return true; } };
  for (let i = 0; i < 1000; ++i) refuse();
  const before = plumb.memory.buffer.byteLength;
  for (let i = 0; i < 200000; ++i) assert.ok(refuse());
  assert.equal(plumb.memory.buffer.byteLength, before);
});

test('of a module of another build, loading is refused', async () => {
  const { readFile } = await import('node:fs/promises');
  const text = (await readFile(`${folder}/plumb.js`, 'utf8')).replace(/schemaHash = \d+/, 'schemaHash = 1');
  const { load } = await import(`data:text/javascript,${encodeURIComponent(text.replace(/import\.meta\.url/g, "'file:///'"))}`);
  await assert.rejects(load(await readFile(`${folder}/plumb.wasm`)), /not of one build/);
});
