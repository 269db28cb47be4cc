// SPDX-License-Identifier: MIT
// Paints a game's marks on a canvas. The order of the numbers is that of mark_row.cpp.

const weights = [500, 700, 900];
const fontOf = (weight, size) => `${weights[weight]} ${size}px Inter, system-ui, sans-serif`;

/** The widths of texts in a font of size 100; measuring takes longer than painting. */
class Fonts {
  constructor(pen) { this.pen = pen; this.known = new Map(); this.capHeights = new Map(); }

  /** The parts of a text, each with its width: every figure has the room of a 0, so that a number that counts does not jump. */
  partsOf(text, weight) {
    const key = weight + text;
    let parts = this.known.get(key);
    if (parts) return parts;
    if (this.known.size > 2000) this.known.clear();
    this.pen.font = fontOf(weight, 100);
    const width = part => this.pen.measureText(part).width / 100, room = width('0');
    parts = (text.match(/[0-9]|[^0-9]+/g) ?? []).map(part =>
      /[0-9]/.test(part) ? { part, width: room, shift: (room - width(part)) / 2 } : { part, width: width(part), shift: 0 });
    parts.width = parts.reduce((sum, part) => sum + part.width, 0);
    this.known.set(key, parts);
    return parts;
  }
  capHeight(weight) {
    if (!this.capHeights.has(weight)) {
      this.pen.font = fontOf(weight, 100);
      this.capHeights.set(weight, this.pen.measureText('H').actualBoundingBoxAscent / 100);
    }
    return this.capHeights.get(weight);
  }
}

