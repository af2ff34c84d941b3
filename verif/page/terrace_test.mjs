// SPDX-License-Identifier: Apache-2.0
// terrace_test: the page of a real frame at full size: terrace, view 0. Skipped without the folder of scenes.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import {folder, overflows, page_test, pipegs, shared, text_of} from './tests.mjs';

const packed = path.join(shared, 'scenes/terrace/terrace.ply.xz');
const cameras = path.join(shared, 'scenes/terrace/cameras.json');

function frame() {
  const scene = path.join(folder, 'terrace.ply');
  fs.writeFileSync(scene, execFileSync('xz', ['-dc', packed], {maxBuffer: 1 << 30}));
  pipegs('sim', scene, '--cameras', cameras, '--view', '0', '--out', 'terrace', '--page', 'terrace.html');
  return 'terrace.html';
}

if (!fs.existsSync(packed)) {
  test(`skipped: no ${packed} (set PIPEGS_SHARED)`, {skip: true}, () => {});
} else {
  page_test('terrace, view 0', frame, async (page, file) => {
    const opening = await page.evaluate(() => document.documentElement.dataset.opened);
    console.log(`${(fs.statSync(file).size / 1e6).toFixed(2)} MB, ready after ${(opening / 1e3).toFixed(1)} s`);
    assert.equal(await overflows(page), 0);
    const report = JSON.parse(fs.readFileSync(path.join(folder, 'terrace/report.json')));
    assert.equal(report.mismatches, 0);
    const digits = (text) => text.replace(/[^0-9]/g, '');
    assert.ok(digits(await text_of(page, '#bound')).includes(String(report.cycles)));
    const canvas = await page.$('.picture'), box = await canvas.boundingBox();
    await page.mouse.move(box.x + box.width / 3, box.y + box.height / 2);
    assert.match(await text_of(page, 'dd[data-layer="Gaussians blended"]'), /^\d+$/);
  });
}
