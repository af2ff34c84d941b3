// SPDX-License-Identifier: Apache-2.0
// viewer.mjs: what viewer.sh prints of the page in FOLDER.
import fs from 'node:fs';
import path from 'node:path';
import {closed, folder, opened, text_of} from './browser.mjs';

const {page, complaints} = await opened('viewer.html', {timeout: 600000});
const found = {
  bytes: fs.statSync(path.join(folder, 'viewer.html')).size,
  ready_ms: await page.evaluate(() => Math.round(performance.now())),
  psnr_db: {},
};
const measured = () => Number(document.documentElement.dataset.measured);
for (const choice of ['machine', 'float', 'own']) {
  const before = await page.evaluate(measured);
  if (choice !== 'machine') {
    await page.select('#choice', choice);
    await page.waitForFunction((count) => Number(document.documentElement.dataset.measured) > count,
                               {timeout: 600000}, before);
  }
  found.psnr_db[choice] = Number((await text_of(page, '#psnr')).replace(' dB', ''));
}
await closed();
if (complaints.length > 0) throw new Error(complaints.join('\n'));
console.log(JSON.stringify(found, null, 1));
