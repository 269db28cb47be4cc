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
    for (let count = next(); count > 0; --count) pen.lineTo(next(), next());
    if (closed) pen.closePath();
  }
  const outlines = [rect, ellipse, path], textKind = 3;

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
    const m = d.subarray(at, at += 6), opacity = next(), width = next(), clip = next();
    const bounds = clip >= 0 ? d.subarray(at, at += 4) : null;
    if (clip !== clipNow) clipTo(bounds);
    pen.globalAlpha = opacity;
    pen.setTransform(m[0], m[1], m[2], m[3], m[4], m[5]);
    const ink = paint(), kind = next();
    if (kind === textKind) {
      text(m, ink);
      return clip;
    }
    pen.beginPath();
    outlines[kind]();
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
