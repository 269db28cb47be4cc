// SPDX-License-Identifier: MIT
// What was built, served on this machine, and a browser that looks at it.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url));
export const site = join(root, 'build/web/site');
export const games = ['maze', 'artillery', 'runner'];

const { chromium } = createRequire(join(root, 'build/node/node_modules/x.js'))('playwright-core');
const args = ['--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-background-networking', '--disable-sync'];
const types = { html: 'text/html', js: 'text/javascript', wasm: 'application/wasm', css: 'text/css', png: 'image/png', woff2: 'font/woff2' };

/** Serves a folder, or the site, while act(address) runs. */
export async function served(act, folder = site) {
  const server = createServer((request, response) => {
    if (request.url === '/favicon.ico') return void response.writeHead(204).end();
    let file = normalize(join(folder, decodeURIComponent(request.url.split('?')[0])));
    if (existsSync(file) && statSync(file).isDirectory()) file = join(file, 'index.html');
    if (!existsSync(file)) return void response.writeHead(404).end();
    response.writeHead(200, { 'Content-Type': types[file.split('.').pop()] ?? 'text/plain' }).end(readFileSync(file));
  });
  await new Promise(done => server.listen(0, '127.0.0.1', done));
  try { await act(`http://127.0.0.1:${server.address().port}/`); } finally { server.close(); }
}

/** A page's clock stands still; pump(n) lets n ticks pass, up to five of them between two pictures. */
function stopClock() {
  let next = null, now = 0;
  globalThis.requestAnimationFrame = draw => { next = draw; return 1; };
  performance.now = () => now;
  globalThis.pump = ticks => {
    for (let left = ticks; left > 0; left -= 5) {
      now += Math.min(left, 5) * 1000 / 60 + 1e-7;
      const draw = next;
      next = null;
      draw?.(now);
    }
  };
}

/** Opens a page while act(page, context) runs; fails when the page complains, or asks anything of another machine. */
export async function opened(url, { stopped = false, ...options }, act) {
  assert.ok(existsSync('/usr/bin/chromium'), 'Chromium is not installed');
  const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args });
  try {
    const context = await browser.newContext({ viewport: { width: 640, height: 400 }, acceptDownloads: true, ...options });
    const page = await context.newPage(), complaints = [];
    page.on('pageerror', error => complaints.push(error.message));
    page.on('console', message => message.type() === 'error' && complaints.push(message.text()));
    page.on('request', request => {
      const { protocol, hostname } = new URL(request.url());
      if (/^http/.test(protocol) && hostname !== '127.0.0.1') complaints.push(`asks for ${request.url()}`);
    });
    if (stopped) await page.addInitScript(stopClock);
    await page.goto(url);
    await act(page, context);
    assert.deepEqual(complaints, []);
  } finally { await browser.close(); }
}

/** Opens a game's page, when it runs. */
export const openedGame = (url, options, act) => opened(url, options, async (page, context) => {
  await page.waitForFunction(() => globalThis.gamePage, null, { polling: 50 });
  await act(page, context);
});
