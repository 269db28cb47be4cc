// SPDX-License-Identifier: MIT
// Which scenes are measured? Bodies with boxes, discs or lines, and hinges: what every engine can build.

/** A scene: steps; bodies of { fixed, x, y, angle, box: [hx, hy] | disc: r | lines: [[x1, y1, x2, y2], ...] }; hinges of
 * [body, body, x, y]. Gravity is 10 m/s^2, nothing sleeps. */
const scene = (steps, bodies, hinges = [], touch = true) => ({ steps, bodies, hinges, touch });

function pyramid(base, x, y) {
  const boxes = [];
  for (let row = 0; row < base; ++row)
    for (let i = row; i < base; ++i) boxes.push({ x: x + 0.5 * row + (i - row), y: y + row, box: [0.5, 0.5] });
  return boxes;
}

function manyPyramids() {
  const lines = [], bodies = [{ fixed: true, x: 0, y: 0, lines }];
  for (let row = 0; row < 20; ++row) lines.push([-110, 11 * row, 110, 11 * row]);
  for (let k = 0; k < 400; ++k) bodies.push(...pyramid(10, 1 - 110 + 11 * (k % 20), 0.5 + 11 * Math.floor(k / 20)));
  return scene(40, bodies);
}

/** 100 by 100 discs on hinges, held by seven of the upper row. They do not touch each other. */
function jointGrid() {
  const side = 100, bodies = [], hinges = [];
  const held = (column, row) => row === 0 && Math.abs(column - side / 2) <= 3;
  for (let column = 0; column < side; ++column)
    for (let row = 0; row < side; ++row) {
      bodies.push({ fixed: held(column, row), x: column, y: -row, disc: 0.4 });
      const own = bodies.length - 1;
      if (row > 0) hinges.push([own - 1, own, column, -row + 0.5]);
      if (column > 0 && !(held(column, row) && held(column - 1, row)))
        hinges.push([own - side, own, column - 0.5, -row]);
    }
  return scene(60, bodies, hinges, false);
}

/** Boxes and discs that fall into a trough as wide as it needs, in rows of 25. */
function trough(count, steps) {
  const bodies = [{ fixed: true, x: 0, y: -0.5, box: [20, 0.5] }];
  for (const side of [-1, 1]) bodies.push({ fixed: true, x: 16 * side, y: 30, box: [0.5, 30] });
  for (let i = 0; i < count; ++i) {
    const place = { x: -14 + 1.15 * (i % 25), y: 1 + 1.3 * Math.floor(i / 25), angle: 0.3 * i };
    bodies.push(i % 2 === 0 ? { ...place, box: [0.5, 0.4] } : { ...place, disc: 0.45 });
  }
  return scene(steps, bodies);
}

export const scenes = {
  large_pyramid: () => scene(150, [{ fixed: true, x: 0, y: -1, box: [100, 1] }, ...pyramid(100, -49.5, 0.5)]),
  many_pyramids: manyPyramids,
  joint_grid: jointGrid,
  trough_50: () => trough(50, 1500),
  trough_200: () => trough(200, 600),
  trough_1000: () => trough(1000, 300),
};
