// SPDX-License-Identifier: MIT
// A small world on the front page: a pile of boxes, and a hand that throws more.
import { load } from './module/plumb.js';

const canvas = document.querySelector('#world'), pen = canvas.getContext('2d'), count = document.querySelector('#count');
const { World, box } = await load();
const width = 16, height = 10, half = 0.35, hand = [1.6, 2.2];  // [m]
const throwing = 5, mostSpeed = 22, mostBoxes = 150;  // [1/s], [m/s]
const colors = ['#c7532e', '#2f7f79', '#d99a2b', '#5a5f8f', '#8a4f7d'];
let world, boxes, from = null, to = null;

function begin() {
  world?.free();
  world = new World({ gravity: [0, -9.81] });
  world.add({ type: 'static', position: [width / 2, -0.5], shapes: [box([width, 0.5])] });
  for (const x of [-0.5, width + 0.5]) world.add({ type: 'static', position: [x, 10], shapes: [box([0.5, 20])] });
  boxes = [];
  for (let row = 0; row < 7; ++row)
    for (let i = 0; i < 7 - row; ++i) add([9 + (i + row / 2) * 2.06 * half, half + row * 2 * half]);
}

function add(position, velocity = [0, 0]) {
  boxes.push(world.add({ position, velocity, shapes: [box([half, half], { friction: 0.6, restitution: 0.1 })] }));
  if (boxes.length > mostBoxes) world.remove(boxes.shift());
}

/** As far as the hand drew back, so fast it goes, the other way. */
function thrown(start, end) {
  const pull = [(start[0] - end[0]) * throwing, (start[1] - end[1]) * throwing], speed = Math.hypot(...pull);
  const share = speed > mostSpeed ? mostSpeed / speed : 1;
  return [pull[0] * share, pull[1] * share];
}

function pointAt(event) {
  const area = canvas.getBoundingClientRect();
  return [(event.clientX - area.left) / area.width * width, height - (event.clientY - area.top) / area.height * height];
}
canvas.addEventListener('pointerdown', event => { canvas.setPointerCapture(event.pointerId); from = to = pointAt(event); });
canvas.addEventListener('pointermove', event => { if (from) to = pointAt(event); });
canvas.addEventListener('pointercancel', () => { from = null; });
canvas.addEventListener('pointerup', () => {
  if (from && from[0] > half && from[0] < width - half && from[1] > half) add(from, thrown(from, to));
  from = null;
});
canvas.addEventListener('keydown', event => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.code === 'Space') add(hand, [15 + 4 * Math.random(), 3 + 3 * Math.random()]);
  else if (event.code === 'KeyR') begin();
  else return;
  event.preventDefault();
});

function draw() {
  const scale = devicePixelRatio || 1, pixels = Math.round(canvas.clientWidth * scale);
  if (canvas.width !== pixels) { canvas.width = pixels; canvas.height = Math.round(pixels * height / width); }
  const unit = canvas.width / width, poses = world.poses();
  pen.setTransform(unit, 0, 0, -unit, 0, canvas.height);
  pen.clearRect(0, 0, width, height);
  boxes.forEach((id, i) => {
    const at = 3 * id.index, cos = Math.cos(poses[at + 2]), sin = Math.sin(poses[at + 2]);
    pen.setTransform(unit * cos, -unit * sin, -unit * sin, -unit * cos, unit * poses[at], canvas.height - unit * poses[at + 1]);
    pen.fillStyle = colors[id.index % colors.length];
    pen.beginPath();
    pen.roundRect(-half, -half, 2 * half, 2 * half, 0.06);
    pen.fill();
  });
  if (!from) return;
  pen.setTransform(unit, 0, 0, -unit, 0, canvas.height);
  const [vx, vy] = thrown(from, to);
  pen.fillStyle = '#c7532e';
  for (let i = 1; i <= 14; ++i) {  // where it would fly
    const t = i * 0.06;
    pen.beginPath();
    pen.arc(from[0] + vx * t, from[1] + vy * t - 4.905 * t * t, 0.07, 0, 2 * Math.PI);
    pen.fill();
  }
}

let before = performance.now(), left = 0;
function frame(now) {
  left = Math.min(left + (now - before) / 1000, 0.1);
  before = now;
  for (; left >= 1 / 60; left -= 1 / 60) world.step(1 / 60);
  draw();
  count.textContent = `${boxes.length} boxes`;
  requestAnimationFrame(frame);
}
begin();
requestAnimationFrame(frame);
