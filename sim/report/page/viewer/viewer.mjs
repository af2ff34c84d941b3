// SPDX-License-Identifier: Apache-2.0
// viewer.mjs: the page of `pipegs sim --viewer`: the machine's picture, the same by Spark, and their difference.
import {Vector3} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {data, file, plane} from '../data.mjs';
import {element, grouped, made_by} from '../parts.mjs';
import {camera_of, place, pose, reach} from './camera.mjs';
import {compared, show, show_rgb} from './measure.mjs';
import {choices, Viewer} from './spark.mjs';
import {about} from './words.mjs';

const all = choices(data.antialias), scene = data.scene;
const state = {frame: 0, choice: 'machine', factor: 10, away: false, whole: true};
const ready = (word) => { document.documentElement.dataset.ready = word; };

// Elements that change.
const machine = element('canvas', {id: 'machine', role: 'img'});
const canvas = element('canvas', {
  id: 'spark',
  tabindex: 0,
  role: 'application',
  'aria-label': 'The scene by Spark; its camera moves by keys',
  'aria-describedby': 'keys',
  onpointerdown: () => canvas.focus(),
  onwheel: (event) => { if (document.activeElement !== canvas) event.stopImmediatePropagation(); },
});
const difference = element('canvas', {id: 'difference', role: 'img'});
const machine_figure = element('figure', {id: 'machine-figure'}, element('div', {class: 'wide'}, machine),
                               element('figcaption'));
const psnr = element('div', {id: 'psnr', class: 'value'}, '-');
const largest = element('div', {id: 'largest', class: 'value'}, '-');
const rms = element('div', {id: 'rms', class: 'value'}, '-');
const status = element('p', {id: 'status', role: 'status', class: 'note'}, 'Reading the scene ...');
const back = element('button', {id: 'back', type: 'button', disabled: true, onclick: () => to_frame()},
                     'back to the frame\'s camera');

let viewer, controls, camera, files, measuring, opening = Promise.resolve();

const current = () => data.frames[state.frame];

function select(id, label, options, chosen, changed) {
  const made = element('select', {id, onchange: (event) => changed(event.target.value)},
                       ...options.map(([value, text]) => element('option', {value, selected: value === chosen}, text)));
  return element('label', {}, label + ' ', made);
}

function sizes() {
  const [, , width] = current().part;
  for (const one of [machine, canvas, difference])
    one.style.width = state.whole ? '100%' : width / devicePixelRatio + 'px';
  document.getElementById('pictures').classList.toggle('large', !state.whole);
}

function say_where() {
  const name = current().name, [, , width, height] = current().part;
  machine_figure.classList.toggle('other', state.away);
  machine_figure.querySelector('figcaption').textContent =
    'The machine: ' + name + ', ' + width + ' x ' + height + ' pixels' +
    (state.away ? '. Of the frame\'s camera: the viewer is elsewhere.' : '.');
  machine.setAttribute('aria-label', 'The machine\'s picture of ' + name);
  back.disabled = !state.away;
}

// What was measured is of the picture before.
function redraw() {
  for (const value of [psnr, largest, rms]) value.textContent = '...';
  return viewer.draw(camera, reach(current()));
}

function moved() {
  state.away = true;
  camera.updateMatrixWorld();
  say_where();
  redraw();
}

// The pixels are those of the camera: compare them, when it stands still.
function drawn() {
  clearTimeout(measuring);
  measuring = setTimeout(measure, state.away ? 150 : 0);
}

async function measure() {
  const frame = state.frame, [, , width, height] = current().part, picture = await plane('picture:' + frame);
  if (frame !== state.frame || viewer.busy || !viewer.shown) return;
  const found = compared(picture, viewer.pixels(), state.factor);
  show(difference, width, height, found.picture);
  difference.setAttribute('aria-label', 'Absolute difference of both pictures, ' + state.factor + ' times');
  psnr.textContent = Number.isFinite(found.psnr) ? found.psnr.toFixed(2) + ' dB' : 'equal';
  largest.textContent = found.largest + ' of 255';
  rms.textContent = found.rms.toFixed(2) + ' of 255';
  status.textContent = all[state.choice].name + ': Spark against the machine ' + psnr.textContent +
                       (state.away ? ', from another camera' : '');
  document.documentElement.dataset.measured = Number(document.documentElement.dataset.measured ?? 0) + 1;
  ready('yes');
}

