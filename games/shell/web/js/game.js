// SPDX-License-Identifier: MIT
// A game in its page: from one tick to the next, and what is pressed, seen and heard there.

import { Devices, keyName, keyNumber } from './keys.js';
import { gameInfoOf, loadGame } from './module.js';
import { makePanel, save } from './panel.js';
import { painterOn } from './painter.js';
import { Sound } from './sound.js';
import { bestOf, keptOf, Store } from './store.js';
import { Touch } from './touch.js';

const tickSeconds = 1 / 60, mostBehind = 0.1;  // [s]; what a slow display is behind by more is left out

/** The middle of the last second's times. */
class Times {
  constructor() { this.ticks = []; this.frames = []; this.intervals = []; }
  add(list, seconds) { list.push(seconds); if (list.length > 60) list.shift(); }
  columns() {
    const ms = list => list.length ? ([...list].sort((a, b) => a - b)[list.length >> 1] * 1000).toFixed(2) : '-';
    const rate = this.intervals.length ? this.intervals.length / this.intervals.reduce((sum, one) => sum + one, 0) : 0;
    return [`tick ${ms(this.ticks)} ms`, `frame ${ms(this.frames)} ms`, `${rate.toFixed(0)} frames a second`];
  }
}

class GamePage {
  constructor(game, setup) {
    this.game = game;
    this.name = setup.name;
    this.home = setup.home;
    this.store = new Store(setup.name);
    this.info = gameInfoOf(game.describe());
    this.own = this.info.actions.filter(action => action.about);  // those that the title lists
    this.usual = this.own.map(action => [...action.keys]);
    this.leaving = this.info.actions.filter(action => ['pause', 'back'].includes(action.name) && !this.own.includes(action))
      .map(action => ({ action, keys: action.keys }));
    this.canvas = document.querySelector('canvas');
    this.painter = painterOn(this.canvas);
    this.devices = new Devices();
    this.sound = new Sound(this.store.read().sound ?? true);
    this.times = new Times();
    this.timesOn = this.debugOn = this.pauses = false;
    this.left = 0;
    this.before = performance.now();
  }

  start() {
    document.documentElement.style.setProperty('--accent', this.info.accent);
    document.documentElement.style.setProperty('--background', this.info.background);
    this.readKeys();
    this.touch = new Touch(document.querySelector('#left'), document.querySelector('#right'), this.own);
    this.panel = makePanel(document.querySelector('dialog'), this.own, this.usual, this.panelActions());
    this.listen();
    this.begin();
    this.fit();
    requestAnimationFrame(now => this.frame(now));
  }

  // ---- runs

  /** A run of its own: with the scores and options of last time, and another seed each time. */
  begin() {
    const { scores = [], options = {} } = this.store.read();
    const seed = crypto.getRandomValues(new Uint32Array(1))[0];
    const head = `plumb-record 1 ${this.name}\nseed ${seed}\n`;
    const chosen = Object.entries(options).map(([name, value]) => `option ${name} ${value}\n`).join('');
    try {
      this.game.begin(head + chosen, scores);
    } catch {  // options of another version of the game
      this.game.begin(head, scores);
    }
    this.begun();
    const turns = document.body.classList.contains('touch') && innerWidth < 500 && this.info.fillsUpright === 'no';
    this.say(turns ? 'Turn the phone for a larger picture' : '');
  }
  begun() {
    this.over = false;
    this.listKeys();
    this.game.showDebug(this.debugOn);
  }
  openRecord(text, name) {
    try {
      this.game.begin(text, this.store.read().scores);
      this.begun();
      this.say(this.game.isReplay() ? `Replaying ${name}` : `${name} holds no ticks: play from its seed`);
    } catch (error) {
      this.say(`${name} was not opened: ${error.message}`);
    }
  }
  /** The player left by the menu, or a replay is at its end. */
  end() {
    if (this.game.isReplay()) {
      this.over = true;
      this.say(this.game.replayAgrees() ? 'The replay has ended as it was recorded. Press a key to play.'
        : 'The replay ended with another hash than its record has: another version of the game made it. Press a key to play.');
    } else if (this.home) {
      this.keep();
      location.href = this.home;
      this.over = true;
    } else this.begin();
  }
  keep() {
    if (this.game.isReplay()) return;
    const { scores, options } = keptOf(this.game.toKeep());
    this.store.write({ scores: bestOf(scores, this.store.read().scores ?? []), options });
  }

