// SPDX-License-Identifier: MIT
// Does the module do what the kit does, by the kit's names?
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inspect } from 'node:util';

import { plumb } from './plumb.mjs';

const { World, box, circle, capsule, segment, tiles, tileMapOf, stateHash } = plumb;
/** Has a value the same members, and the same vectors, which are arrays of their own kind? */
const alike = (value, wanted) => assert.deepEqual(structuredClone(value), wanted);
const near = (a, b, by = 1e-9) => assert.ok(Math.abs(a - b) <= by, `${a} is not ${b}`);

/** A ball over a floor. */
function drop(def = {}) {
  const world = new World({ gravity: [0, -10], ...def });
  const floor = world.add({ type: 'static', shapes: [box([10, 0.5])] });
  const ball = world.add({ position: [0, 5], shapes: [circle(0.5, { restitution: 0.5 })] });
  return { world, floor, ball };
}
const run = (world, ticks) => { for (let i = 0; i < ticks; ++i) world.step(1 / 60); };

test('a thrown ball is where the closed form says', () => {
  const world = new World({ gravity: [0, -10] });
  const ball = world.add({ position: [1, 2], velocity: [3, 8], shapes: [circle(0.5)] });
  run(world, 60);
  const [x, y] = world.body(ball).position();
  near(x, 1 + 3);
  near(y, 2 + 8 - 5);
});

test('bodies, shapes, joints and fields are made, read, changed and removed', () => {
  const { world, floor, ball } = drop();
  const bob = world.add({ position: [2, 5], tag: 7, shapes: [box([0.2, 0.2], { density: 3 })] });
  const rod = world.join({ distance: { bodyA: ball, bodyB: bob, anchorA: [0, 5], anchorB: [2, 5] } });
  const wind = world.addField({ law: { drag: { linear: 0.1, wind: [2, 0] } } });
  assert.deepEqual(world.bodies(), [floor, ball, bob]);
  assert.deepEqual(world.joints(), [rod]);
  assert.deepEqual(world.fields(), [wind]);
  assert.equal(world.bodies()[1], ball, 'an id is one object');
  assert.equal(world.shapes()[2], bob.shape(0));
  near(world.body(bob).mass(), 3 * 0.16);
  assert.equal(world.body(bob).tag(), 7);
  assert.equal(world.body(bob).type(), 'dynamic');
  near(world.joint(rod).def().distance.length ?? 2, 2);
  near(world.joint(rod).coordinate().value, 2);
  alike(world.field(wind).def().law.drag.wind, [2, 0]);
  world.field(wind).set({ law: { uniformGravity: { acceleration: [1, 0] } } });
  alike(world.field(wind).def().law, { uniformGravity: { acceleration: [1, 0] } });
  world.shape(bob.shape(0)).setMaterial({ density: 6, friction: 0 });
  near(world.body(bob).mass(), 6 * 0.16);
  assert.equal(world.shape(bob.shape(0)).material().friction, 0);
  world.body(ball).setVelocity([1, 2]);
  world.body(ball).applyImpulse([0, world.body(ball).mass()]);
  alike(world.body(ball).velocity(), [1, 3]);
  world.remove(rod);
  world.remove(wind);
  world.remove(bob);
  assert.equal(world.contains(bob), false);
  assert.equal(world.contains(ball), true);
  assert.throws(() => world.body(bob).position(), /BodyId/);
});

test('queries find what is there', () => {
  const { world, floor, ball } = drop();
  const hit = world.castRay([0, 9], [0, -9]);
  assert.equal(hit.shape, ball.shape(0));
  near(hit.point[1], 5.5);
  assert.equal(world.castRay([0, 9], [0, -9], {}, ball).shape.body, floor);
  assert.equal(world.castRay([50, 9], [50, -9]), null);
  assert.equal(world.castRayAll([0, 9], [0, -9]).length, 2);
  assert.deepEqual(world.overlapBox({ lower: [-1, 4], upper: [1, 6] }), [ball.shape(0)]);
  assert.deepEqual(world.overlapPoint([0, 5]), [ball.shape(0)]);
  assert.deepEqual(world.overlapShape({ circle: { radius: 1 } }, { position: [0, 0] }), [floor.shape(0)]);
  near(world.nearest([0, 7]).separation, 1.5);
  assert.equal(world.nearest([0, 7], 1), null);
  near(world.distance(floor.shape(0), ball.shape(0)).separation, 4);
  near(world.castShape({ circle: { radius: 0.5 } }, { position: [3, 5], rotation: 0 }, [0, -9]).fraction, 4 / 9);
});

