// SPDX-License-Identifier: Apache-2.0
// screenshot_test: the page of our own frame looks as the picture of it in the README.
//
// Idea    Both are cut into blocks of 16x16 pixels; a block differs when its mean color does by more than a tenth. A
//         digit more or another hinting of letters changes no block, a style or a chart that is missing changes many.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {folder, page_test, pipegs, root} from './tests.mjs';

const reference = path.join(root, 'docs/images/pages/frame.png');
const kDiffering = 0.02, kSide = 16, kTenth = 25, kHeight = 1540;
const kind_of_page = {width: 1280, height: 900};

async function taken(page, name) {
  const file = path.join(folder, name);
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.screenshot({path: file, clip: {x: 0, y: 0, width: kind_of_page.width, height: kHeight}});
  return file;
}

// Share of the blocks that differ.
function differing(page, files) {
  const texts = files.map((file) => fs.readFileSync(file).toString('base64'));
  return page.evaluate(async (pictures, side, tenth) => {
    const [a, b] = await Promise.all(pictures.map(async (text) => {
      const image = await createImageBitmap(await (await fetch('data:image/png;base64,' + text)).blob());
      const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, image.width, image.height);
    }));
    if (a.width !== b.width || a.height !== b.height) return 1;
    const columns = Math.floor(a.width / side), rows = Math.floor(a.height / side);
    let different = 0;
    for (let block = 0; block < columns * rows; ++block) {
      const sums = [0, 0, 0];
      for (let k = 0; k < side * side; ++k) {
        const x = block % columns * side + k % side, y = Math.floor(block / columns) * side + Math.floor(k / side);
        for (let j = 0; j < 3; ++j) sums[j] += a.data[4 * (y * a.width + x) + j] - b.data[4 * (y * a.width + x) + j];
      }
      if (sums.some((sum) => Math.abs(sum) > tenth * side * side)) ++different;
    }
    return different / (columns * rows);
  }, texts, kSide, kTenth);
}

page_test('our own frame looks as in the README', () => {
  pipegs('sim', '--out', 'own', '--page');
  return 'own/page.html';
}, async (page) => {
  const shot = await taken(page, 'frame.png');
  assert.ok(fs.existsSync(reference), `there is no ${reference}: cp ${shot} ${reference}`);
  const share = await differing(page, [shot, reference]);
  assert.ok(share <= kDiffering, `${(100 * share).toFixed(1)} % of the blocks differ; when the page shall look as it ` +
                                 `does now: cp ${shot} ${reference}`);
  // Without its style it must not pass.
  await page.evaluate(() => document.querySelector('style').remove());
  assert.ok(await differing(page, [await taken(page, 'bare.png'), reference]) > kDiffering);
}, kind_of_page);
