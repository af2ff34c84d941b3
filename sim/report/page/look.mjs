// SPDX-License-Identifier: Apache-2.0
// look.mjs: colors and axes of all charts, from the variables of page.css, and when they must be drawn again.

let own = null;  // colors where there is no page

export function use_colors(colors) {
  own = colors;
}

// The color `name` of the page: 'c0', 'text', 'line' ...
export function css(name) {
  return own ? own[name] : getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
}

export const font = () => own ? own.font : getComputedStyle(document.body).fontFamily;

export const colors = () => Array.from({length: 8}, (_, at) => css('c' + at));

// Streams of memory, in the order in which the ladder shows them: each has one color, wherever it is drawn.
const streams = ['raster', 'lists', 'geometry', 'color', 'nodes', 'alpha_overflow_write', 'sort_overflow'];
export function stream_color(name) {
  const at = streams.indexOf(name.replaceAll(' ', '_'));
  return at < 0 ? null : css('c' + at);
}

// On paper the page is light and no chart changes its size: it is scaled.
export const paper = () => document.documentElement.classList.contains('paper');

// Calls `redraw` whenever the colors have become others.
export function on_look(redraw) {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  for (const [event, on] of [['beforeprint', true], ['afterprint', false]]) {
    window.addEventListener(event, () => {
      document.documentElement.classList.toggle('paper', on);
      redraw();
    });
  }
}

// 1, 2, 5 of each decade, from the last below `low` to the first above `high`.
export function decade_ticks(low, high) {
  const ticks = [];
  for (let power = Math.floor(Math.log10(low)); 10 ** power <= high * 10; ++power)
    ticks.push(...[1, 2, 5].map((one) => Number(`${one}e${power}`)));
  const first = ticks.findLastIndex((tick) => tick <= low), last = ticks.findIndex((tick) => tick >= high);
  return ticks.slice(Math.max(first, 0), last + 1);
}

// An axis of ECharts in the page's look; what `own` says comes first.
export function axis(own) {
  return {
    ...own,
    nameTextStyle: {color: css('weak'), fontSize: 12},
    axisLine: {show: true, lineStyle: {color: css('weak')}},
    axisTick: {lineStyle: {color: css('weak')}, ...own.axisTick},
    axisLabel: {color: css('text'), fontSize: 11, ...own.axisLabel},
    splitLine: {lineStyle: {color: css('line'), opacity: 0.7}, ...own.splitLine},
  };
}

export function tooltip_box() {
  return {
    className: 'tip', confine: true, backgroundColor: css('raised'), borderColor: css('line'),
    extraCssText: 'max-width: 22rem; white-space: normal; overflow-wrap: anywhere;',
    textStyle: {color: css('text'), fontSize: 12},
  };
}