test('events come as objects, and as rows with the same numbers', () => {
  const { world, floor, ball } = drop({ hitSpeed: 1 });
  const gate = world.add({ type: 'static', position: [0, 3], shapes: [{ ...box([1, 0.1]), sensor: true }] });
  const kinds = new Set();
  let begins = 0;
  for (let i = 0; i < 240; ++i) {
    world.step(1 / 60);
    const rows = world.events(), columns = plumb.eventColumns.length;
    assert.equal(rows.length % columns, 0);
    for (let at = 0; at < rows.length; at += columns) kinds.add(plumb.eventKinds[rows[at]]);
    for (const begin of world.contactBegins()) {
      ++begins;
      assert.deepEqual(new Set([begin.shapeA.body, begin.shapeB.body]), new Set([floor, ball]));
      const row = [...rows].slice(0, columns);
      assert.deepEqual(row.slice(5, 7), [...begin.point]);
      assert.equal(row[9], begin.approachSpeed);
    }
    for (const { sensor, visitor } of world.sensorBegins()) assert.deepEqual([sensor.body, visitor.body], [gate, ball]);
  }
  assert.ok(begins > 1);
  for (const kind of ['contactBegin', 'contactEnd', 'contactHit', 'sensorBegin', 'sensorEnd']) assert.ok(kinds.has(kind), kind);
});

test('poses, velocities and contacts come for all bodies at once', () => {
  const { world, floor, ball } = drop();
  const box2 = world.add({ position: [5, 1.5], shapes: [box([1, 1])] });
  world.remove(ball);
  run(world, 30);
  const poses = world.poses(), speeds = world.velocities();
  for (const id of [floor, box2]) {
    const body = world.body(id);
    assert.deepEqual([...poses.subarray(3 * id.index, 3 * id.index + 3)], [...body.position(), body.angle()]);
    assert.deepEqual([...speeds.subarray(3 * id.index, 3 * id.index + 3)], [...body.velocity(), body.angularVelocity()]);
  }
  assert.ok(Number.isNaN(poses[3 * ball.index]));
  const rows = world.contacts(), columns = plumb.contactColumns.length;
  const contact = world.body(box2).contacts()[0];
  assert.equal(rows.length, columns * contact.points.length);
  const force = plumb.contactColumns.indexOf('normalForce');
  near([...rows].filter((_, i) => i % columns === force).reduce((a, b) => a + b), world.body(box2).mass() * 10, 0.5);
  assert.equal(world.poses(), poses, 'the same array');
});

test('a contact rule of JavaScript decides, and its error comes out of step', () => {
  const world = new World();
  const asked = [];
  const rule = candidate => {
    asked.push(candidate);
    return candidate.otherTag !== 5;
  };
  world.add({ type: 'static', shapes: [{ ...box([10, 0.5]), rule, tag: 3 }] });
  const solid = world.add({ position: [-2, 1.2], shapes: [circle(0.5)] });
  const ghost = world.add({ position: [2, 1.2], shapes: [{ ...circle(0.5), tag: 5 }] });
  run(world, 90);
  near(world.body(solid).position()[1], 1, 0.01);
  assert.ok(world.body(ghost).position()[1] < 0);
  assert.equal(asked[0].tag, 3);
  assert.equal(world.shape(world.shapes()[0]).def().rule, rule);

  const broken = new World();
  broken.add({ type: 'static', shapes: [{ ...box([10, 0.5]), rule() { throw new RangeError('mine'); } }] });
  broken.add({ position: [0, 1.1], shapes: [circle(0.5)] });
  assert.throws(() => run(broken, 60), RangeError);
  const curious = new World();
  curious.add({ type: 'static', shapes: [{ ...box([10, 0.5]), rule: () => curious.gravity()[1] < 0 }] });
  curious.add({ position: [0, 1.1], shapes: [circle(0.5)] });
  assert.throws(() => run(curious, 60), /a contact rule was asked by the kit, and may not call it/);
  run(world, 10);  // the module goes on
});

test('one-way shapes and tile maps are as in the kit', () => {
  const world = new World();
  const map = tileMapOf(['....', '#..=', '####'], 1);
  const ground = world.add({ type: 'static', shapes: [tiles(map)] });
  const level = ground.shape(0);
  assert.deepEqual(plumb.textOf(world.tiles(level)), ['....', '#..=', '####']);
  const crate = world.add({ position: [1.5, 1.5], shapes: [box([0.3, 0.3])] });
  run(world, 60);
  near(world.body(crate).position()[1], 1.3, 0.01);
  world.setTile(level, { column: 1, row: 0 }, {});
  run(world, 60);
  assert.ok(world.body(crate).position()[1] < 0.5);
  assert.equal(world.tiles(level).tiles[1].form, 'empty');
  const shelf = world.add({ type: 'static', position: [20, 0], shapes: [{ ...segment([-2, 0], [2, 0]), oneWay: [0, 1] }] });
  const up = world.add({ position: [20, -2], velocity: [0, 9], shapes: [circle(0.3)] });
  run(world, 240);
  near(world.body(up).position()[1], 0.3, 0.02);
  alike(world.shape(shelf.shape(0)).def().oneWay, [0, 1]);
});