  // ---- what is pressed

  readKeys() {
    const { keys = {} } = this.store.read();
    for (const action of this.own) if (Array.isArray(keys[action.name])) action.keys = keys[action.name].filter(key => keyName(key) !== undefined);
    this.freeKeys();
  }
  /** What a player has chosen for the game no longer leaves a round. */
  freeKeys() {
    for (const { action, keys } of this.leaving) action.keys = keys.filter(key => !this.own.some(own => own.keys.includes(key)));
  }
  /** The title lists the keys, but not where nobody has any. */
  listKeys() {
    const shown = !document.body.classList.contains('touch');
    for (const action of this.own) this.game.listKeys(this.info.actions.indexOf(action), shown ? action.keys : []);
  }
  listen() {
    addEventListener('keydown', event => this.keyDown(event));
    // While a Mac's command key is down, nobody tells of other keys that are let go.
    addEventListener('keyup', event => /^Meta/.test(event.code) ? this.devices.releaseAll() : this.devices.release(event.code));
    addEventListener('blur', () => this.leave());
    document.addEventListener('visibilitychange', () => document.hidden && this.leave());
    addEventListener('resize', () => this.fit());
    new ResizeObserver(() => this.fit()).observe(this.canvas.parentElement);
    addEventListener('pointerdown', event => this.pointerDown(event), true);
    addEventListener('pointerup', () => this.sound.allow(), true);  // a finger counts as a press when it is lifted
    this.canvas.addEventListener('click', () => this.click());
    for (const [name, act] of Object.entries({ open: () => this.openPanel(), full: () => this.fillDisplay(), mute: () => this.mute() }))
      document.querySelector(`header .${name}`).addEventListener('click', event => { act(); event.currentTarget.blur(); });
    document.querySelector('header .full').hidden = !document.fullscreenEnabled;
    this.showSound();
  }
  keyDown(event) {
    if (this.panel.isOpen() || event.altKey || event.metaKey) return;
    this.sound.allow();
    const shell = { F1: () => this.debug(), F2: () => this.showTimes(), F3: () => this.savePicture(), F4: () => this.mute() }[event.code];
    // Tab leads to the buttons above, but in a round that uses it.
    const used = event.code !== 'Tab' || this.game.screen() === 'play' && this.own.some(({ keys }) => keys.includes(keyNumber('Tab')));
    const key = used ? keyNumber(event.code) : undefined, onControl = event.target.closest?.('button, a');
    if (shell && !event.repeat) shell();
    if (shell || (key !== undefined && !onControl && !event.ctrlKey)) event.preventDefault();
    if (key === undefined || event.repeat || (onControl && ['Enter', 'Space', 'Tab'].includes(event.code))) return;
    this.useTouch(false);
    if (this.over) this.begin();
    this.devices.press(event.code);
  }
  pointerDown(event) {
    this.sound.allow();
    // Where it points to, before the controls come up and move the picture.
    const box = this.canvas.getBoundingClientRect(), scale = this.canvas.width / box.width;
    this.pointed = this.over ? null : [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale, this.canvas.width, this.canvas.height];
    if (event.pointerType === 'touch') this.useTouch(true);
    if (this.over && !event.target.closest('header, dialog')) this.begin();
  }
  useTouch(used) {
    if (document.body.classList.contains('touch') === used) return;
    document.body.classList.toggle('touch', used);
    this.listKeys();
    this.fit();
  }
  click() {
    if (this.pointed) this.game.tap(...this.pointed);
    this.pointed = null;
  }
  /** Nobody looks, and nobody will tell of keys that are let go. */
  leave() {
    this.devices.releaseAll();
    this.touch.releaseAll();
    this.pauses = true;
    this.sound.pause();
    this.keep();
  }
  buttons() {
    this.devices.readPads();
    for (const pad of this.touch.take()) this.devices.pads.add(pad);
    let bits = this.devices.take(this.info.actions);
    // By a button, so that the record has it.
    if (this.pauses && this.game.screen() === 'play') bits |= 1 << this.info.actions.findIndex(action => action.name === 'pause');
    this.pauses = false;
    return bits >>> 0;
  }

