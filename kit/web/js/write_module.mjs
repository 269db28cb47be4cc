// SPDX-License-Identifier: MIT
// Writes what goes with plumb.wasm: node write_module.mjs hash SCHEMA HEADER, before it is compiled, and
// node write_module.mjs module SCHEMA WASM KIT FOLDER VERSION, after that.
import { mkdirSync, readFileSync, writeFileSync, copyFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

import { commentsOf } from './headers.mjs';
import { joined } from './join.mjs';
import { typesOf } from './types.mjs';

const here = dirname(fileURLToPath(import.meta.url));

/** What both sides have to agree on: names, kinds and order, but no meanings. FNV-1a. */
function hashOf(text) {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; ++i) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193) >>> 0;
  return hash;
}

/** Each after those that it imports. */
const runtimeFiles = ['refusals.js', 'ids.js', 'hints.js', 'writer.js', 'reader.js', 'guards.js', 'shown.js',
                      'poses_before.js', 'runtime.js'];

/** The schema, in which a tag is a kind of its own: a label that is compared, no bits that are combined. */
function schemaIn(file) {
  const schema = JSON.parse(readFileSync(file, 'utf8')), isTag = name => /tag$/i.test(name);
  const named = (name, kind) => (kind === 'bits' && isTag(name) ? 'tag' : kind);
  for (const members of Object.values(schema.types))
    for (const member of members) member.kind = named(member.name, member.kind);
  for (const call of schema.calls) call.result = named(call.name, call.result);
  return schema;
}

function compact(schema) {
  const types = Object.fromEntries(Object.entries(schema.types).map(([name, members]) =>
    [name, members.map(({ name, kind, value }) => ({ name, kind, value }))]));
  return JSON.stringify({ ...schema, types });
}

function writeHash(schemaFile, header) {
  const text = compact(schemaIn(schemaFile));
  writeFileSync(header, `// Written by write_module.mjs.\n#pragma once\n#include <cstdint>\n\n` +
    `namespace plumb::web {\ninline constexpr std::uint32_t schemaHash = ${hashOf(text)}u;\n}\n`);
}

function writeModule(schemaFile, wasm, kit, folder, version) {
  const schema = schemaIn(schemaFile), text = compact(schema);
  const runtime = joined(here, runtimeFiles), bytes = readFileSync(wasm);
  const heading = `// Plumb ${version}, a 2D physics kit. SPDX-License-Identifier: MIT\n` +
    '// Written by the build from the descriptions of the kit.\n';
  const data = `const schema = ${text};\nconst schemaHash = ${hashOf(text)};\n`;
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'plumb.js'),
    `${heading}${data}const wasmSource = () => new URL('plumb.wasm', import.meta.url);\n\n${runtime}`);
  const packed = gzipSync(bytes, { level: 9 }).toString('base64');
  writeFileSync(join(folder, 'plumb.inline.js'),
    `${heading}// A plain script for pages that are opened from disk: const { World } = await plumb.load();\n` +
    `globalThis.plumb = (() => {\n${data}const packed = '${packed}';\n` +
    `const wasmSource = async () => {\n` +
    `  const bytes = Uint8Array.from(atob(packed), c => c.charCodeAt(0));\n` +
    `  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));\n` +
    `  return new Response(stream).arrayBuffer();\n};\n\n` +
    `${runtime.replace(/^export default.*$/m, '').replace(/^export /gm, '')}\n` +
    `return { load, contactColumns, eventColumns, eventKinds, unlimited };\n})();\n`);
  writeFileSync(join(folder, 'plumb.d.ts'), typesOf(schema, commentsOf(kit), heading));
  writeFileSync(join(folder, 'package.json'), `${JSON.stringify({
    name: 'plumb-physics', version, description: 'A 2D physics kit for games and lessons, in WebAssembly',
    license: 'MIT', type: 'module', main: './plumb.js', types: './plumb.d.ts', sideEffects: false,
    exports: { '.': { types: './plumb.d.ts', default: './plumb.js' }, './plumb.wasm': './plumb.wasm',
               './plumb.inline.js': './plumb.inline.js' },
    files: ['plumb.js', 'plumb.d.ts', 'plumb.wasm', 'plumb.inline.js', 'README.md', 'LICENSE'],
  }, null, 2)}\n`);
  copyFileSync(wasm, join(folder, 'plumb.wasm'));
  copyFileSync(join(here, '..', 'README.md'), join(folder, 'README.md'));
  copyFileSync(join(here, '..', '..', '..', 'LICENSE'), join(folder, 'LICENSE'));
}

const [what, ...rest] = process.argv.slice(2);
({ hash: writeHash, module: writeModule })[what](...rest);