test('movers live in a world: on a grid, on platforms, along a path', () => {
  const world = new World();
  const maze = world.add({ type: 'static', shapes: [tiles(tileMapOf(['#####', '#...#', '#####']))] }).shape(0);
  const mouse = new plumb.GridMover(world, { cell: { column: 1, row: 1 }, heading: 'right' });
  const kinds = new Set();
  for (let i = 0; i < 120; ++i) for (const event of mouse.move(maze, 4, 1 / 60)) kinds.add(event.kind);
  assert.deepEqual(mouse.cell(), { column: 3, row: 1 });
  alike(mouse.position(maze), [3.5, 1.5]);
  assert.ok(mouse.stopped() && kinds.has('entered') && kinds.has('stopped'));
  assert.equal(plumb.nextDirection(world, maze, { cell: { column: 2, row: 1 } }, { column: 1, row: 1 }), 'right');

  world.add({ type: 'static', position: [20, 0], shapes: [box([10, 0.5])] });
  const body = world.add({ type: 'kinematic', position: [20, 3], shapes: [capsule([0, -0.3], [0, 0.3], 0.3)] });
  const hero = new plumb.PlatformMover(world, body, plumb.modernProfile({ height: 2 }));
  let top = 0, slide;
  for (let i = 0; i < 300; ++i) {
    slide = hero.step({ move: 0.5, jump: i > 120 && i < 160 }, 1 / 60);
    world.step(1 / 60);
    if (i > 120) top = Math.max(top, world.body(body).position()[1]);
  }
  assert.ok(slide.isOnFloor);
  near(top - slide.position[1], 2, 0.02);
  assert.ok(slide.position[0] > 21);

  const path = new plumb.MotionPath([0, 0]).lineTo([3, 0]).arcAround([3, 1], Math.PI).close();
  near(path.length(), 3 + Math.PI + Math.hypot(3, 2));
  const lift = new plumb.PathMover(world, { path, timing: { speed: 2 }, repeat: 'loop' });
  alike(lift.at(1).position, [2, 0]);
  near(lift.period(), path.length() / 2);
  near(plumb.splineThrough([[0, 0], [1, 0], [2, 0]]).length(), 2);
  lift.free();
  assert.throws(() => lift.at(1), /has been freed/);
});

test('closed forms, steering, forecast and clock answer as in the kit', () => {
  for (const shot of plumb.aim({ target: [10, 2], speed: 15, gravity: [0, -10] })) {
    near(shot.velocity[0] * shot.time, 10, 1e-6);
    near(shot.velocity[1] * shot.time - 5 * shot.time ** 2, 2, 1e-6);
  }
  assert.equal(plumb.aim({ target: [1000, 0], speed: 1 }).length, 0);
  near(plumb.solveMotion({ displacement: 20, startVelocity: 0, acceleration: 10 }).motions[0].time, 2);
  near(plumb.pendulumPeriod({ inertia: 1, mass: 1, distance: 1, gravity: 10 }), 2 * Math.PI / Math.sqrt(10), 1e-9);
  const force = plumb.seek({ position: [0, 0], velocity: [0, 0] }, [3, 4]);
  near(force[0] / force[1], 3 / 4);
  const { world, ball } = drop();
  const ahead = plumb.forecast(world, ball, 90, 1 / 60);
  run(world, 90);
  assert.deepEqual(world.body(ball).position(), ahead.poses[90].position);
  assert.equal(ahead.hits[0].tick, 54);
  const clock = new plumb.FixedClock({ interval: 0.02 });
  assert.equal(clock.advance(0.05).due, 2);
  assert.equal(clock.tick(), 2);
  const dice = new plumb.Random(5), same = dice.copy();
  assert.deepEqual([dice.uniform(0, 1), dice.integer(1, 6)], [same.uniform(0, 1), same.integer(1, 6)]);
});

test('a copy goes on to the same bits, and the original after it', () => {
  const { world } = drop();
  run(world, 30);
  const copy = world.copy();
  run(world, 200);
  run(copy, 200);
  assert.equal(stateHash(world), stateHash(copy));
  copy.free();
  assert.throws(() => copy.step(0.1), /this world has been freed/);
  copy.free();
});

