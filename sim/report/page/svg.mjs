// SPDX-License-Identifier: Apache-2.0
// svg.mjs: charts as one SVG file, by the options that draw them in a page; svg.sh runs it.
//
// Input   A chart (charts.mjs says of what), a list of charts, or what a command printed with --json: its `charts`.
// Rule    The colors read on white and on black, and text has the reader's. Charts lie two beside each other.
import {TitleComponent} from 'echarts/components';
import {init, use} from 'echarts/core';
import fs from 'node:fs';
import {chart_option, label_option, note_of} from './charts.mjs';
import {use_colors} from './look.mjs';

use([TitleComponent]);

const kWidth = 480, kHeight = 320, kColumns = 2;
const kLetter = 6.6, kMark = 36, kLine = 17;  // of a legend: width of a letter and of what else an entry has; its lines
const kPlot = 390;  // width of what is between the axes

use_colors({
  text: 'currentColor', weak: 'currentColor', strong: 'currentColor', line: '#8a8f98', ground: 'transparent',
  c0: '#4c8fd6', c1: '#e0873a', c2: '#45a173', c3: '#c05fb4', c4: '#b39a2d', c5: '#8a8f98', c6: '#d65c5c',
  c7: '#3fa9b5', busy: '#45a173', starved: '#8a8f98', blocked: '#e0873a', memory: '#d65c5c',
  font: 'system-ui, sans-serif',
});

// How many lines the names of the series fill.
function legend_lines(names) {
  let lines = 1, filled = 0;
  for (const name of names) {
    const width = kMark + kLetter * name.length;
    if (filled > 0 && filled + width > kWidth) {
      lines += 1;
      filled = 0;
    }
    filled += width;
  }
  return lines;
}

// What a page writes around a chart stands in it; nothing is there to press or to hover.
function still_option(chart) {
  const {aria, tooltip, ...option} = chart_option(chart);
  const label = label_option(chart, kPlot);
  const lines = option.legend.show ? legend_lines(chart.series.map(({name}) => name)) : 0;
  return {
    ...option,
    title: {text: chart.title, left: 'center', top: 4, textStyle: {fontSize: 13, color: 'currentColor'}},
    legend: {...option.legend, type: 'plain', top: 26, left: 8, itemGap: 13,
             textStyle: {...option.legend.textStyle, fontSize: 11}},
    grid: {...option.grid, top: 40 + kLine * lines,
           bottom: option.grid.bottom + (note_of(chart) ? 16 : 0) + (label.rotate ? 18 : 0)},
    xAxis: {...option.xAxis, nameGap: label.rotate ? 44 : 26, axisLabel: {...option.xAxis.axisLabel, ...label}},
  };
}

function drawn(chart, at) {
  const place = init(null, null, {renderer: 'svg', ssr: true, width: kWidth, height: kHeight});
  place.setOption(still_option(chart));
  const x = kWidth * (at % kColumns), y = kHeight * Math.floor(at / kColumns);
  const svg = place.renderToSVGString().replace('<svg ', `<svg x="${x}" y="${y}" `);
  place.dispose();
  return svg + (note_of(chart) ? note(note_of(chart), x + kWidth / 2, y + kHeight - 6) : '');
}

function note(text, x, y) {
  const plain = text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
  return `<text x="${x}" y="${y}" text-anchor="middle" font-size="10" fill="currentColor">${plain}</text>\n`;
}

const input = JSON.parse(fs.readFileSync(0, 'utf8')), charts = [input.charts ?? input].flat();
const width = kWidth * Math.min(charts.length, kColumns), height = kHeight * Math.ceil(charts.length / kColumns);
process.stdout.write(`<svg xmlns="http://www.w3.org/2000/svg" class="pipegs-charts" viewBox="0 0 ${width} ${height}"
 width="${width}" height="${height}" font-family="system-ui, sans-serif">
<style>.pipegs-charts { color: #1b1f24; }
@media (prefers-color-scheme: dark) { .pipegs-charts { color: #e6e9ee; } }</style>
${charts.map(drawn).join('\n')}</svg>
`);
