// SPDX-License-Identifier: Apache-2.0
// tests.mjs: tests of pages: `page_test(name, make, look)`: `make` runs pipegs and gives the page's file, `look` gets
// the opened page.
//
// Rule    Whatever the page complains of fails the test after `look`, too.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test, {after} from 'node:test';
import {closed, folder, opened} from './browser.mjs';

export * from './browser.mjs';

after(closed);

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
