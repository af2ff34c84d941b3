// SPDX-License-Identifier: Apache-2.0
// study_test: pages of studies as a reader uses them: charts, tooltips, points that copy their settings, sorting, the
// printed numbers, narrow and dark windows, paper.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {folder, overflows, page_test, pipegs, text_of} from './tests.mjs';

const printed = {};  // what each command printed

// What a series has drawn: elements in one of the page's colors.
const kMarks = () => [...document.querySelectorAll('.chart')].map((chart) => {
  const style = getComputedStyle(document.documentElement);
  const names = ['c0', 'c1', 'c2', 'c3', 'c4', 'c5', 'c6', 'c7', 'busy', 'starved', 'blocked', 'memory'];
  const colors = new Set(names.map((name) => style.getPropertyValue('--' + name).trim()));
  return [...chart.querySelectorAll('svg path')].filter(
    (path) => colors.has(path.getAttribute('fill')) || colors.has(path.getAttribute('stroke'))).length;
});

const data_of = (page) => page.evaluate(() => JSON.parse(document.getElementById('data').textContent));
const charts_of = (data) => data.sections.flatMap(({charts}) => charts ?? []);

async function every_value_is_drawn(page) {
  const marks = await page.evaluate(kMarks), charts = charts_of(await data_of(page));
  assert.equal(marks.length, charts.length);
  charts.forEach((chart, at) => {
    const values = chart.series.flatMap((series) => series.values).filter((value) => value !== null && value > 0);
    assert.ok(values.length > 0 && marks[at] >= values.length,
              `${chart.title}: ${marks[at]} marks of ${values.length} values`);
  });
}

// The numbers of a text, however it stands.
const numbers_of = (text) => text.replace(/[\u202f']/g, '').match(/\d+(\.\d+)?/g) ?? [];

async function every_number_is_there(page, text) {
  const shown = await page.evaluate(() => [...document.querySelectorAll('h1, h3, p, td, th, pre, figcaption')]
    .map((element) => element.textContent).join('\n'));
  const there = new Set(numbers_of(shown));
  const missing = numbers_of(text).filter((number) => !there.has(number));
  assert.deepEqual(missing, []);
}

async function columns_sort(page) {
  const found = await page.evaluate(() => {
    for (const table of document.querySelectorAll('section > .wide table')) {
      const at = [...table.querySelectorAll('th')].findIndex(({className}) => className === '');
      const cells = () => [...table.querySelectorAll(`tbody td:nth-child(${at + 1})`)]
        .map(({textContent}) => parseFloat(textContent.replace('~', ''))).filter((value) => !Number.isNaN(value));
      if (at < 0 || new Set(cells()).size < 2) continue;
      const head = table.querySelectorAll('th')[at], orders = [];
      for (const order of ['ascending', 'descending']) {
        head.querySelector('button').click();
        orders.push([head.getAttribute('aria-sort') === order, cells()]);
      }
      return orders;
    }
    return null;
  });
  assert.ok(found, 'a table of two numbers');
  const [[rises, up], [falls, down]] = found;
  assert.ok(rises && falls);
  assert.deepEqual(up, [...up].sort((a, b) => a - b));
  assert.deepEqual(down, [...up].reverse());
}

// The middle of a mark, in the window, when the chart has been drawn for its size.
async function mark_place(page, chart, color, last = true) {
  return page.evaluate(async (at, name, from_end) => {
    for (let frame = 0; frame < 3; ++frame) await new Promise(requestAnimationFrame);
    const room = document.querySelectorAll('.chart')[at];
    room.scrollIntoView({block: 'center'});
    const wanted = getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
    const top = room.getBoundingClientRect().top + 34;  // beneath the legend
    const marks = [...room.querySelectorAll('svg path')].filter((path) => {
      const paint = [path.getAttribute('fill'), path.getAttribute('stroke')];
      return paint.includes(wanted) && paint[0] !== 'none' && path.getBoundingClientRect().top > top;
    });
    const {x, y, width, height} = (from_end ? marks.at(-1) : marks[0]).getBoundingClientRect();
    return {x: x + width / 2, y: y + height / 2};
  }, chart, color, last);
}

const tip_of = (page) => page.waitForFunction(() => {
  const seen = (one) => getComputedStyle(one).visibility === 'visible' && Number(getComputedStyle(one).opacity) > 0;
  return [...document.querySelectorAll('.tip')].find((one) => one.textContent !== '' && seen(one))?.textContent;
}, {timeout: 5000}).then((handle) => handle.jsonValue());

async function hover_tells(page, chart, color, part) {
  const {x, y} = await mark_place(page, chart, color);
  await page.mouse.move(x - 3, y);
  await page.mouse.move(x, y);
  const text = await tip_of(page);
  assert.ok(text.includes(part), `${part} in ${text}`);
  await page.mouse.move(0, 0);
}

// What a click on the last mark of a color copies. A busy machine may draw a chart anew between press and release, and
// then that was no click.
async function click_copies(page, color) {
  for (let again = 0; again < 10; ++again) {
    const {x, y} = await mark_place(page, 0, color);
    await page.mouse.click(x, y);
    try {
      const found = await page.waitForFunction(() => window.copied, {timeout: 2000, polling: 50});
      return await found.jsonValue();
    } catch (error) {
      if (error.name !== 'TimeoutError') throw error;
    }
  }
  assert.fail('no click has copied anything');
}

// Names beneath charts that cover each other; those that stand aslant do not.
const kCovered = () => [...document.querySelectorAll('.chart')].flatMap((chart) => {
  const names = [...chart.querySelectorAll('svg text')].filter(
    (text) => text.getAttribute('text-anchor') === 'middle' && !/rotate|matrix/.test(text.getAttribute('transform')));
  const boxes = names.map((text) => [text.textContent, text.getBoundingClientRect()]);
  return boxes.flatMap(([a, one], at) => boxes.slice(at + 1).filter(
    ([, other]) => one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom)
    .map(([b]) => `${a} and ${b}`));
});

// The charts follow the window.
async function resized(page, width) {
  await page.setViewport({width, height: 900});
  await page.waitForFunction((wanted) => window.innerWidth === wanted && [...document.querySelectorAll('.chart')].every(
    (room) => Math.abs(room.clientWidth - room.querySelector('svg').clientWidth) <= 1), {timeout: 5000}, width);
}

async function fits_and_darkens(page) {
  assert.equal(await overflows(page), 0);
  const label = () => page.evaluate(() => document.querySelector('.chart svg text')?.getAttribute('fill'));
  const light = await label();
  await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: 'dark'}]);
  await page.waitForFunction((before) => document.querySelector('.chart svg text')?.getAttribute('fill') !== before,
                             {timeout: 5000}, light);
  const [ground, text] = await page.evaluate(() => [getComputedStyle(document.body).backgroundColor,
                                                    getComputedStyle(document.body).color]);
  assert.notEqual(ground, 'rgb(255, 255, 255)');
  assert.notEqual(ground, text);
  await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: 'light'}]);
  await resized(page, 400);
  assert.equal(await overflows(page), 0);
  assert.deepEqual(await page.evaluate(kCovered), []);
  await resized(page, 1280);
}

