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

/** What is down: codes of keys, and numbers of Pad. What is pressed and let go between two ticks is down for one. */
export class Devices {
  constructor() { this.down = new Set(); this.fresh = new Set(); this.pads = new Set(); }

  press(code) { this.down.add(code); this.fresh.add(code); }
  release(code) { this.down.delete(code); }
  releaseAll() { this.down.clear(); this.fresh.clear(); }
  isDown(key) { return codesOf[key].some(code => this.down.has(code) || this.fresh.has(code)); }

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
    let bits = 0;
    actions.forEach(({ keys, pads }, i) => {
      if (keys.some(key => this.isDown(key)) || pads.some(pad => this.pads.has(pad))) bits |= 1 << i;
    });
    this.fresh.clear();
    return bits >>> 0;
  }
}
