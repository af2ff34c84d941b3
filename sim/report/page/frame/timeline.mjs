// SPDX-License-Identifier: Apache-2.0
// timeline.mjs: what every unit did over the frame, and bytes of each memory stream on the same axis.
//
// Idea    The record's pieces in the part that is shown are joined to at most kBins of equal width, so a zoom costs the
//         same whatever the frame's length. Each unit is one item: four areas stacked to 100 %, and above them the
//         windows it worked on, light and dark by turns.
import {CustomChart, LineChart} from 'echarts/charts';
import {GridComponent, LegendComponent, TooltipComponent} from 'echarts/components';
import {init, use} from 'echarts/core';
import {SVGRenderer} from 'echarts/renderers';
import {data, file, plane} from '../data.mjs';
import {axis, css, on_look, paper, stream_color, tooltip_box} from '../look.mjs';
import {element, grouped, percent} from '../parts.mjs';
import {state_legend, states} from './units.mjs';

use([CustomChart, GridComponent, LegendComponent, LineChart, SVGRenderer, TooltipComponent]);

const kBins = 400, kLineBytes = 64;

const words = async (name) => new Uint32Array((await file(name)).buffer);

// {unit, window, begin, end} of each window in each unit.
async function spans() {
  const flat = await words('spans');
  return Array.from({length: flat.length / 4}, (_, at) => {
    const [unit, window, begin, end] = flat.subarray(4 * at, 4 * at + 4);
    return {unit, window, begin, end};
  });
}

