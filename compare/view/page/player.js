// SPDX-License-Identifier: MIT
// Which moment is shown, and which comes next?

class Player {
    /// changed() is called whenever the time, the speed or the playing state has changed.
    constructor(changed) {
        this.changed = changed;
        this.times = [0];
        this.time = 0;
        this.speed = 1;
        this.playing = false;
        this.repeat = false;
        this.watch = {};  // of a stopwatch: from and until [s]; none at first
        this.known = Infinity;  // until then the run is computed [s]
        this.waiting = null;
    }
    get end() { return this.times[this.times.length - 1]; }
    get frame() { return indexAt(this.times, this.time); }

    load(times) {
        this.stop();
        this.times = times;
        this.time = 0;
        this.watch = {};
    }
    /// The first press begins, the second one stops, the third one clears.
    pressStopwatch() {
        const {from, until} = this.watch, now = this.times[this.frame];
        this.watch = from === undefined ? {from: now} : until === undefined ? {from, until: now} : {};
    }
    seek(time) {
        this.time = Math.min(Math.max(time, 0), this.end);
        this.changed();
    }
    seekFrame(frame) {
        this.seek(this.times[Math.min(Math.max(frame, 0), this.times.length - 1)]);
    }
    step(frames) {
        this.pause();
        this.seekFrame(this.frame + frames);
    }
    setSpeed(speed) {
        this.speed = speed;
        this.changed();
    }
    play() {
        if (this.playing) return;
        if (this.time >= this.end) this.time = 0;
        this.playing = true;
        this.last = performance.now();
        this.wait();
        this.changed();
    }
    pause() {
        if (!this.playing) return;
        this.stop();
        this.changed();
    }
    stop() {
        if (this.playing) this.stopWaiting();
        this.playing = false;
    }
    toggle() {
        if (this.playing) this.pause();
        else this.play();
    }
    /// Waits for the next frame. If the browser draws none, for example without a screen, a timer is used instead.
    wait() {
        const advance = () => {
            this.stopWaiting();
            this.advance(performance.now());
        };
        this.waiting = {frame: requestAnimationFrame(advance), timer: setTimeout(advance, 100)};
    }
    stopWaiting() {
        cancelAnimationFrame(this.waiting.frame);
        clearTimeout(this.waiting.timer);
    }
    advance(now) {
        // After a long pause, for example in a hidden tab, it continues near where it was.
        const passed = Math.min(0.25, Math.max(0, now - this.last) / 1000);
        this.last = now;
        this.time = Math.min(this.time + passed * this.speed, Math.max(this.time, this.known));
        if (this.time >= this.end && this.repeat) this.time = 0;
        if (this.time >= this.end) {
            this.time = this.end;
            this.playing = false;
        } else {
            this.wait();
        }
        this.changed();
    }
}