async function look_at_study(page, command, text) {
  await every_value_is_drawn(page);
  await every_number_is_there(page, text);
  await columns_sort(page);
  await fits_and_darkens(page);
  assert.ok((await text_of(page, '.command code')).includes(command));
}

page_test('accuracy', () => {
  printed.accuracy = pipegs('accuracy', '--size', '128x96', '--design', 'exact', '--knobs', 'alpha_w', '--points', '2',
                            '--target', '45dB', '--store', 'points', '--out', 'accuracy', '--page')
    .split('\n').filter((line) => !line.includes('points measured in') && !line.startsWith('  files in ')).join('\n');
  return 'accuracy/accuracy.html';
}, async (page) => {
  await look_at_study(page, 'accuracy --size 128x96', printed.accuracy);
  // The most accurate point of the front over cycles: named, told, and copied by a click.
  const data = await data_of(page), chart = charts_of(data)[0], front = chart.series.at(-1);
  const names = await page.evaluate(() => document.querySelector('.chart').textContent);
  assert.ok(front.labels.some((label) => names.includes(label)), 'a point of the front has its name beside it');
  await page.evaluate(() => {
    Object.defineProperty(navigator, 'clipboard', {value: {writeText: async (text) => { window.copied = text; }}});
  });
  const {x, y} = await mark_place(page, 0, 'c3');
  await page.mouse.move(x - 2, y);
  await page.mouse.move(x, y);
  const text = await tip_of(page);
  assert.ok(text.includes(front.labels.at(-1)), text);
  const copied = await click_copies(page, 'c3');
  assert.equal(copied, front.copies.at(-1));
  assert.match(copied, /^--design \w+/);
  const marked = await page.evaluate(() => [...document.querySelectorAll('tr.marked')].map(
    (row) => row.dataset.copies));
  assert.ok(marked.length > 0 && marked.every((copies) => copies === copied), String(marked));
  assert.ok((await text_of(page, '.said')).includes(copied));
  // The settings are those of a command.
  pipegs('render', '--size', '32x32', '--out', 'copied', ...copied.split(' '));
  assert.equal(await page.$$eval('.pictures img', (all) => all.filter((one) => one.naturalWidth === 0).length), 0);
});

page_test('ladder', () => {
  printed.ladder = pipegs('ladder', '--size', '128x96', '--designs', 'fast', '--out', 'ladder', '--page')
    .split('\n').filter((line) => !line.includes('files in ')).join('\n');
  return 'ladder/ladder.html';
}, async (page) => {
  await every_value_is_drawn(page);
  await every_number_is_there(page, printed.ladder);
  await fits_and_darkens(page);
  const stacked = charts_of(await data_of(page)).findIndex(({form}) => form === 'stacked');
  await hover_tells(page, stacked, 'busy', 'fast');
  await page.evaluate(() => document.querySelector('.numbers summary').click());
  await page.waitForSelector('.numbers tbody tr');
  assert.equal(await page.$$eval('.numbers tbody tr', (rows) => rows.length), 1);  // of one design point
  // On paper: light, without buttons, and no chart is wider than its room.
  await page.emulateMediaType('print');
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  assert.equal(await page.evaluate(() => getComputedStyle(document.querySelector('.copy')).display), 'none');
  const [room, drawn] = await page.evaluate(() => ['.chart', '.chart svg'].map(
    (one) => document.querySelector(one).getBoundingClientRect().width));
  assert.ok(drawn <= room + 1, `${drawn} of ${room}`);
});