test('a vector is an array with x and y', () => {
  const { world, ball } = drop(), at = world.body(ball).position(), [x, y] = at;
  assert.deepEqual([at.x, at.y, x, y, at.length], [0, 5, 0, 5, 2]);
  assert.ok(Array.isArray(at));
  assert.equal(JSON.stringify(at), '[0,5]');
  assert.equal(inspect(at), '[ 0, 5 ]');
  assert.deepEqual(at.map(one => 2 * one), [0, 10], 'what is made of it is a plain array');
  assert.deepEqual(structuredClone(at), [0, 5]);
  world.body(ball).setPose(at, 0);
  near(world.castRay([0, 9], [0, -9]).point.y, 5.5);
});

test('a tag is a number where it fits, and a mask is always a BigInt', () => {
  const { world } = drop();
  for (const [given, read] of [[5, 5], [5n, 5], [2 ** 53 - 1, 2 ** 53 - 1], [2n ** 53n, 2n ** 53n], [2n ** 64n - 1n, 2n ** 64n - 1n]]) {
    const id = world.add({ tag: given, shapes: [{ ...circle(1), tag: given }] });
    assert.equal(world.body(id).tag(), read);
    assert.equal(world.shape(id.shape(0)).tag(), read);
    assert.equal(world.shape(id.shape(0)).def().tag, read);
  }
  const { category, mask } = world.shape(world.shapes()[0]).filter();
  assert.deepEqual([category, mask], [1n, 2n ** 64n - 1n]);
  assert.equal(typeof new plumb.Random(5).bits(), 'bigint');
});

test('console.log and JSON show what an object is', () => {
  const { world, floor, ball } = drop();
  const joint = world.join({ revolute: { bodyA: floor, bodyB: ball } }), field = world.addField({ law: { drag: { linear: 2 } } });
  const body = JSON.parse(JSON.stringify(world.body(ball)));
  assert.deepEqual(body, { id: { kind: 'BodyId', index: ball.index, generation: 0, world: ball.world }, type: 'dynamic', position: [0, 5],
                           angle: 0, velocity: [0, 0], angularVelocity: 0 });
  assert.match(inspect(world.body(ball)), /^Body \{\s+id: BodyId \{.*\},\s+type: 'dynamic',\s+position: \[ 0, 5 \]/);
  assert.equal(JSON.parse(JSON.stringify(world.joint(joint))).def.revolute.bodyB.index, ball.index);
  assert.match(inspect(world.joint(joint)), /^Joint \{[\s\S]*revolute/);
  assert.equal(JSON.parse(JSON.stringify(world.field(field))).def.law.drag.linear, 2);
  assert.match(inspect(world.field(field)), /^Field \{[\s\S]*drag/);
  assert.deepEqual(JSON.parse(JSON.stringify(world.shape(ball.shape(0)))).def.filter, { category: '1', mask: String(2n ** 64n - 1n), group: 0 });
  assert.equal(JSON.parse(JSON.stringify(world)).counts.bodies, 2);
  assert.match(inspect(world), /^World \{\s+gravity: \[ 0, -10 \],\s+counts/);
  assert.match(inspect({ deep: { deeper: { world } } }), /\[World\]/);
  assert.equal(String(ball.shape(0)), `ShapeId(${ball}, 0)`);
  assert.notEqual(String(ball), String(floor));
  world.remove(ball);
  const freed = new World(), gone = freed.body(freed.add({ type: 'static' }));
  freed.free();
  assert.match(inspect(gone), /this world has been freed/);
});

test('posesBefore has the poses before the last step', () => {
  const { world, floor, ball } = drop();
  const first = world.posesBefore();
  assert.deepEqual([...first], [...world.poses()], 'no step has been kept yet');
  for (let tick = 0; tick < 3; ++tick) {
    const now = [...world.poses()];
    world.step(1 / 60);
    assert.deepEqual([...world.posesBefore()], now);
    assert.notDeepEqual(now, [...world.poses()]);
  }
  assert.equal(world.posesBefore(), first, 'the same array');
  world.remove(ball);
  const other = world.add({ position: [7, 8], angle: 1, shapes: [circle(0.5)] });
  assert.equal(other.index, ball.index, 'the place is used again');
  for (let i = 0; i < 40; ++i) world.add({ position: [20 + 3 * i, 9], shapes: [circle(0.5)] });
  assert.deepEqual([...world.posesBefore()], [...world.poses()], 'a new body has not moved');
  world.step(1 / 60);
  assert.deepEqual([...world.posesBefore().subarray(3 * other.index, 3 * other.index + 3)], [7, 8, 1]);
  assert.ok(Number.isFinite(world.posesBefore()[3 * floor.index]));
  world.free();
  assert.throws(() => world.posesBefore(), /this world has been freed/);
});
