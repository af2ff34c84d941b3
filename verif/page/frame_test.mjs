// SPDX-License-Identifier: Apache-2.0
// frame_test: the page of a frame says what the frame's files say, and does what is pressed.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {folder, in_print, opened, overflows, page_test, pipegs, text_of} from './tests.mjs';

const view = ['--scale', '0.375'];  // 384x288 pixels
const kLong = 'a_photograph_with_a_long_name_'.repeat(4) + '.png';
let made = false;

function frame() {
  if (!made) {
    fs.copyFileSync(truth(), path.join(folder, kLong));
    pipegs('sim', ...view, '--out', 'frame', '--page', '--against', path.join(folder, kLong));
  }
  made = true;
  return 'frame/page.html';
}

// A picture that is not the machine's: the float64 render.
function truth() {
  pipegs('render', ...view, '--model', 'truth', '--out', 'truth');
  return path.join(folder, 'truth/frame.png');
}

const report = () => JSON.parse(fs.readFileSync(path.join(folder, 'frame/report.json')));

// The codes of a pixel of a PNG, decoded by the browser.
function png_pixel(page, file, x, y) {
  const bytes = fs.readFileSync(path.join(folder, file)).toString('base64');
  return page.evaluate(async (text, at_x, at_y) => {
    const image = await createImageBitmap(await (await fetch('data:image/png;base64,' + text)).blob());
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    return Array.from(context.getImageData(at_x, at_y, 1, 1).data.slice(0, 3)).join(' ');
  }, bytes, x, y);
}

// Where a pixel of the picture lies in the window.
async function place_of(page, x, y) {
  await page.$eval('.picture', (canvas) => canvas.scrollIntoView({block: 'center'}));
  return page.$eval('.picture', (canvas, at_x, at_y) => {
    const box = canvas.getBoundingClientRect();
    return [box.left + (at_x + 0.5) / canvas.width * box.width, box.top + (at_y + 0.5) / canvas.height * box.height];
  }, x, y);
}

const said = (page, name) => text_of(page, `dd[data-layer="${name}"]`);
const canvas_pixel = (page, x, y) => page.$eval('.picture', (canvas, at_x, at_y) => {
  const context = new OffscreenCanvas(1, 1).getContext('2d');
  context.drawImage(canvas, -at_x, -at_y);
  return Array.from(context.getImageData(0, 0, 1, 1).data.slice(0, 3)).join(' ');
}, x, y);
async function choose(page, side, layer) { await page.select('#layer-' + side, layer); }
const split = (page, share) => page.$eval('#split', (slider, value) => {
  slider.value = value;
  slider.dispatchEvent(new Event('input'));
}, String(share));

page_test('a pixel under the pointer has the numbers of the files', frame, async (page) => {
  for (const [x, y] of [[10, 20], [200, 150], [383, 287]]) {
    await page.mouse.move(...await place_of(page, x, y));
    assert.equal(await said(page, 'pixel'), `${x}, ${y}`);
    assert.equal(await said(page, 'machine (RTL, bit for bit)'), await png_pixel(page, 'frame/frame.png', x, y));
    assert.equal(await said(page, 'float64, exact order'), await png_pixel(page, 'truth/frame.png', x, y));
    assert.equal(await said(page, kLong), await png_pixel(page, 'truth/frame.png', x, y));
    // The numbers stand in the page, however long the name of the photograph is.
    const [right, width] = await page.$eval(`dd[data-layer="${kLong}"]`,
                                            (cell) => [cell.getBoundingClientRect().right, window.innerWidth]);
    assert.ok(right <= width, `${right} of ${width}`);
  }
});

page_test('the photograph has its figures', frame, async (page) => {
  const {psnr_db, ssim} = report(), told = await text_of(page, '.figures');
  for (const text of [`${psnr_db.toFixed(2)} dB`, `SSIM ${ssim.toFixed(4)}`]) assert.ok(told.includes(text), told);
});

page_test('its line prints the Gaussians that it counts', frame, async (page) => {
  await page.mouse.move(...await place_of(page, 200, 150));
  const line = await text_of(page, '.explain code');
  const words = line.split(' ').slice(1);
  assert.equal(words[0], 'explain');
  const rows = JSON.parse(pipegs(...words, '--no-rtl', '--json')).gaussians;
  const blended = rows.filter((row) => row.golden.alpha > 0 && !row.golden.done).length;
  assert.equal(await said(page, 'Gaussians blended'), String(blended));
});

page_test('the slider shows the left layer on its left, the right one on its right', frame, async (page) => {
  await choose(page, 'left', 'machine');
  await choose(page, 'right', 'blended');
  const [machine, map] = [await canvas_pixel(page, 60, 100), await canvas_pixel(page, 300, 100)];
  assert.equal(machine, await png_pixel(page, 'frame/frame.png', 60, 100));
  assert.notEqual(map, await png_pixel(page, 'frame/frame.png', 300, 100));
  await split(page, 100);
  assert.equal(await canvas_pixel(page, 300, 100), await png_pixel(page, 'frame/frame.png', 300, 100));
  await split(page, 0);
  assert.notEqual(await canvas_pixel(page, 60, 100), machine);
});

page_test('every map has a bar of colors and says what it shows', frame, async (page) => {
  const names = await page.$$eval('#layer-right option', (options) => options.map((option) => option.value));
  for (const name of ['numeric', 'order', 'total', 'blended', 'transmittance', 'closed', 'cycles', 'blends'])
    assert.ok(names.includes(name), name);
  for (const name of names) {
    await choose(page, 'right', name);
    const picture = ['machine', 'exact', 'against'].includes(name);
    assert.equal((await page.$$('.scale')).length, picture ? 0 : 1, name);
  }
});