page_test('what-if', () => {
  printed.what_if = pipegs('what-if', '--size', '128x96', '--set', 'units=2', '--set', 'alpha_w=8,rgb_w=12', '--out',
                           'what-if', '--page').split('\n').filter((line) => !line.includes('files in ')).join('\n');
  return 'what-if/what-if.html';
}, async (page) => {
  await look_at_study(page, 'what-if --size 128x96 --set units=2 --set alpha_w=8,rgb_w=12', printed.what_if);
  await hover_tells(page, 0, 'c1', 'units=2');
  const copies = await page.$$eval('button.copy', (all) => all.length);
  assert.ok(copies >= 3, `${copies} of three machines`);
});

page_test('views against photographs', () => {
  pipegs('render', '--size', '64x48', '--views', 'all', '--model', 'truth', '--out', 'photos');
  printed.views = pipegs('render', '--size', '64x48', '--views', 'all', '--against', 'photos', '--out', 'views',
                         '--page').split('\n').filter((line) => !line.includes('files in ')).join('\n');
  return 'views/render.html';
}, async (page) => {
  await look_at_study(page, 'render --size 64x48 --views all --against photos', printed.views);
  await hover_tells(page, 0, 'c0', 'dB, photograph');
});

page_test('a sequence', () => {
  printed.sequence = pipegs('sim', '--size', '64x48', '--views', '0-1', '--no-rtl', '--truth', '--out', 'walk',
                            '--page')
    .split('\n').filter((line) => !line.includes('pictures and figures in ')).join('\n');
  return 'walk/sequence.html';
}, async (page) => {
  await look_at_study(page, 'sim --size 64x48 --views 0-1', printed.sequence);
});

page_test('rivals', () => {
  printed.rivals = pipegs('study', 'rivals', '--size', '128x96', '--out', 'rivals', '--page')
    .split('\n').filter((line) => !line.includes('files in ')).join('\n');
  return 'rivals/rivals.html';
}, async (page) => {
  await look_at_study(page, 'study rivals --size 128x96', printed.rivals);
});

page_test('campaign with a missing point', () => {
  const campaign = {scenes: [{name: 'own', size: '96x64', views: [0, 1]}], designs: ['exact', 'fast']};
  fs.writeFileSync(path.join(folder, 'campaign.json'), JSON.stringify(campaign));
  pipegs('campaign', 'campaign.json', '--out', 'campaign');
  const lines = fs.readFileSync(path.join(folder, 'campaign/lines.txt'), 'utf8').trim().split('\n');
  printed.missing = lines[1];
  for (const line of lines.filter((one) => one !== printed.missing)) execFileSync('sh', ['-c', line]);
  // A point is missing: that is an exit code of its own.
  assert.throws(() => pipegs('campaign', 'campaign.json', '--out', 'campaign', '--merge', '--page'),
                (error) => error.status === 1);
  return 'campaign/campaign.html';
}, async (page) => {
  const csv = fs.readFileSync(path.join(folder, 'campaign/results.csv'), 'utf8');
  await look_at_study(page, 'campaign campaign.json', csv.split('\n').slice(1).join('\n'));
  assert.ok((await text_of(page, '#what-is-missing')).includes(printed.missing));
  await hover_tells(page, 0, 'c0', 'own 1');
});

page_test('report of a folder with a broken file', () => {
  fs.cpSync(path.join(folder, 'ladder'), path.join(folder, 'results/ladder'), {recursive: true});
  pipegs('sim', '--no-rtl', '--size', '128x96', '--out', 'results/golden');
  pipegs('sim', '--no-rtl', '--size', '64x48', '--path', '3', '--out', 'results/walk');
  fs.mkdirSync(path.join(folder, 'results/broken'));
  fs.writeFileSync(path.join(folder, 'results/broken/report.json'), '{"scene": {"name": "<b>", "gaussians": 1e99}}');
  printed.report = pipegs('report', 'results');
  assert.match(printed.report, /^3 results in results\/report.html\n {2}left out: results\/broken\/report.json: /);
  return 'results/report.html';
}, async (page) => {
  await every_value_is_drawn(page);
  await columns_sort(page);
  await fits_and_darkens(page);
  assert.ok((await text_of(page, '#left-out')).includes('results/broken/report.json'));
  // The name of a result leads to its picture.
  const [name, link] = await page.$eval('#frames td a', (one) => [one.textContent, one.getAttribute('href')]);
  assert.ok((await text_of(page, link + ' figcaption')).includes(name));
  assert.equal(await page.$$eval('.pictures img', (all) => all.filter((one) => one.naturalWidth > 0).length), 3);
  await hover_tells(page, 0, 'c0', 'golden' === name ? 'ladder/fast' : 'ladder');
});
