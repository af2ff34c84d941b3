// SPDX-License-Identifier: Apache-2.0
// compare.mjs: two layers of the frame on one canvas with a slider between them, and the numbers under the pointer.
//
// Idea    What the pointer or the arrow keys are on is the place; its numbers stand beside the picture. A click or
//         Enter pins it, so that its line can be copied, and tells `on_window` the window that it lies in.
import {data} from '../data.mjs';
import {copy_button, element} from '../parts.mjs';
import {color_bar, layers, window_at} from './layers.mjs';

const {width, height, x: left, y: top} = data.picture ?? {};  // other pages have none

export async function compare_section({on_window}) {
  const all = layers(), by_name = new Map(all.map((layer) => [layer.name, layer])), painted = new Map();
  await Promise.all(all.map((layer) => layer.load()));
  const canvas_of = (layer) => {
    if (!painted.has(layer)) painted.set(layer, layer.paint());
    return painted.get(layer);
  };
  const second = by_name.has('exact') ? 'exact' : 'blended';
  const shown = {left: by_name.get('machine'), right: by_name.get(second), split: 0.5, place: null, pinned: false};

  const canvas = element('canvas', {
    width, height, tabindex: '0', class: 'picture', role: 'application',
    'aria-label': `the picture, ${width} by ${height} pixels: arrow keys move the place by a pixel, with Shift by 8, ` +
                  'with Control by a window; Enter pins it and zooms the timeline to its window',
  });
  const context = canvas.getContext('2d');
  function draw() {
    const at = Math.round(shown.split * width);
    if (at > 0) context.drawImage(canvas_of(shown.left), 0, 0, at, height, 0, 0, at, height);
    if (at < width)
      context.drawImage(canvas_of(shown.right), at, 0, width - at, height, at, 0, width - at, height);
    context.lineWidth = Math.max(1, width / 900);
    context.strokeStyle = '#fff';
    context.fillStyle = '#0009';
    context.fillRect(at - 1.5 * context.lineWidth, 0, 3 * context.lineWidth, height);
    context.strokeRect(at, -10, 0, height + 20);
    if (!shown.place) return;
    const {side} = data.windows, {column, row} = window_at(...shown.place);
    context.strokeStyle = shown.pinned ? '#ffd23f' : '#ffffffb0';
    context.strokeRect(column * side - left, row * side - top, side, side);
    if (shown.pinned) context.strokeRect(shown.place[0] - 4, shown.place[1] - 4, 9, 9);
  }

  const numbers = element('dl', {class: 'numbers', 'aria-live': 'off'});
  const spoken = element('p', {class: 'hidden', role: 'status'});
  const explain = element('div', {class: 'explain'});
  function tell() {
    if (!shown.place) {
      numbers.replaceChildren(element('dt', {}, 'pixel'), element('dd', {}, 'point at the picture'));
      return;
    }
    const [x, y] = shown.place, {column, row} = window_at(x, y);
    const pairs = [['pixel', `${x + left}, ${y + top}`], ['window', `${column}, ${row}`],
                   ...all.map((layer) => [layer.title, layer.says(x, y)])];
    numbers.replaceChildren(...pairs.flatMap(
      ([name, value]) => [element('dt', {}, name), element('dd', {'data-layer': name}, value)]));
    const line = `${data.explain}${x + left},${y + top}`;
    explain.replaceChildren(element('code', {}, line), copy_button(line));
  }
  function go(x, y) {
    shown.place = [Math.min(Math.max(x, 0), width - 1), Math.min(Math.max(y, 0), height - 1)];
    tell();
    draw();
  }
  function pin() {
    shown.pinned = true;
    const {column, row, number} = window_at(...shown.place);
    spoken.textContent = `pixel ${shown.place.join(', ')}, window ${column}, ${row}: ` +
                         all.map((layer) => `${layer.title} ${layer.says(...shown.place)}`).join('; ');
    draw();
    on_window(number);
  }
  function place_of(event) {
    const box = canvas.getBoundingClientRect();
    return [Math.floor((event.clientX - box.left) / box.width * width),
            Math.floor((event.clientY - box.top) / box.height * height)];
  }
  canvas.addEventListener('pointermove', (event) => { if (!shown.pinned) go(...place_of(event)); });
  canvas.addEventListener('click', (event) => {
    shown.pinned = false;
    go(...place_of(event));
    pin();
  });
  canvas.addEventListener('keydown', (event) => {
    const ways = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}, way = ways[event.key];
    if (event.key === 'Enter' && shown.place) pin();
    if (event.key === 'Escape') {
      shown.pinned = false;
      draw();
    }
    if (!way) return;
    event.preventDefault();
    shown.pinned = false;
    const step = event.ctrlKey ? data.windows.side : event.shiftKey ? 8 : 1;
    const [x, y] = shown.place ?? [Math.floor(width / 2), Math.floor(height / 2)];
    go(x + step * way[0], y + step * way[1]);
  });

  const legends = element('div', {class: 'legends'});
  function legend(layer, side) {
    if (layer.kind === 'picture') return element('div', {}, element('strong', {}, `${side}: `), layer.title);
    return element('div', {}, element('strong', {}, `${side}: `), `${layer.title}, ${layer.unit}. `,
                   element('span', {class: 'note'}, layer.what), color_bar(layer));
  }
  function changed() {
    legends.replaceChildren(legend(shown.left, 'left'), legend(shown.right, 'right'));
    draw();
  }
  const options = (chosen) => [
    ['pictures', 'picture'], ['maps', 'map'],
  ].map(([label, kind]) => element('optgroup', {label}, ...all.filter((layer) => layer.kind === kind).map(
    (layer) => element('option', {value: layer.name, selected: layer.name === chosen}, layer.title))));
  const chooser = (side) => element('label', {}, side + ' ', element('select', {
    id: 'layer-' + side,
    onchange: (event) => {
      shown[side] = by_name.get(event.target.value);
      changed();
    },
  }, ...options(shown[side].name)));
  const slider = element('input', {
    type: 'range', min: '0', max: '100', value: '50', id: 'split', 'aria-label': 'how much of the left layer is shown',
    oninput: (event) => {
      shown.split = Number(event.target.value) / 100;
      draw();
    },
  });
  const frame = element('div', {class: 'frame'}, canvas);
  const zoom = element('label', {}, 'size ', element('select', {
    id: 'zoom', onchange: (event) => {
      const times = Number(event.target.value);
      canvas.style.width = times ? `${times * width}px` : '';
    },
  }, ...[['0', 'fit'], ['1', '1:1'], ['2', '2:1'], ['4', '4:1'], ['8', '8:1']].map(
    ([value, name]) => element('option', {value}, name))));
  tell();
  changed();
  return element('div', {class: 'compare'},
    element('div', {class: 'bar'}, chooser('left'), slider, chooser('right'), zoom),
    element('div', {class: 'sides'}, element('div', {}, frame, legends),
      element('div', {class: 'place'}, numbers, element('p', {class: 'note'},
        'Codes are r g b of 0 to 255. This line prints the Gaussians of the pixel:'), explain, spoken)));
}
