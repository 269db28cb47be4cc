// SPDX-License-Identifier: MIT
// Several modules as one text: each after those that it imports, without its imports.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

/** The exports stay in the last file alone. So no two files may give one name to two things. */
export function joined(folder, names) {
  const texts = names.map(name => readFileSync(join(folder, name), 'utf8').replace(/^import .*\n/gm, ''));
  return texts.map((text, i) => i + 1 < texts.length ? text.replace(/^export /gm, '') : text).join('\n');
}
