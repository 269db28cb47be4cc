// SPDX-License-Identifier: MIT
// Pads and buttons for thumbs: a gamepad that is drawn beside the picture.

const directions = ['left', 'right', 'up', 'down'];  // the first of the frame's Pad
const south = 4, start = 12;
const reach = 1.35;  // so far from a button's middle, in radii, a thumb still presses it

/** Which of the pad's four directions a thumb means, from the middle: one, or two between them. */
function directionsAt(x, y, radius) {
  if (Math.hypot(x, y) < 0.18 * radius) return [];
  const diagonal = Math.tan(Math.PI / 6), pressed = [];  // between two directions lie 30 degrees that mean both
  if (Math.abs(x) > diagonal * Math.abs(y)) pressed.push(x < 0 ? 0 : 1);
  if (Math.abs(y) > diagonal * Math.abs(x)) pressed.push(y < 0 ? 2 : 3);
  return pressed;
}

/** The buttons that a game wants beside the pad of directions: what they press, and what stands on them. */
function buttonsOf(actions) {
  const buttons = new Map();
  for (const { name, about, pads } of actions) {
    const pad = pads[0];
    if (about && pad >= south && !buttons.has(pad)) buttons.set(pad, name);
  }
  if (!buttons.has(south)) buttons.set(south, 'OK');
  return [...buttons].map(([pad, label]) => ({ pad, label }));
}

function element(parent, className, text = '') {
  const made = document.createElement('div');
  made.className = className;
  made.textContent = text;
  parent.append(made);
  return made;
}

/** Fills both sides with controls; take() gives the numbers of Pad that thumbs press. */
export class Touch {
  constructor(left, right, actions) {
    this.fingers = new Map();
    this.fresh = new Set();  // what was touched since the last tick, though it may be let go by now
    this.pad = element(left, 'pad');
    directions.forEach(name => element(this.pad, `arrow ${name}`));
    this.buttons = buttonsOf(actions).map(({ pad, label }) => ({ pad, element: element(right, `button pad${pad}`, label) }));
    this.buttons.push({ pad: start, element: element(right, 'button pause', 'II') });
    for (const side of [left, right]) {
      side.addEventListener('pointerdown', event => this.move(event));
      side.addEventListener('pointermove', event => this.fingers.has(event.pointerId) && this.move(event));
      for (const end of ['pointerup', 'pointercancel']) side.addEventListener(end, event => this.lift(event));
      side.addEventListener('contextmenu', event => event.preventDefault());
    }
  }

  move(event) {
    event.preventDefault();
    event.currentTarget.setPointerCapture?.(event.pointerId);
    const pads = this.padsAt(event.clientX, event.clientY);
    this.fingers.set(event.pointerId, pads);
    if (event.type === 'pointerdown') pads.forEach(pad => this.fresh.add(pad));
    this.show();
  }
  lift(event) {
    this.fingers.delete(event.pointerId);
    this.show();
  }
  releaseAll() {
    this.fingers.clear();
    this.fresh.clear();
    this.show();
  }

  padsAt(x, y) {
    const from = ({ element }) => {
      const box = element.getBoundingClientRect();
      return { x: x - box.left - box.width / 2, y: y - box.top - box.height / 2, radius: box.width / 2 };
    };
    const pad = from({ element: this.pad });
    if (Math.hypot(pad.x, pad.y) < reach * pad.radius) return directionsAt(pad.x, pad.y, pad.radius);
    return this.buttons.filter(button => {
      const at = from(button);
      return Math.hypot(at.x, at.y) < reach * at.radius;
    }).map(({ pad: number }) => number);
  }

  pressed() { return new Set([...this.fingers.values()].flat()); }
  /** For the next tick. */
  take() {
    const pads = new Set([...this.pressed(), ...this.fresh]);
    this.fresh.clear();
    return pads;
  }

  show() {
    const pressed = this.pressed();
    directions.forEach((name, i) => this.pad.querySelector(`.${name}`).classList.toggle('pressed', pressed.has(i)));
    for (const { pad, element: button } of this.buttons) button.classList.toggle('down', pressed.has(pad));
  }
}
