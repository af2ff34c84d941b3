// SPDX-License-Identifier: Apache-2.0
// Charts of a command as a file: whole XML that holds every series, label and value.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import path from 'node:path';
import test from 'node:test';
import {pipegs, root} from './browser.mjs';

function svg_of(input) {
  const file = execFileSync(path.join(root, 'sim/report/page/svg.sh'), [process.env.PAGE], {input, encoding: 'utf8'});
  execFileSync('python3', ['-c', 'import sys, xml.dom.minidom as dom; dom.parse(sys.stdin.buffer)'], {input: file});
  return file;
}

const plain = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
const holds = (file, text) => assert.ok(file.includes(plain(text)), text);
const marks = (file, color) => file.split(`fill="${color}"`).length - 1;

test('charts of a command as a file', () => {
  const printed = pipegs('study', 'budget', '--design', 'dop', '--count', '1000', '--json');
  const {charts} = JSON.parse(printed);
  const file = svg_of(printed);
  assert.ok(charts.length > 1);
  for (const {title, x_label, y_label, series} of charts)
    [title, x_label, y_label, ...series.map(({name}) => name)].forEach((text) => holds(file, text));
});

test('one chart of bars: a bar and its number for each value, and names that need escapes', () => {
  const chart = {name: 'a', form: 'bars', title: 'a < b & c', x_label: '', y_label: 'times', note: 'a <note>', x: [],
                 categories: ['dop', '</svg>'], series: [{name: 'one', values: [12.5, 3]},
                                                         {name: 'two', values: [null, 7]}]};
  const file = svg_of(JSON.stringify(chart));
  [chart.title, chart.note, ...chart.categories, '12.5', '3', '7'].forEach((text) => holds(file, text));
  assert.equal(marks(file, '#4c8fd6'), 2 + 1);  // and one in the legend
  assert.equal(marks(file, '#e0873a'), 1 + 1);
});