page_test('bars add up to 100 % and are the counters', frame, async (page) => {
  const {units, cycles} = report();
  const bars = await page.$$eval('.hundred', (found) => found.map((bar) => Object.fromEntries(
    Array.from(bar.children, (part) => [part.className, Number(part.dataset.share)]))));
  const counted = [...units.dopu, ...units.pu, ...units.su, ...units.ru];
  assert.equal(bars.length, counted.length);
  bars.forEach((bar, at) => {
    assert.ok(Math.abs(Object.values(bar).reduce((sum, share) => sum + share, 0) - 1) < 1e-5);
    for (const [state, share] of Object.entries(bar)) assert.ok(Math.abs(share - counted[at][state] / cycles) < 1e-6);
  });
  assert.match(await text_of(page, '#bound'), /at least .* cycles of .*: [\d.]+ % of the/);
  assert.equal((await page.$$('.says')).length, 4);
});

page_test('a click on a window zooms the timeline to it', frame, async (page) => {
  const whole = await text_of(page, '#range');
  await page.mouse.click(...await place_of(page, 300, 200));
  const zoomed = await text_of(page, '#range');
  assert.notEqual(zoomed, whole);
  const side = report().config.window;
  const name = await page.$eval('#timeline-window', (list) => list.selectedOptions[0].textContent);
  assert.ok(name.startsWith(`window ${Math.floor(300 / side)},${Math.floor(200 / side)}:`), name);
  await page.click('button[aria-label="whole frame"]');
  assert.equal(await text_of(page, '#range'), whole);
  await page.click('button[aria-label="zoom in"]');
  assert.notEqual(await text_of(page, '#range'), whole);
});

page_test('a hover over the timeline tells the states of every unit', frame, async (page) => {
  const timeline = await page.$('.timeline');
  await timeline.scrollIntoView();
  const box = await timeline.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + 60);
  await page.waitForFunction(() => document.querySelector('.tip')?.textContent.includes('RU 0'));
  const rows = await page.$$eval('.tip tr', (found) => found.map(
    (row) => [...row.children].map((cell) => cell.textContent)));
  assert.equal(rows.length, 1 + 13);
  // Of the place that the pointer is on: it is some way behind the middle, since names stand on the left.
  const number = (text) => Number(text.replace(/\u202f/g, ''));
  const [, from, to] = (await text_of(page, '.tip strong')).match(/cycles ([\d\u202f]+) to ([\d\u202f]+)/).map(number);
  const middle = (box.width / 2 - 74) / (box.width - 94) * report().cycles;
  assert.ok(from <= middle + 2000 && middle - 2000 <= to, `${from} to ${to}, not ${middle}`);
  // Shares of each unit are a whole, and it works in a window.
  for (const row of rows.slice(1)) {
    const sum = row.slice(1, 5).reduce((all, cell) => all + parseFloat(cell), 0);
    assert.ok(Math.abs(sum - 100) <= 2, row.join(' '));
  }
  assert.ok(rows.slice(1).some((row) => /^\d+,\d+/.test(row[5])), 'a window');
});

page_test('keys move the place, Enter pins it and says it', frame, async (page) => {
  await page.focus('.picture');
  await page.keyboard.press('ArrowRight');
  assert.equal(await said(page, 'pixel'), '193, 144');
  await page.keyboard.down('Shift');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.up('Shift');
  assert.equal(await said(page, 'pixel'), '193, 136');
  await page.keyboard.press('Enter');
  assert.match(await text_of(page, '[role=status]'), /^pixel 193, 136, window 1, 1: /);
  await page.keyboard.press('Escape');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await said(page, 'pixel'), '192, 136');
});

page_test('nothing is cut off in a narrow window, in the dark', frame, async (page) => {
  assert.equal(await overflows(page), 0);
}, {width: 420, height: 800, dark: true});

page_test('it prints to A4', frame, async (page) => {
  assert.equal(await overflows(page), 0);
  assert.ok(await in_print(page) >= 2);
});

page_test('a crop over a background, without RTL and truth', () => {
  pipegs('sim', ...view, '--crop', '100,50,77,61', '--no-rtl', '--no-truth', '--out', 'crop', '--page',
         '--background', '#ffffff');
  return 'crop/page.html';
}, async (page) => {
  await page.mouse.move(...await place_of(page, 5, 7));
  assert.equal(await said(page, 'pixel'), '105, 57');
  assert.equal(await said(page, 'machine (golden model)'), await png_pixel(page, 'crop/frame.png', 5, 7));
  assert.match(await text_of(page, '#bound'), /was not run/);
  assert.equal(await page.$('.timeline'), null);
});

page_test('hostile names stay text', () => {
  fs.copyFileSync(truth(), path.join(folder, '<img src=x onerror=alert(1)>.png'));
  pipegs('sim', ...view, '--no-rtl', '--no-truth', '--out', 'names', '--page', '--against',
         '<img src=x onerror=alert(1)>.png');
  return 'names/page.html';
}, async (page) => {
  assert.equal(await page.$('img[src=x]'), null);
  await page.mouse.move(...await place_of(page, 5, 7));
  assert.equal(await said(page, '<img src=x onerror=alert(1)>.png'), await png_pixel(page, 'truth/frame.png', 5, 7));
});
