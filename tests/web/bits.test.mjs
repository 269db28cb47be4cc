// SPDX-License-Identifier: MIT
// Does WebAssembly come to the same bits as the machine it runs on?
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';

import { root } from './plumb.mjs';

const hashes = (file, ...args) => execFileSync(file, args, { encoding: 'utf8' }).trim().split('\n');

test('all worlds and scenes of tests/bits have the hashes of native code', () => {
  const native = hashes(`${root}build/release/bin/bits`);
  const here = hashes(process.execPath, '--no-warnings', `${root}kit/web/run.mjs`, `${root}build/web/bin/bits.wasm`);
  assert.ok(native.length > 80);
  assert.deepEqual(here, native);
});
