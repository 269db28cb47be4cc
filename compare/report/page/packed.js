// SPDX-License-Identifier: MIT
// What did each engine do at each moment? The data's numbers are unpacked when a scene is first needed.

/// Scenes of one group are put together, in the order in which the groups first appear.
function readReport() {
    const report = JSON.parse(byId("data").textContent);
    for (const scene of report.scenes) scene.group ||= "Others";
    const groups = [...new Set(report.scenes.map(({group}) => group))];
    report.scenes.sort((a, b) => groups.indexOf(a.group) - groups.indexOf(b.group));
    return report;
}

/// Base64 of little-endian doubles. The page needs a little-endian machine, as all browsers have.
function unpack(text) {
    return new Float64Array(bytesOf(text).buffer);
}

/// The words of a block. It has the lowest byte of every word first, then the next one: see
/// compare/report/packed_numbers.h.
async function wordsOf(packed) {
    const bytes = await through(new DecompressionStream("deflate"), bytesOf(packed));
    const count = bytes.length / 4;
    const words = new Uint32Array(count);
    for (let i = 0; i < count; ++i) {
        words[i] = bytes[i] | (bytes[count + i] << 8) | (bytes[2 * count + i] << 16) | (bytes[3 * count + i] << 24);
    }
    return words;
}

/// 0, 1, 2, 3, ... become 0, -1, 1, -2, ...
function unfolded(word) {
    return (word >>> 1) ^ -(word & 1);
}

function floatsOf(words, part) {
    if (!part) return null;
    const [first, count] = part;
    const bits = new Int32Array(count);
    for (let i = 0, before = 0; i < count; ++i) bits[i] = before = (before + unfolded(words[first + i])) | 0;
    return new Float32Array(bits.buffer);
}

const NO_STEPS = -(2 ** 31);

/// Writes one series of whole steps to every stride-th place of numbers; NaN if there is no number.
function readSteps(words, first, count, step, origin, numbers, at, stride) {
    let before = 0;
    let change = 0;
    for (let i = 0; i < count; ++i) {
        const word = (before + change + unfolded(words[first + i])) | 0;
        change = (word - before) | 0;
        before = word;
        numbers[at + i * stride] = word === NO_STEPS ? NaN : origin + word * step;
    }
}

/// x, y and angle of every body of the engine, frame by frame.
function posesOf(words, engine, scene) {
    const [first, count] = engine.states;
    const numbers = new Float64Array(count);
    const columns = 3 * engine.bodies.length;
    const frames = columns > 0 ? count / columns : 0;
    for (let column = 0; column < columns; ++column) {
        const step = column % 3 === 2 ? scene.angleStep : scene.lengthStep;
        const origin = scene.bodies[engine.bodies[Math.floor(column / 3)]].start[column % 3];
        readSteps(words, first + column * frames, frames, step, origin, numbers, column, columns);
    }
    return numbers;
}

function keptTicks(last, stride) {
    const ticks = [];
    for (let tick = 0; tick < last; tick += stride) ticks.push(tick);
    ticks.push(last);
    return ticks;
}

/// The moments of a curve's points: see compare/report/curve.h.
function curveTimes(scene) {
    const stride = scene.curveStride;
    if (stride === 1) return Float64Array.from({length: scene.steps + 1}, (_, tick) => tick * scene.dt);
    const count = 2 * Math.ceil((scene.steps + 1) / stride);
    const tick = (j) => Math.floor(j / 2) * stride + ((j % 2) * stride) / 2;
    return Float64Array.from({length: count}, (_, j) => tick(j) * scene.dt);
}

function unpackEngine(words, engine, scene) {
    if (engine.unsupported) return;
    engine.slots = new Map(engine.bodies.map((body, slot) => [body, slot]));
    engine.poses = posesOf(words, engine, scene);
    for (const curve of ["error", "divergence", "energy"]) engine[curve] = floatsOf(words, engine[curve]);
    engine.probes = engine.probes.map((probe) => floatsOf(words, probe));
    for (const named of ["energies", "forces"]) {
        engine[named] = engine[named].map(([name, curve]) => ({name, values: floatsOf(words, curve)}));
    }
    // The kind without a curve is what the others leave of the sum.
    const others = engine.energies.filter(({values}) => values);
    const rest = (energy, tick) => others.reduce((left, {values}) => left - values[tick], energy);
    for (const kind of engine.energies) kind.values ??= engine.energy.map(rest);
}

async function unpackNow(scene) {
    const words = await wordsOf(scene.packed);
    scene.ticks = keptTicks(scene.steps, scene.stride);
    scene.times = Float64Array.from(scene.ticks, (tick) => tick * scene.dt);
    scene.curveTimes = curveTimes(scene);
    for (const engine of scene.engines) unpackEngine(words, engine, scene);
    for (const body of scene.bodies) body.reach = reach(body);
    scene.running = scene.engines.filter((engine) => !engine.unsupported);
    delete scene.packed;
}

/// Done only once, however often it is called.
function readyScene(scene) {
    scene.unpacked ??= unpackNow(scene);
    return scene.unpacked;
}
