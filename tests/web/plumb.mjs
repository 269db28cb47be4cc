// SPDX-License-Identifier: MIT
// The module under test: that of the folder in PLUMB_PACKAGE.
import { pathToFileURL } from 'node:url';

export const folder = process.env.PLUMB_PACKAGE ?? new URL('../../build/web/package', import.meta.url).pathname;
export const { load } = await import(pathToFileURL(`${folder}/plumb.js`));
export const plumb = await load();
