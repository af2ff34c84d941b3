// SPDX-License-Identifier: Apache-2.0
// layers.mjs: what can be shown of a frame's pixels: pictures as they are, maps in false colors.
//
// Idea    A layer draws itself into a canvas of the picture's size when it is first shown, and says of each pixel what
//         stands there. Maps are coded (sim/report/html/frame/pixel_map.hpp): here a code becomes a number again.
import {data, plane} from '../data.mjs';
import {element, grouped, short} from '../parts.mjs';

const {width, height, x: left, y: top} = data.picture ?? {};  // other pages have none

// Viridis at 9 places: lighter is more, also without color.
const stops = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129],
               [92, 200, 99], [170, 220, 50], [253, 231, 37]];

export function false_color(share) {
  const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1), low = Math.min(Math.floor(at), stops.length - 2);
  return stops[low].map((code, k) => Math.round(code + (at - low) * (stops[low + 1][k] - code)));
}

// A color as a word of a canvas: red in the low byte, opaque.
const packed = ([red, green, blue]) => (red | green << 8 | blue << 16 | 255 << 24) >>> 0;

// `color_of`: the word of each pixel.
function painted(color_of) {
  const canvas = element('canvas', {width, height}), context = canvas.getContext('2d');
  const image = context.createImageData(width, height);
  const words = new Uint32Array(image.data.buffer);
  for (let at = 0; at < words.length; ++at) words[at] = color_of(at);
  context.putImageData(image, 0, 0);
  return canvas;
}

async function codes_of({name, less}) {
  const codes = await plane(name);
  if (less === undefined) return codes;
  const base = await plane(less);
  return codes.map((code, at) => code + base[at]);  // of bytes: modulo 256
}

function picture_layer(picture) {
  const layer = {name: picture.name, title: picture.title, kind: 'picture'};
  let codes;
  layer.load = async () => { codes ??= await codes_of(picture); };
  layer.paint = () => painted(
    (at) => (codes[3 * at] | codes[3 * at + 1] << 8 | codes[3 * at + 2] << 16 | 255 << 24) >>> 0);
  layer.says = (x, y) => Array.from(codes.subarray(3 * (y * width + x), 3 * (y * width + x) + 3)).join(' ');
  return layer;
}

function value_of(map, code) {
  if (!map.logarithmic) return code * map.step;
  return code === 0 ? 0 : map.low * 2 ** ((code - 1) / map.steps);
}

function map_layer(map) {
  const layer = {...map, kind: 'map', cell_x: Math.floor(left / map.cell), cell_y: Math.floor(top / map.cell)};
  const most = value_of(map, map.most), cells = data.planes['map:' + map.name].width;
  let codes;
  const code_at = (x, y) => codes[(Math.floor((y + top) / map.cell) - layer.cell_y) * cells +
                                  Math.floor((x + left) / map.cell) - layer.cell_x];
  layer.load = async () => { codes ??= await codes_of({name: 'map:' + map.name, less: map.less}); };
  layer.share_of = (value) => map.logarithmic ? Math.log2(value / map.low) / Math.log2(most / map.low) : value / most;
  layer.range = [map.logarithmic ? map.low : 0, most];
  layer.paint = () => {
    const colors = Uint32Array.from({length: map.most + 1}, (_, code) => packed(false_color(
      code === 0 ? 0 : layer.share_of(value_of(map, code)))));
    return painted((at) => colors[code_at(at % width, Math.floor(at / width))]);
  };
  layer.says = (x, y) => {
    const value = value_of(map, code_at(x, y));
    if (map.logarithmic) return value === 0 ? 'below ' + map.low.toPrecision(1) : '~ ' + value.toPrecision(2);
    return map.step === 1 ? grouped(value) : short(value);
  };
  return layer;
}

// Cycles of each window, over its pixels.
function window_layer() {
  const cycles = data.timeline.window_cycles, {side, first_x, first_y, columns} = data.windows;
  const most = Math.max(1, ...cycles);
  const number = (x, y) => (Math.floor((y + top) / side) - first_y) * columns + Math.floor((x + left) / side) - first_x;
  return {
    name: 'cycles', title: 'cycles of the window', unit: 'cycles', kind: 'map', range: [0, most], logarithmic: false,
    what: 'From the end of the window before to its own end, both in the RUs; all together are the frame.',
    load: async () => {},
    share_of: (value) => value / most,
    paint: () => {
      const colors = cycles.map((count) => packed(false_color(count / most)));
      return painted((at) => colors[number(at % width, Math.floor(at / width))]);
    },
    says: (x, y) => grouped(cycles[number(x, y)]),
  };
}

export function layers() {
  return [...data.pictures.map(picture_layer), ...(data.timeline ? [window_layer()] : []), ...data.maps.map(map_layer)];
}

// The window that holds a pixel: column and row in the frame, and its number among those that ran.
export function window_at(x, y) {
  const {side, first_x, first_y, columns} = data.windows;
  const column = Math.floor((x + left) / side), row = Math.floor((y + top) / side);
  return {column, row, number: (row - first_y) * columns + column - first_x};
}

// A bar with the colors of a map and the values that they stand for.
export function color_bar(layer) {
  const canvas = element('canvas', {width: 256, height: 1, class: 'colors', 'aria-hidden': 'true'});
  const context = canvas.getContext('2d');
  for (let at = 0; at < 256; ++at) {
    context.fillStyle = `rgb(${false_color(at / 255).join(' ')})`;
    context.fillRect(at, 0, 1, 1);
  }
  const [low, high] = layer.range;
  const middle = layer.logarithmic ? Math.sqrt(low * high) : (low + high) / 2;
  const label = (value) => element('span', {}, layer.logarithmic ? value.toPrecision(1) : short(value));
  return element('div', {class: 'scale', role: 'img',
                         'aria-label': `colors from ${short(low)} to ${short(high)} ${layer.unit}`},
                 canvas, element('div', {class: 'ticks'}, label(low), label(middle), label(high)));
}
