// SPDX-License-Identifier: MIT
// Does `npm pack` make a package that a program can import by its name?
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { folder } from './plumb.mjs';

test('npm pack makes a package with the module, its types and the script for pages from disk', () => {
  const place = mkdtempSync(join(tmpdir(), 'plumb-pack-')), home = join(place, 'node_modules/plumb-physics');
  const [packed] = JSON.parse(execFileSync('npm', ['pack', '--json', '--pack-destination', place], { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }));
  assert.deepEqual(packed.files.map(file => file.path).sort(),
    ['LICENSE', 'README.md', 'package.json', 'plumb.d.ts', 'plumb.inline.js', 'plumb.js', 'plumb.wasm']);
  mkdirSync(home, { recursive: true });
  execFileSync('tar', ['-xzf', join(place, packed.filename), '-C', home, '--strip-components=1']);
  writeFileSync(join(place, 'program.mjs'), "import { load } from 'plumb-physics';\nconst { World } = await load();\nconsole.log(new World().gravity()[1]);\n");
  assert.equal(execFileSync(process.execPath, ['program.mjs'], { cwd: place, encoding: 'utf8' }).trim(), '-9.81');
});
