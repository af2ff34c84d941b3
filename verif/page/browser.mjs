// SPDX-License-Identifier: Apache-2.0
// browser.mjs: pages as a reader meets them: headless Chromium, opened from a file, without a network.
//
// Idea    A test is `page_test(name, make, look)`: `make` runs pipegs and gives the page's file, `look` gets the opened
//         page. Whatever the page complains of (an exception, console.error, a request that leaves the file) fails
//         the test after `look`, too.
// Needs   PIPEGS, the program; PAGE, the folder of the page's libraries with the browser's driver; FOLDER, to write in.
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';
import test, {after} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';

const puppeteer = createRequire(path.join(process.env.PAGE, 'package.json'))('puppeteer-core');
export const folder = process.env.FOLDER;
export const root = path.join(path.dirname(fileURLToPath(import.meta.url)), '../..');
export const shared = process.env.PIPEGS_SHARED ?? path.join(root, '../shared');

const chromium = ['chromium', 'chromium-browser', 'google-chrome'].map((name) => {
  const found = spawnSync('sh', ['-c', `command -v ${name}`], {encoding: 'utf8'});
  return found.stdout.trim();
}).find((name) => name !== '');
// No GPU here: WebGL runs on the processor.
const options = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--hide-scrollbars',
                 '--force-color-profile=srgb', '--font-render-hinting=none'];

// What pipegs prints; a failure shows its line and what it said.
export function pipegs(...words) {
  return execFileSync(process.env.PIPEGS, words, {cwd: folder, encoding: 'utf8', maxBuffer: 1 << 28});
}

let browser = null;  // one for all tests of a file
after(() => browser?.close());

export async function opened(file, {width = 1280, height = 900, dark = false} = {}) {
  browser ??= await puppeteer.launch({executablePath: chromium, args: options, headless: true});
  const page = await browser.newPage();
  const complaints = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => {
    if (['error', 'warn'].includes(message.type())) complaints.push(message.text());
  });
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push('a request to ' + request.url());
  });
  await page.setViewport({width, height});
  await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'}]);
  await page.goto(pathToFileURL(path.resolve(folder, file)).href);
  await page.waitForSelector('html[data-ready=yes]', {timeout: 120000});
  return {page, complaints};
}

export function page_test(name, make, look, view = {}) {
  test(name, {timeout: 600000}, async () => {
    const file = path.resolve(folder, await make());
    assert.ok(fs.statSync(file).size < 5e6, `${file} has ${fs.statSync(file).size} bytes, at most 5 MB`);
    const {page, complaints} = await opened(file, view);
    try {
      await look(page, file);
      assert.deepEqual(complaints, []);
    } finally {
      await page.close();
    }
  });
}

// The text of the first element that matches.
export const text_of = (page, selector) => page.$eval(selector, (found) => found.textContent.trim());
// No element is wider than the window: nothing is cut off, and only what is made to scroll scrolls.
export const overflows = (page) => page.evaluate(
  () => document.documentElement.scrollWidth - document.documentElement.clientWidth);
// Pages of A4 that it prints to.
export async function in_print(page) {
  const pdf = Buffer.from(await page.pdf({format: 'A4'})).toString('latin1');
  return pdf.match(/\/Type\s*\/Page\b/g).length;
}
