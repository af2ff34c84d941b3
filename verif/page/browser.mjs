// SPDX-License-Identifier: Apache-2.0
// browser.mjs: pages as a reader meets them: headless Chromium, opened from a file, without a network.
//
// Needs   PIPEGS, the program; PAGE, the folder of the page's libraries with the browser's driver; FOLDER, to write in.
import {execFileSync, spawnSync} from 'node:child_process';
import {createRequire} from 'node:module';
import path from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

const puppeteer = createRequire(path.join(process.env.PAGE, 'package.json'))('puppeteer-core');
export const folder = process.env.FOLDER;
export const root = path.join(path.dirname(fileURLToPath(import.meta.url)), '../..');

const chromium = ['chromium', 'chromium-browser', 'google-chrome'].map((name) => {
  const found = spawnSync('sh', ['-c', `command -v ${name}`], {encoding: 'utf8'});
  return found.stdout.trim();
}).find((name) => name !== '');
// No GPU here: WebGL runs on the processor.
const options = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--hide-scrollbars',
                 '--disable-dev-shm-usage', '--force-color-profile=srgb', '--font-render-hinting=none'];

// What pipegs prints; a failure shows its line and what it said.
export function pipegs(...words) {
  return execFileSync(process.env.PIPEGS, words, {cwd: folder, encoding: 'utf8', maxBuffer: 1 << 28});
}

let browser = null;  // one for all pages of a run
export const closed = () => browser?.close();

// `complaints` fills with exceptions, errors and warnings of the console, and requests that leave the file.
export async function opened(file, {width = 1280, height = 900, dark = false, timeout = 120000} = {}) {
  browser ??= await puppeteer.launch({executablePath: chromium, args: options, headless: true});
  const page = await browser.newPage();
  const complaints = [];
  const failed = new Promise((_, reject) => page.on('pageerror', (error) => {
    complaints.push(String(error));
    reject(error);
  }));
  failed.catch(() => {});  // it counts while the page opens, later `complaints` does
  page.on('console', (message) => {
    if (['error', 'warn'].includes(message.type())) complaints.push(message.text());
  });
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push('a request to ' + request.url());
  });
  await page.setViewport({width, height});
  await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'}]);
  await page.goto(pathToFileURL(path.resolve(folder, file)).href);
  await Promise.race([failed, page.waitForSelector('html[data-ready=yes]', {timeout})]);
  return {page, complaints};
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