export function painterOn(canvas) {
  const pen = canvas.getContext('2d', { alpha: false }), fonts = new Fonts(pen);
  let d, at, words;
  const next = () => d[at++];
  const color = () => `rgba(${next() * 255},${next() * 255},${next() * 255},${next()})`;

  function paint() {
    if (!next()) return color();
    const fromX = next(), fromY = next(), toX = next(), toY = next(), radius = next();
    const gradient = radius > 0 ? pen.createRadialGradient(fromX, fromY, 0, fromX, fromY, radius)
                                : pen.createLinearGradient(fromX, fromY, toX, toY);
    gradient.addColorStop(0, color());
    gradient.addColorStop(1, color());
    return gradient;
  }

  function rect() {
    const x = next(), y = next(), w = next(), h = next(), radius = Math.min(next(), Math.abs(w) / 2, Math.abs(h) / 2);
    if (radius > 0) pen.roundRect(x, y, w, h, radius);
    else pen.rect(x, y, w, h);
  }
  function ellipse() {
    const x = next(), y = next(), rx = next(), ry = next(), from = next(), to = next(), pie = next(), whole = from === to;
    if (!(rx > 0 && ry > 0)) return;
    if (pie) pen.moveTo(x, y);
    pen.ellipse(x, y, rx, ry, 0, from, whole ? from + 2 * Math.PI : to, !whole && to < from);
    if (pie || whole) pen.closePath();
  }
  function path() {
    const closed = next();
    for (let i = 0, count = next(); i < count; ++i) pen[i ? 'lineTo' : 'moveTo'](next(), next());
    if (closed) pen.closePath();
  }
  const outlines = [rect, ellipse, path], rectKind = 0, pathKind = 2, textKind = 3;

  /** What comes next begins with the numbers from start to end. */
  function comesAgain(start, end) {
    let i = start;
    while (i < end && d[i] === d[at + i - start]) ++i;
    return i === end;
  }

  /**
   * Paints a gradient straight up or down in a plain rectangle as bands of one color each, and tells whether it did.
   * Without a GPU, a browser takes ten times as long for a gradient as for plain colors.
   */
  function bands(m, paintAt) {
    const [, fromX, fromY, toX, toY, radius, ...colors] = d.subarray(paintAt, paintAt + 14);
    const [x, y, w, h, corner] = d.subarray(at, at + 5), across = m[1] || m[2] || fromX !== toX || fromY === toY;
    if (radius || corner || across || colors[3] < 1 || colors[7] < 1) return false;
    at += 5;
    const down = value => m[3] * value + m[5], isDown = down(toY) > down(fromY);
    const first = colors.slice(isDown ? 0 : 4), last = colors.slice(isDown ? 4 : 0);
    const start = Math.min(down(fromY), down(toY)), length = Math.abs(down(toY) - down(fromY));
    const top = Math.min(down(y), down(y + h)), bottom = Math.max(down(y), down(y + h));
    const count = Math.max(1, ...[0, 1, 2].map(i => Math.ceil(255 * Math.abs(last[i] - first[i]))));
    const edge = i => Math.min(bottom, Math.max(top, Math.round(start + length * (i - 0.5) / count)));
    pen.setTransform(1, 0, 0, 1, 0, 0);
    for (let i = 0; i <= count; ++i) {
      const from = i > 0 ? edge(i) : top, to = i < count ? edge(i + 1) : bottom;
      if (from >= to) continue;
      pen.fillStyle = `rgb(${[0, 1, 2].map(k => 255 * (first[k] + (last[k] - first[k]) * i / count))})`;
      pen.fillRect(m[0] * x + m[4], from, m[0] * w, to - from);
    }
    return true;
  }

  function text(m, ink) {
    const x = next(), y = next(), said = words(next(), next());
    let size = next();
    const fitWidth = next(), align = next(), baseline = next(), weight = next();
    const scale = Math.hypot(m[0], m[1]);
    if (size * scale < 1) return;
    const turn = m[0] < 0 ? -1 : 1, ax = turn * m[0] / scale, ay = turn * m[1] / scale;  // never upside down
    const parts = fonts.partsOf(said, weight);
    if (fitWidth > 0) size = Math.min(size, fitWidth / parts.width);
    const pixels = size * scale, cap = fonts.capHeight(weight) * pixels;
    pen.setTransform(ax, ay, -ay, ax, m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5]);
    pen.font = fontOf(weight, pixels);
    pen.fillStyle = ink;
    let left = -parts.width * pixels * [0, 0.5, 1][align];
    const down = [0, cap, cap / 2][baseline];
    for (const { part, width, shift } of parts) {
      pen.fillText(part, left + shift * pixels, down);
      left += width * pixels;
    }
  }

  function clipTo(clip) {
    pen.restore();
    pen.save();
    pen.lineCap = pen.lineJoin = 'round';
    if (!clip) return;
    const [x, y, w, h] = clip, left = Math.round(x), top = Math.round(y);
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.beginPath();
    pen.rect(left, top, Math.round(x + w) - left, Math.round(y + h) - top);
    pen.clip();
  }

  function mark(clipNow) {
    const start = at, m = d.subarray(at, at += 6), opacity = next(), width = next(), clip = next();
    const bounds = clip >= 0 ? d.subarray(at, at += 4) : null;
    if (clip !== clipNow) clipTo(bounds);
    pen.globalAlpha = opacity;
    pen.setTransform(m[0], m[1], m[2], m[3], m[4], m[5]);
    const paintAt = at, isGradient = d[at] === 1, ink = paint(), kind = next(), end = at;
    if (isGradient && kind === rectKind && width === 0 && bands(m, paintAt)) return clip;
    if (kind === textKind) {
      text(m, ink);
      return clip;
    }
    pen.beginPath();
    outlines[kind]();
    // Lines of one color and width are one path: blades of grass are hundreds. Not where light would shine through both.
    const isOpaque = !isGradient && opacity === 1 && d[paintAt + 4] === 1;
    while (isOpaque && kind === pathKind && width > 0 && comesAgain(start, end)) { at += end - start; path(); }
    if (width > 0) { pen.lineWidth = width; pen.strokeStyle = ink; pen.stroke(); }
    else { pen.fillStyle = ink; pen.fill(); }
    return clip;
  }

  return {
    /** marks: of the game's draw(), for the canvas's own size. */
    paint(marks) {
      d = marks.numbers;
      words = marks.words;
      at = 0;
      let clip = -1;
      clipTo(null);
      while (at < d.length) clip = mark(clip);
    },
  };
}