  // ---- the panel and the header

  panelActions() {
    return {
      sound: () => this.mute(), soundOn: () => this.sound.on,
      debug: () => this.debug(), debugOn: () => this.debugOn,
      times: () => this.showTimes(), timesOn: () => this.timesOn,
      picture: () => this.savePicture(),
      saveRecord: () => save(`${this.name}.record`, new Blob([this.game.record()], { type: 'text/plain' })),
      openRecord: (text, name) => this.openRecord(text, name),
      keysChanged: () => {
        this.freeKeys();
        this.store.write({ keys: Object.fromEntries(this.own.map(action => [action.name, action.keys])) });
        this.listKeys();
      },
      closed: () => { this.devices.releaseAll(); this.sound.allow(); this.canvas.focus(); },
    };
  }
  openPanel() {
    this.leave();
    this.panel.open();
  }
  mute() {
    this.sound.toggle();
    this.store.write({ sound: this.sound.on });
    this.showSound();
  }
  showSound() {
    const button = document.querySelector('header .mute');
    button.setAttribute('aria-pressed', String(!this.sound.on));
    button.title = this.sound.on ? 'Sound off (F4)' : 'Sound on (F4)';
  }
  debug() {
    this.debugOn = !this.debugOn;
    this.game.showDebug(this.debugOn);
  }
  showTimes() { this.timesOn = !this.timesOn; }
  savePicture() {
    this.paint(1);
    this.canvas.toBlob(blob => save(`plumb-${this.name}-${this.game.ticks()}.png`, blob));
  }
  fillDisplay() {
    if (document.fullscreenElement) document.exitFullscreen();
    else document.documentElement.requestFullscreen?.().catch(() => this.say('This browser does not fill the display'));
  }
  say(text) { document.querySelector('#status').textContent = text; }

  // ---- from picture to picture

  /** The canvas has as many pixels as the display has there. */
  fit() {
    const { clientWidth, clientHeight } = this.canvas.parentElement, scale = devicePixelRatio || 1;
    const width = Math.max(1, Math.round(clientWidth * scale)), height = Math.max(1, Math.round(clientHeight * scale));
    if (this.canvas.width === width && this.canvas.height === height) return;
    Object.assign(this.canvas, { width, height });
    if (this.painted) this.paint(1);
  }
  tick() {
    const from = performance.now(), screen = this.game.screen();
    if (!this.game.tick(this.buttons())) return this.end();
    this.times.add(this.times.ticks, (performance.now() - from) / 1000);
    if (this.game.screen() === screen) return;
    this.keep();
    if (!this.game.isReplay()) this.say('');
  }
  paint(between) {
    this.painter.paint(this.game.draw(this.canvas.width, this.canvas.height, between, this.timesOn ? this.times.columns() : []));
    this.painted = true;
  }
  frame(now) {
    const seconds = Math.max(0, (now - this.before) / 1000), from = performance.now();
    this.before = now;
    try {
      this.left = Math.min(this.left + seconds, mostBehind);
      for (; this.left >= tickSeconds; this.left -= tickSeconds)
        if (!this.over && !this.panel.isOpen()) this.tick();
      this.paint(this.left / tickSeconds);
      this.sound.hear(this.game, Math.min(seconds, mostBehind));
    } catch (error) {
      this.say(`The game has stopped: ${error.message}`);
      throw error;
    }
    this.times.add(this.times.frames, (performance.now() - from) / 1000);
    this.times.add(this.times.intervals, seconds);
    requestAnimationFrame(later => this.frame(later));
  }
}

/** @param setup the game's name, home: where its menu's Quit leads, and source: its module, as loadGame() wants it */
export async function play(setup) {
  if (matchMedia('(pointer: coarse)').matches) document.body.classList.add('touch');
  const fonts = [500, 700, 900].map(weight => document.fonts.load(`${weight} 16px Inter`).catch(() => []));
  try {
    const [game] = await Promise.all([loadGame(setup.source), ...fonts]);
    const page = new GamePage(game, setup);
    page.start();
    return page;
  } catch (error) {
    document.querySelector('#status').textContent = `The game could not start: ${error.message}`;
    throw error;
  }
}
