// SPDX-License-Identifier: MIT
// How does a reader get the module? As one file that npm installs, as `npm pack` makes it.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/** Writes the file beside the module, and returns its name. */
export function writePackage(folder, site) {
  const { name, version, files } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = `${name}-${version}.tgz`;
  mkdirSync(join(site, 'download'), { recursive: true });
  execFileSync('tar', ['--create', '--gzip', `--file=${join(site, 'download', file)}`, `--directory=${folder}`, '--transform=s,^,package/,',
    '--owner=0', '--group=0', '--numeric-owner', '--mtime=1985-10-26', '--sort=name', 'package.json', ...files]);
  return file;
}
