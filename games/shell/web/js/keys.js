// SPDX-License-Identifier: MIT
// The keyboard and gamepads: which actions are done? By the place of a key, not by what is printed on it.

/** The browser's codes of each key, in the order of the frame's Key. */
export const codesOf = [['ArrowLeft'], ['ArrowRight'], ['ArrowUp'], ['ArrowDown'], ['Space'], ['Enter', 'NumpadEnter'], ['Escape'], ['Tab'],
  ['Backspace'], ['ShiftLeft', 'ShiftRight'], ['ControlLeft', 'ControlRight'], ['Minus', 'NumpadSubtract'], ['Equal', 'NumpadAdd'],
  ['Comma'], ['Period'], ...[...'ABCDEFGHIJKLMNOPQRSTUVWXYZ'].map(letter => [`Key${letter}`]),
  ...[...'0123456789'].map(digit => [`Digit${digit}`])];
const keyOf = new Map(codesOf.flatMap((codes, key) => codes.map(code => [code, key])));
const names = ['←', '→', '↑', '↓', 'Space', 'Enter', 'Escape', 'Tab', 'Backspace', 'Shift', 'Ctrl', '-', '+', ',', '.',
  ...'ABCDEFGHIJKLMNOPQRSTUVWXYZ', ...'0123456789'];

export const keyNumber = code => keyOf.get(code);
export const keyName = key => names[key];

/** The standard gamepad's button for each of the frame's Pad. */
const padButtons = [14, 15, 12, 13, 0, 1, 2, 3, 4, 5, 6, 7, 9, 8];
const stick = 0.5;  // so far out, it is pressed [-]

/** What is down: codes of keys, and numbers of Pad. */
export class Devices {
  constructor() { this.down = new Set(); this.changes = []; this.pads = new Set(); }

  press(code) { this.changes.push([code, true]); }
  release(code) { this.changes.push([code, false]); }
  releaseAll() { this.down.clear(); this.changes = []; }

  /** A key changes once a tick: a press that is shorter lasts for one, and two presses between two ticks are two. */
  readKeys() {
    const changed = new Set();
    while (this.changes.length > 0 && !changed.has(this.changes[0][0])) {
      const [code, isDown] = this.changes.shift();
      changed.add(code);
      if (isDown) this.down.add(code);
      else this.down.delete(code);
    }
  }

  /** Asks the gamepads: they tell of nothing by themselves. */
  readPads() {
    const pads = new Set();
    for (const pad of navigator.getGamepads?.() ?? []) {
      if (!pad?.connected) continue;
      padButtons.forEach((button, i) => { if (pad.buttons[button]?.pressed) pads.add(i); });
      if (pad.axes[0] < -stick) pads.add(0);
      if (pad.axes[0] > stick) pads.add(1);
      if (pad.axes[1] < -stick) pads.add(2);
      if (pad.axes[1] > stick) pads.add(3);
    }
    this.pads = pads;
  }

  /** The bits of the actions for the next tick. */
  take(actions) {
    this.readKeys();
    const isDown = key => codesOf[key].some(code => this.down.has(code));
    let bits = 0;
    actions.forEach(({ keys, pads }, i) => {
      if (keys.some(isDown) || pads.some(pad => this.pads.has(pad))) bits |= 1 << i;
    });
    return bits >>> 0;
  }
}