// The camera turns about a point in front of it at the depth of the scene, upright as the frame is. The wheel is the
// page's until the canvas has the focus.
function steer() {
  const point = new Vector3(0, 0, -viewer.depth(camera)).applyMatrix4(camera.matrixWorld);
  controls?.dispose();
  controls = new OrbitControls(camera, canvas);
  controls.target.copy(point);
  controls.listenToKeyEvents(canvas);
  controls.addEventListener('change', moved);
  place(camera, pose(current()));  // they have turned it to the origin
}

function to_frame() {
  camera = camera_of(current(), data.near);
  state.away = false;
  steer();
  say_where();
  return redraw();
}

async function to(number) {
  state.frame = number;
  const [, , width, height] = current().part, picture = await plane('picture:' + number);
  show_rgb(machine, width, height, picture);
  viewer.size(width, height);
  sizes();
  await to_frame();
}

// One after the other, and only the last of several that wait.
function choose(choice) {
  state.choice = choice;
  opening = opening.then(async () => {
    if (state.choice !== choice) return;
    status.textContent = 'Reading the scene ...';
    await viewer.open(files, scene.form, all[choice]);
    await redraw();
  });
}

function bar() {
  const frames = data.frames.map(({name}, i) => [String(i), data.frames.length > 1 ? i + ': ' + name : name]);
  const several = data.frames.length > 1 ? [select('frame', 'frame', frames, '0', (value) => to(Number(value)))] : [];
  return element(
    'div', {class: 'bar'}, ...several,
    select('choice', 'Spark\'s settings', Object.entries(all).map(([key, {name}]) => [key, name]), 'machine', choose),
    select('size', 'size', [['whole', 'fits the window'], ['pixels', 'a pixel is a pixel']], 'whole', (value) => {
      state.whole = value === 'whole';
      sizes();
    }),
    select('factor', 'difference', [1, 4, 10, 40].map((n) => [String(n), n + ' times']), '10', (value) => {
      state.factor = Number(value);
      measure();
    }),
    back);
}

function figure_of(name, value) { return element('div', {}, element('div', {class: 'name'}, name), value); }

async function page() {
  document.title = data.title;
  const main = document.getElementById('page');
  main.replaceChildren(
    element('h1', {}, data.title),
    element('p', {class: 'lead'}, 'The machine\'s picture beside the one that a viewer of the web draws of the same ' +
            grouped(scene.gaussians) + ' Gaussians from the same camera: Spark 2.2.0 on three.js, by WebGL, here.'),
    element('div', {class: 'figures'}, figure_of('Spark against the machine', psnr),
            figure_of('largest difference', largest), figure_of('root of mean square', rms)),
    bar(), status,
    element('div', {id: 'pictures'}, machine_figure,
            element('figure', {}, element('div', {class: 'wide'}, canvas), element('figcaption', {}, 'Spark.')),
            element('figure', {}, element('div', {class: 'wide'}, difference),
                    element('figcaption', {}, 'Their absolute difference, amplified as chosen above.'))),
    element('p', {id: 'keys', class: 'note'}, 'Spark\'s camera, when its picture has the focus: drag or shift and ' +
            'arrow keys turn it about the scene, shift and drag or arrow keys move it, the wheel brings it nearer ' +
            'and farther.'),
    about(data, all), made_by(data));
  try {
    viewer = new Viewer(canvas, data.background, drawn);
  } catch (error) {
    status.textContent = 'No viewer: this browser has no WebGL 2 (' + error.message + ').';
    show_rgb(machine, ...current().part.slice(2), await plane('picture:0'));
    ready('no WebGL');
    return;
  }
  files = await Promise.all(scene.files.map((size, i) => file('scene:' + i)));
  await viewer.open(files, scene.form, all[state.choice]);
  await to(0);
}

page();
