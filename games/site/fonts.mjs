// SPDX-License-Identifier: MIT
// The font Inter, of which a page loads only the letters that games and pages use.
import { execFileSync } from 'node:child_process';
import { mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';

const styles = { 500: 'Medium', 700: 'Bold', 900: 'Black' };
const letters = '20-7E,A0-FF,2010-2026,2039,203A,2190-2193,2212,221A,2264,2265';

/** Writes a file for each weight, and returns their names by weight. */
export function writeFonts(folder) {
  mkdirSync(folder, { recursive: true });
  return Object.fromEntries(Object.entries(styles).map(([weight, style]) => {
    const source = execFileSync('fc-match', ['-f', '%{file}', `Inter:style=${style}`], { encoding: 'utf8' });
    if (!/inter/i.test(source)) throw new Error(`the font Inter (${style}) is not installed; Debian has it as fonts-inter`);
    const file = join(folder, `inter-${weight}.otf`);
    execFileSync('hb-subset', [`--unicodes=${letters}`, `--output-file=${file}`, source]);
    execFileSync('woff2_compress', [file], { stdio: 'ignore' });
    rmSync(file);
    return [weight, `inter-${weight}.woff2`];
  }));
}

/** @param urlOf where the file of a weight is */
export function fontFaces(urlOf) {
  return Object.keys(styles).map(weight =>
    `@font-face { font-family: Inter; font-weight: ${weight}; src: url("${urlOf(weight)}") format("woff2"); font-display: swap; }\n`).join('');
}
