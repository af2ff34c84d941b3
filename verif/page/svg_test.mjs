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

test('on a logarithmic axis dots with their ranges, no bars', () => {
  const chart = {name: 'a', form: 'bars', title: 'a', x_label: '', y_label: 'frames/J', note: '', x: [], log_y: true,
                 categories: ['GSCore', 'fast'], series: [{name: 'mid', values: [12.5, 300], low: [5, 200],
                                                           high: [50, 600]}]};
  const file = svg_of(JSON.stringify(chart));
  ['12.5', '300', 'mid', ...chart.categories].forEach((text) => holds(file, text));
  assert.equal(file.match(/<circle[^>]*fill="#4c8fd6"/g).length, 2);
  assert.equal(file.match(/<path[^>]*stroke="#4c8fd6"/g).length, 2 * 3);  // a range and its ends
  assert.equal(marks(file, '#4c8fd6'), 2 + 1);                            // and one in the legend
});

test('a stream has one color, wherever it stands in a chart', () => {
  const stacked = (names) => svg_of(JSON.stringify(
    {name: 'a', form: 'stacked', title: 'a', x_label: '', y_label: 'MB', note: '', x: [], categories: ['dop'],
     series: names.map((name, at) => ({name, values: [at + 1]}))}));
  for (const names of [['geometry', 'raster'], ['raster', 'nodes', 'geometry'], ['sort overflow', 'geometry']])
    assert.equal(marks(stacked(names), '#45a173'), 1 + 1, names.join());
});

test('a point far from all others does not press them into a corner, and is named', () => {
  const near = Array.from({length: 20}, (_, at) => 60 + at / 4), labels = near.map((_, at) => `p${at}`);
  const cloud = (values) => ({
    name: 'a', form: 'scatter', title: 'a', x_label: 'us', y_label: 'dB', note: 'known', x: [], categories: [],
    series: [{name: 'all', values, x: values, labels: [...labels, 'lost']}],
  });
  const file = svg_of(JSON.stringify(cloud([...near, 2])));
  holds(file, 'known; not shown, far from the others: lost (2, 2)');
  assert.ok(!file.includes('>0</text>') && file.includes('>60</text>'), 'the axis begins near the others');
  assert.ok(!svg_of(JSON.stringify(cloud([...near, 58]))).includes('not shown'));
});
