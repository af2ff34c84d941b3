// SPDX-License-Identifier: Apache-2.0
// viewer_test.mjs: the page of `pipegs sim --viewer`: Spark's picture is the machine's within what was measured, from
// the frame's camera and from no other, and by what is chosen.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';

import {folder, overflows, page_test, pipegs, text_of} from './tests.mjs';

const small = ['sim', '--no-rtl', '--no-truth', '--scale', '0.2'];
const psnr = async (page) => Number((await text_of(page, '#psnr')).replace(' dB', ''));

function made(name, ...more) {
  pipegs(...small, ...more, '--out', name, '--viewer');
  return name + '/viewer.html';
}

// What `act` does is drawn and compared.
async function after(page, act) {
  const measured = () => Number(document.documentElement.dataset.measured);
  const before = await page.evaluate(measured);
  await act();
  await page.waitForFunction((count) => Number(document.documentElement.dataset.measured) > count, {timeout: 60000},
                             before);
  return psnr(page);
}

page_test('the viewer shows what the machine does, from its camera', () => made('frame'), async (page) => {
  const at_frame = await psnr(page);
  assert.ok(at_frame > 38.5, `Spark against the machine: ${at_frame} dB, 40.3 were measured`);
  assert.equal(await page.$eval('#back', (button) => button.disabled), true);
  assert.ok(await overflows(page) <= 0);

  await page.focus('#spark');
  const away = await after(page, () => page.keyboard.press('ArrowLeft'));
  assert.ok(away < at_frame - 10, `from another camera: ${away} dB`);
  assert.match(await text_of(page, '#machine-figure figcaption'), /viewer is elsewhere/);
  const {x, y, width, height} = await (await page.$('#spark')).boundingBox();
  const dragged = await after(page, async () => {
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 4, y + height / 2, {steps: 3});
    await page.mouse.up();
  });
  assert.ok(dragged < at_frame - 10 && dragged !== away, `dragged: ${dragged} dB`);
  assert.equal(await after(page, () => page.click('#back')), at_frame);
  assert.doesNotMatch(await text_of(page, '#machine-figure figcaption'), /elsewhere/);

  const own = await after(page, () => page.select('#choice', 'own'));
  assert.ok(own < at_frame - 5, `with its own settings: ${own} dB`);
  assert.equal(await after(page, () => page.select('#choice', 'machine')), at_frame);
  assert.match(await text_of(page, '#reduced'), /rounded to those of \.spz/);
  const command = await text_of(page, '.command code');
  assert.match(command, /sim --scale 0\.2 .*--viewer/);
});

// The first Gaussians of our own scene.
function few_ply() {
  pipegs('convert', '--out', 'own');
  const whole = fs.readFileSync(path.join(folder, 'own/scene.ply')), head = whole.indexOf('end_header\n') + 11;
  const few = 6000, text = whole.subarray(0, head).toString().replace(/vertex \d+/, 'vertex ' + few);
  fs.writeFileSync(path.join(folder, 'few.ply'),
                   Buffer.concat([Buffer.from(text), whole.subarray(head, head + 248 * few)]));
  return 'few.ply';
}

page_test('a crop over a background, and a scene in its own floats',
          () => made('crop', few_ply(), '--crop', '20,10,97,61', '--background', '200,40,90'), async (page) => {
  assert.deepEqual(await page.$eval('#spark', (canvas) => [canvas.width, canvas.height]), [97, 61]);
  assert.ok(await psnr(page) > 45, `${await psnr(page)} dB`);
  assert.match(await text_of(page, '#reduced'), /those of the file/);
}, {dark: true});

page_test('a sequence has a picture for each frame, and the cameras go together',
          () => made('sequence', few_ply(), '--orbit', '3', '--views', 'all'), async (page) => {
  const first = await psnr(page);
  const second = await after(page, () => page.select('#frame', '1'));
  assert.notEqual(second, first);
  assert.ok(Math.min(first, second) > 45, `${first} and ${second} dB`);
  assert.equal(await after(page, () => page.select('#frame', '0')), first);
});

test('what is too large for a page is refused before anything is computed', () => {
  assert.throws(() => pipegs(...small, '--orbit', '2000', '--views', 'all', '--out', 'no', '--viewer'),
                (error) => error.status === 2 && /^pipegs: --viewer: found frames of/.test(error.stderr) &&
                  error.stderr.trim().split('\n').length === 1);
  assert.ok(!fs.existsSync(path.join(folder, 'no/viewer.html')));
});
