// SPDX-License-Identifier: MIT
// The module under test, where it was built, and the packages that the tests use.
import { fileURLToPath, pathToFileURL } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url));
export const folder = `${root}build/web/package`;
export const nodeModules = `${root}build/node/node_modules`;
export const { load } = await import(pathToFileURL(`${folder}/plumb.js`));
export const plumb = await load();
