// SPDX-License-Identifier: MIT
// Plays a game's sound. A browser allows it from the first press on.

const rate = 48000, ahead = 0.08;  // [samples/s], [s]

export class Sound {
  constructor(on) { this.on = on; this.next = 0; }

  /** Called when something was pressed. */
  allow() {
    if (!globalThis.AudioContext) return;
    this.context ??= new AudioContext({ sampleRate: rate });
    if (this.context.state !== 'running') this.context.resume().catch(() => {});
  }
  toggle() { this.on = !this.on; }
  pause() { this.context?.suspend().catch(() => {}); }

  /** Takes what the game sounds like since the last call; seconds: how long ago that was. */
  hear(game, seconds) {
    const heard = this.on && this.context?.state === 'running';
    if (!heard) return void game.mix(Math.round(seconds * rate));  // it goes by unheard
    const now = this.context.currentTime;
    this.next = Math.max(this.next, now + 0.02);
    const count = Math.round((now + ahead - this.next) * rate);
    if (count < 128) return;
    const buffer = this.context.createBuffer(1, count, rate), node = this.context.createBufferSource();
    buffer.copyToChannel(game.mix(count), 0);
    node.buffer = buffer;
    node.connect(this.context.destination);
    node.start(this.next);
    this.next += count / rate;
  }
}
