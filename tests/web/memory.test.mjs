// SPDX-License-Identifier: MIT
// Does a long run with everything read leave garbage or take memory? Run with --expose-gc.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { plumb } from './plumb.mjs';

const { World, box, circle } = plumb;
async function heap() {
  for (let i = 0; i < 4; ++i) {
    globalThis.gc();
    await new Promise(done => setTimeout(done, 20));
  }
  return process.memoryUsage().heapUsed;
}
/** The heap when the compiler has done its work, and thrown away what it needed for that. */
async function steadyHeap(act) {
  let before = Infinity, now = await heap();
  for (let i = 0; i < 20 && Math.abs(now - before) > 10e3; ++i) {
    act();
    before = now;
    now = await heap();
  }
  return now;
}

function crowd(count) {
  const world = new World();
  world.add({ type: 'static', shapes: [box([30, 0.5])] });
  for (const side of [-30, 30]) world.add({ type: 'static', position: [side, 20], shapes: [box([0.5, 20])] });
  for (let i = 0; i < count; ++i)
    world.add({ position: [-25 + (i % 50), 2 + 1.1 * Math.floor(i / 50)], shapes: [i % 2 ? circle(0.4) : box([0.4, 0.3])] });
  return world;
}

test('10,000 steps of 1,000 bodies with all arrays read: the heap grows by no more than 50 KB, the memory is constant', async () => {
  const world = crowd(1000);
  let sum = 0;
  const go = ticks => {
    for (let i = 0; i < ticks; ++i) {
      world.step(1 / 60);
      sum += world.poses()[3] + world.velocities()[3] + world.contacts().length + world.events().length;
    }
  };
  go(3000);  // until all have come to rest: contacts, and with them the memory, grow up to there
  const memory = plumb.memory.buffer.byteLength;
  // Garbage grows in every run. What the compiler keeps, and may make at any time on a slow machine, grows in one.
  const grown = [];
  for (let run = 0; run < 3 && !grown.some(bytes => bytes <= 50e3); ++run) {
    const before = await steadyHeap(() => go(500));
    go(10000);
    grown.push((await heap()) - before);
  }
  assert.ok(grown.some(bytes => bytes <= 50e3), `the heap has grown by ${grown} bytes`);
  assert.equal(plumb.memory.buffer.byteLength, memory);
  assert.ok(Number.isFinite(sum));
});

test('worlds that are freed, or forgotten, give their memory back', async () => {
  const make = () => {
    const world = crowd(200);
    world.step(1 / 60);
    new plumb.PlatformMover(world, world.add({ type: 'kinematic', position: [90, 3], shapes: [circle(0.3)] }));
    return world;
  };
  for (let i = 0; i < 20; ++i) make().free();
  const before = plumb.memory.buffer.byteLength;
  for (let i = 0; i < 300; ++i) make().free();
  assert.equal(plumb.memory.buffer.byteLength, before);
  for (let i = 0; i < 60; ++i) {
    for (let j = 0; j < 10; ++j) make();
    globalThis.gc();
    await new Promise(done => setTimeout(done, 5));
  }
  assert.ok(plumb.memory.buffer.byteLength <= 8 * before, `${plumb.memory.buffer.byteLength} of ${before}`);
});