export async function timeline_section() {
  const {piece, pieces, units, streams} = data.timeline, total = data.report.cycles;
  const [cycles, lines, windows] = [await plane('states'), await words('lines'), await spans()];
  let shown = {from: 0, to: total};

  // Sums over the pieces of a bin: of states by unit, of lines by stream.
  function bins() {
    const first = Math.floor(shown.from / piece), last = Math.min(Math.ceil(shown.to / piece), pieces);
    const count = Math.min(kBins, Math.max(last - first, 1));
    const edges = Array.from({length: count + 1}, (_, at) => first + Math.round(at * (last - first) / count));
    const sum = (values, row, at) => {
      let all = 0;
      for (let k = edges[at]; k < edges[at + 1]; ++k) all += values[row * pieces + k];
      return all;
    };
    const each = (make) => Array.from({length: count}, (_, at) => make(at));
    return {
      edges: edges.map((edge) => Math.min(edge * piece, total)),
      units: units.map((_, unit) => each((at) => states.map((_, state) => sum(cycles, 4 * unit + state, at)))),
      streams: streams.map((_, stream) => each((at) => sum(lines, stream, at) * kLineBytes)),
    };
  }
  let binned = bins();

  // Stacked areas of one unit as polygons, from the first state at the bottom upwards.
  function areas(api, unit) {
    const [, top] = api.coord([0, unit]), high = api.size([0, 1])[1] * 0.62, bottom = top + high / 2;
    const x = binned.edges.map((edge) => api.coord([edge, unit])[0]);
    const whole = binned.units[unit].map((one) => one.reduce((sum, value) => sum + value, 0) || 1);
    let under = binned.units[unit].map(() => 0);
    return states.map((state, k) => {
      const over = under.map((share, at) => share + binned.units[unit][at][k] / whole[at]);
      const up = over.flatMap((share, at) => [[x[at], bottom - share * high], [x[at + 1], bottom - share * high]]);
      const down = under.flatMap((share, at) => [[x[at], bottom - share * high], [x[at + 1], bottom - share * high]]);
      under = over;
      return {type: 'polygon', shape: {points: [...up, ...down.reverse()]}, style: {fill: css(state)}};
    });
  }
  function marks(api, unit) {
    const [, middle] = api.coord([0, unit]), size = api.size([0, 1])[1];
    return windows.filter((span) => span.unit === unit && span.end >= shown.from && span.begin <= shown.to).map(
      ({window, begin, end}) => {
        const left = api.coord([Math.max(begin, shown.from), unit])[0];
        const right = api.coord([Math.min(end + 1, shown.to), unit])[0];
        return {type: 'rect', shape: {x: left, y: middle - size * 0.46, width: Math.max(right - left, 0.5),
                                      height: size * 0.12},
                style: {fill: css('text'), opacity: window % 2 ? 0.75 : 0.3}};
      });
  }
  function hint(at) {
    const bin = Math.max(0, binned.edges.findLastIndex((edge) => edge <= at));
    const last = Math.min(bin, binned.edges.length - 2), rows = units.map((name, unit) => {
      const counts = binned.units[unit][last], whole = counts.reduce((sum, value) => sum + value, 0) || 1;
      const in_window = windows.filter((span) => span.unit === unit && span.begin <= at && at <= span.end);
      return element('tr', {}, element('td', {class: 'word'}, name),
        ...counts.map((count) => element('td', {}, percent(count / whole, 0))),
        element('td', {}, in_window.map(({window}) => window_name(window)).join(' | ')));
    });
    return element('div', {}, element('strong', {}, `cycles ${grouped(binned.edges[last])} to ` +
                                                    grouped(binned.edges[last + 1])),
      element('table', {}, element('tr', {}, ...['', ...states, 'window'].map((name) => element('th', {}, name))),
              ...rows));
  }

  const label = (value) => grouped(value);
  function option() {
    const named = {left: 74, right: 20}, x = {type: 'value', min: shown.from, max: shown.to, splitLine: {show: false}};
    const rate = (stream) => binned.streams[stream].map((bytes, at) => {
      const length = binned.edges[at + 1] - binned.edges[at] || 1;
      return [binned.edges[at], bytes / length];
    });
    return {
      animation: false, backgroundColor: 'transparent',
      textStyle: {fontFamily: getComputedStyle(document.body).fontFamily, color: css('text')},
      grid: [{...named, top: 10, height: 26 * units.length}, {...named, top: 26 * units.length + 78, height: 130}],
      legend: {data: streams.map((name) => name.replaceAll('_', ' ')), type: 'scroll', top: 26 * units.length + 44,
               left: 74, right: 0, pageTextStyle: {color: css('weak')}, pageIconColor: css('strong'),
               pageIconInactiveColor: css('line'), textStyle: {color: css('text'), fontSize: 12}, icon: 'roundRect',
               itemWidth: 13, itemHeight: 11},
      xAxis: [axis({...x, gridIndex: 0, axisLabel: {formatter: label, hideOverlap: true}}),
              axis({...x, gridIndex: 1, axisLabel: {formatter: label, hideOverlap: true}, name: 'cycle',
                    nameLocation: 'middle', nameGap: 26})],
      yAxis: [axis({type: 'category', data: units, inverse: true, gridIndex: 0, axisTick: {show: false}}),
              axis({type: 'value', gridIndex: 1, name: 'bytes a cycle', nameLocation: 'middle', nameGap: 46})],
      tooltip: {...tooltip_box(), trigger: 'axis', axisPointer: {type: 'line', axis: 'x', label: {show: false}},
                extraCssText: 'max-width: none; pointer-events: none;',
                formatter: (given) => {
                  const rows = [given].flat();
                  return hint((rows.find(({seriesName}) => seriesName === 'place') ?? rows[0]).axisValue);
                }},
      series: [
        // Not seen: it gives the pointer the places between which it is moved, where the units have but one each.
        {type: 'line', name: 'place', xAxisIndex: 0, yAxisIndex: 0, symbol: 'none', lineStyle: {opacity: 0},
         silent: true, data: binned.edges.slice(1).map((edge, at) => [(edge + binned.edges[at]) / 2, units[0]])},
        {type: 'custom', name: 'units', xAxisIndex: 0, yAxisIndex: 0, clip: true, legendHoverLink: false,
         encode: {x: 0, y: 1}, data: units.map((_, unit) => [shown.from, unit]),
         renderItem: (params, api) => ({type: 'group', children: [...areas(api, params.dataIndex),
                                                                   ...marks(api, params.dataIndex)]})},
        ...streams.map((name, stream) => ({
          type: 'line', name: name.replaceAll('_', ' '), xAxisIndex: 1, yAxisIndex: 1, step: 'end', symbol: 'none',
          stack: 'bytes', areaStyle: {opacity: 0.75}, lineStyle: {width: 0}, data: rate(stream),
          itemStyle: {color: stream_color(name)},
          emphasis: {disabled: true},
        })),
      ],
    };
  }

  const place = element('div', {class: 'timeline', style: `height: ${26 * units.length + 270}px`, role: 'img',
                                'aria-label': 'what each unit did over the cycles of the frame; the bars above have ' +
                                              'the sums'});
  const range = element('output', {class: 'note', id: 'range'});
  const drawn = init(place, null, {renderer: 'svg'});
  function redraw() {
    binned = bins();
    drawn.setOption(option(), {notMerge: true});
    range.textContent = `cycles ${grouped(shown.from)} to ${grouped(shown.to)} of ${grouped(total)}`;
  }
  function show(from, to) {
    const length = Math.min(Math.max(to - from, 8 * piece), total);
    const begin = Math.min(Math.max(Math.round(from), 0), total - length);
    shown = {from: begin, to: begin + length};
    redraw();
  }
  // By factor around the middle, or aside by a share of what is shown.
  const zoom = (factor, at = 0.5) => {
    const length = shown.to - shown.from, middle = shown.from + at * length;
    show(middle - at * length * factor, middle + (1 - at) * length * factor);
  };
  const aside = (share) => {
    const by = share * (shown.to - shown.from);
    show(shown.from + by, shown.to + by);
  };
  const zoom_window = (number) => {
    const own = windows.filter(({window}) => window === number);
    if (own.length === 0) return;
    show(Math.min(...own.map(({begin}) => begin)), Math.max(...own.map(({end}) => end + 1)));
  };
  place.addEventListener('wheel', (event) => {
    if (!event.ctrlKey) return;  // a wheel alone scrolls the page
    event.preventDefault();
    const box = place.getBoundingClientRect(), at = (event.clientX - box.left - 74) / (box.width - 94);
    zoom(event.deltaY > 0 ? 1.25 : 0.8, Math.min(Math.max(at, 0), 1));
  }, {passive: false});
  const press = (name, title, what) => element('button', {type: 'button', title, 'aria-label': title, onclick: what},
                                               name);
  const windows_list = element('select', {id: 'timeline-window', onchange: (event) => {
    if (event.target.value === '') show(0, total);
    else zoom_window(Number(event.target.value));
  }}, element('option', {value: ''}, 'whole frame'), ...data.timeline.window_cycles.map((count, number) => element(
    'option', {value: number}, `window ${window_name(number)}: ${grouped(count)} cycles`)));
  redraw();
  on_look(redraw);
  new ResizeObserver(() => { if (!paper()) drawn.resize(); }).observe(place);
  const section = element('div', {},
    element('p', {class: 'note'}, `A row is a unit: its states from busy upwards in pieces of ${grouped(piece)} ` +
      'cycles or more, above them the windows that it works on, light and dark by turns. Press a window in the ' +
      'picture, or choose it here; Control and the wheel zoom, too.'),
    element('div', {class: 'bar'}, element('label', {}, 'show ', windows_list),
      press('+', 'zoom in', () => zoom(0.5)), press('\u2212', 'zoom out', () => zoom(2)),
      press('\u2190', 'earlier', () => aside(-0.5)), press('\u2192', 'later', () => aside(0.5)),
      press('whole frame', 'whole frame', () => show(0, total)), range),
    state_legend(), place);
  return {section, show_window: (number) => {
    windows_list.value = String(number);
    zoom_window(number);
  }};
}

// Column and row in the frame, as --window takes them.
export function window_name(number) {
  const {columns, first_x, first_y} = data.windows;
  return `${number % columns + first_x},${Math.floor(number / columns) + first_y}`;
}
