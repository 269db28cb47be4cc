// SPDX-License-Identifier: MIT
// Measures one engine on one scene, in a process of its own: node measure.mjs ENGINE SCENE. Prints JSON.
import { engines } from './engines.mjs';
import { scenes } from './scenes.mjs';

const [engine, name] = process.argv.slice(2);
const scene = scenes[name](), build = await engines[engine]();
const world = build(scene), times = [];
for (let i = 0; i < scene.steps; ++i) {
  const start = performance.now();
  world.step();
  times.push(performance.now() - start);
}
times.sort((a, b) => a - b);
const moving = world.heights().filter((_, i) => !scene.bodies[i].fixed);
console.log(JSON.stringify({ median: times[times.length >> 1], mean: times.reduce((a, b) => a + b) / times.length,
                             highest: Math.max(...moving) }));
process.exit(0);  // Box2D's worker does not end by itself
