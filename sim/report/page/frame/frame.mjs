// SPDX-License-Identifier: Apache-2.0
// frame.mjs: the page of one frame: what bounds it, its pixels, where each cycle went, memory, and what was simulated.
import {draw_chart} from '../charts.mjs';
import {element, grouped, made_by, section} from '../parts.mjs';
import {table} from '../table.mjs';
import {compare_section} from './compare.mjs';
import {timeline_section} from './timeline.mjs';
import {units_section} from './units.mjs';

const kLatencyBins = 48;

function figure(name, value, note) {
  return element('div', {}, element('div', {class: 'name'}, name), element('div', {class: 'value'}, value),
                 note ? element('div', {class: 'note'}, note) : null);
}

function figures(report) {
  const {cycles, memory, camera, scene} = report;
  const decibels = (value, ran) => !ran ? 'not run' : value === null ? 'equal' : value.toFixed(2) + ' dB';
  const psnr = ['numeric', 'order', 'total'].map((name) => figure(
    name + ' error', decibels(report[`psnr_${name}_db`], report.ran.truth),
    {numeric: 'against float64 in its own order', order: 'of the order alone', total: 'against INRIA\'s rules'}[name]));
  const run = report.ran.rtl ? [
    figure('cycles', grouped(cycles), `${(1e9 / cycles).toFixed(0)} frames a second at 1 GHz`),
    figure('external memory', ((memory.bytes_read + memory.bytes_written) / 1e6).toFixed(1) + ' MB', 'of the frame'),
    figure('compared with the golden model', report.mismatches === 0 ? 'equal' : `${report.mismatches} differ`,
           `${grouped(report.beats_compared)} beats and every pixel`),
  ] : [];
  const likeness = typeof report.ssim === 'number' ? `SSIM ${report.ssim.toFixed(4)}` : '';
  const photograph = report.photograph === undefined
    ? [] : [figure('against the photograph', decibels(report.psnr_db, true), likeness)];
  return element('div', {class: 'figures'}, ...run, ...psnr, ...photograph,
                 figure('scene', grouped(scene.gaussians) + ' Gaussians',
                        `${camera.width}x${camera.height} pixels, SH degree ${scene.sh_degree}`));
}

function memory_section(report, latency) {
  const streams = Object.entries(report.memory.by_stream), made = element('div', {class: 'grid'});
  const cell = () => made.appendChild(element('div'));
  draw_chart(cell(), {
    form: 'stacked', title: 'Memory by stream', x_label: '', y_label: 'MB a frame', note: '', x: [],
    categories: streams.map(([name]) => name.replaceAll('_', ' ')), log_x: false, log_y: false, from_zero: true,
    series: ['read', 'written'].map((name) => ({
      name, values: streams.map(([, bytes]) => bytes[name] / 1e6), outlined: false, x: [], labels: [], named: false})),
  });
  if (!latency) return made;
  const width = Math.max(1, Math.ceil(latency.length / kLatencyBins)), count = Math.ceil(latency.length / width);
  const reads = Array.from({length: count}, (_, at) => latency.slice(at * width, (at + 1) * width)
                                                              .reduce((sum, value) => sum + value, 0));
  const {p50, p90, p99, max} = report.memory.dram.read_latency_cycles, {gbps, peak_gbps} = report.memory.dram;
  draw_chart(cell(), {
    form: 'histogram', title: 'Latency of reads', x_label: 'cycles', y_label: 'lines read', categories: [],
    x: Array.from({length: count + 1}, (_, at) => at * width), log_x: false, log_y: false, from_zero: true,
    note: `Half of the reads take at most ${p50} cycles, 90 % ${p90}, 99 % ${p99}, the longest ${max}; ` +
          `${gbps.toFixed(1)} GB/s of ${peak_gbps.toFixed(1)}.`,
    series: [{name: 'reads', values: reads, outlined: false, x: [], labels: [], named: false}],
  });
  return made;
}

function work_table(work) {
  const meanings = {
    fetched: 'Gaussians that the PUs fetched, once for each window', visible: 'of these, left by the cull',
    records: 'records that were sorted', regions: 'pairs of a Gaussian and an 8x8 region that it touches',
    open_regions: 'of these, blended: the region was still open', quads: 'pairs of a Gaussian and 2x2 pixels, blended',
    alphas: 'alphas computed', blended: 'pairs of a Gaussian and a pixel that it changed', keys: 'keys sorted',
    overflow_lines: 'lines that went to external memory because a buffer was full',
    chunks: 'chunks of Gaussians walked', layers: 'layers of windows', windows: 'windows',
  };
  const rows = Object.entries(work).filter(([, count]) => count !== null);
  return table({title: 'work', columns: [{name: 'work', word: true}, {name: 'count'}, {name: 'what', word: true}],
                rows: rows.map(([name, count]) => [name, count, meanings[name] ?? ''])});
}

// What is odd in scene, cameras and frame.
function found(report) {
  return (report.findings ?? []).map(({severity, what, count}) => element(
    'p', {class: 'note'}, `${severity}: ${what}${count ? ` (${grouped(count)})` : ''}`));
}

export async function frame_page(main, data) {
  const {report, sentences} = data;
  main.append(element('h1', {}, data.title), element('p', {class: 'lead', id: 'bound'}, sentences.frame),
              ...found(report), figures(report));
  const timeline = data.timeline ? await timeline_section() : null;
  const compare = await compare_section({on_window: (number) => timeline?.show_window(number)});
  main.append(section('The picture', compare));
  if (report.ran.rtl) main.append(section('Where each cycle went', ...units_section(report, sentences)));
  if (timeline) main.append(section('The units over time', timeline.section));
  if (report.ran.rtl) main.append(section('External memory', memory_section(report, data.latency)));
  main.append(section('The work of this frame', work_table(report.work)));
  const entries = Object.entries(report.config);
  main.append(section('The machine', element('details', {}, element('summary', {}, 'configuration'), table(
    {title: 'configuration', columns: [{name: 'entry', word: true}, {name: 'value'}], rows: entries}))));
  main.append(made_by(data));
}
