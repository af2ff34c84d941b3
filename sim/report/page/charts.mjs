// SPDX-License-Identifier: Apache-2.0
// charts.mjs: a Chart of the program (sim/report/chart.hpp writes it as JSON) drawn by ECharts as SVG, in a page here
// and in a file by svg.mjs.
//
// Format  {name, form: bars, stacked, lines, histogram or scatter; title, x_label, y_label, note; categories; x; log_x,
//         log_y, from_zero; series: [{name, values, outlined, x, labels, named, copies, low, high}]}. null: a gap.
// Rule    Colors are the page's (page.css): states and streams have their own in every chart. What can be seen in a
//         chart can be read beneath it, in a table. Of points, a few that lie far from all others are not shown, and
//         that is said: they would press all others, and the front, into a corner.
import {BarChart, CustomChart, LineChart, ScatterChart} from 'echarts/charts';
import {AriaComponent, GridComponent, LegendComponent, TooltipComponent} from 'echarts/components';
import {init, use} from 'echarts/core';
import {LabelLayout} from 'echarts/features';
import {SVGRenderer} from 'echarts/renderers';
import {axis, colors, css, decade_ticks, font, on_look, paper, stream_color, tooltip_box} from './look.mjs';
import {element, short} from './parts.mjs';
import {table} from './table.mjs';

use([AriaComponent, BarChart, CustomChart, GridComponent, LabelLayout, LegendComponent, LineChart, ScatterChart,
     SVGRenderer, TooltipComponent]);

export {axis, colors, css, on_look};

// 1234567 -> 1.23M
export function brief(value) {
  const size = Math.abs(value);
  for (const [unit, letter] of [[1e9, 'G'], [1e6, 'M'], [1e3, 'k']]) {
    if (size >= 0.9995 * unit * (unit === 1e3 ? 10 : 1)) return Number((value / unit).toPrecision(3)) + letter;
  }
  return Number(value.toPrecision(size >= 100 ? 4 : 3)).toString();
}

// Of an axis: places that are nearly the same need more digits.
function marked(values) {
  const known = finite(values), low = Math.min(...known), high = Math.max(...known);
  const wide = high - low > 0.02 * Math.max(Math.abs(low), Math.abs(high));
  return wide ? brief : (value) => Number(value.toPrecision(6)).toString();
}

const finite = (values) => values.filter((value) => Number.isFinite(value));
const by_category = (chart) => chart.form === 'bars' || chart.form === 'stacked';
const logarithmic_y = (chart) => chart.log_y && (chart.form === 'bars' || chart.form === 'lines');
// What an axis cannot show leaves a gap.
const shown = (value, log) => Number.isFinite(value) && (!log || value > 0) ? value : null;

function sums(chart) {
  return chart.categories.map(
    (_, at) => chart.series.reduce((sum, {values}) => sum + Math.max(shown(values[at]) ?? 0, 0), 0));
}

// The ends between which points are shown: where a few lie beyond three times what the middle half of all spans, and
// would leave a third of the axis or less to the others. The front is always shown.
function fence(chart, of) {
  const all = chart.series.filter(({outlined}) => !outlined).flatMap((one) => finite(of(one))).sort((a, b) => a - b);
  const at = (share) => all[Math.round(share * (all.length - 1))], reach = 3 * (at(0.75) - at(0.25));
  const front = chart.series.filter(({outlined}) => outlined).flatMap((one) => finite(of(one)));
  const near = all.filter((value) => value >= at(0.25) - reach && value <= at(0.75) + reach);
  if (near.length === all.length || near.length < 12) return null;
  const low = Math.min(...near, ...front), high = Math.max(...near, ...front), free = 0.05 * (high - low);
  return high - low > (all.at(-1) - all[0]) / 3 ? null : {min: low - free, max: high + free};
}
const fences = (chart) => chart.form !== 'scatter' ? [null, null] : [fence(chart, ({x}) => x),
                                                                     fence(chart, ({values}) => values)];

// The note of a chart, and what of it is not shown.
export function note_of(chart) {
  const [across, up] = fences(chart), beyond = (value, ends) => ends && (value < ends.min || value > ends.max);
  const hidden = new Set(chart.form !== 'scatter' ? [] : chart.series.flatMap(({x, values, labels}) => values.flatMap(
    (value, at) => Number.isFinite(value) && (beyond(x[at], across) || beyond(value, up))
      ? [`${labels[at]} (${brief(x[at])}, ${brief(value)})`] : [])));
  if (hidden.size === 0) return chart.note;
  return `${chart.note ? chart.note + '; ' : ''}not shown, far from the others: ${[...hidden].slice(0, 3).join(', ')}` +
         (hidden.size > 3 ? ` and ${hidden.size - 3} more` : '');
}

// Names of categories that are wider than their places, of a plot so wide, stand aslant.
const kLetter = 6.6, kBeside = 90;  // what is beside the plot
export function label_option(chart, width) {
  const widest = Math.max(0, ...chart.categories.map((name) => kLetter * name.length));
  return by_category(chart) && widest * chart.categories.length > width ? {rotate: 24, width: undefined} : {};
}

function x_axis(chart, label) {
  const name = {name: chart.x_label, nameLocation: 'middle', nameGap: 30};
  if (by_category(chart)) {
    return axis({...name, type: 'category', data: chart.categories,
                 axisLabel: {interval: 0, hideOverlap: false, width: 90, overflow: 'break', ...label},
                 axisTick: {show: false}});
  }
  const across = chart.form === 'scatter' ? chart.series.flatMap((one) => one.x) : chart.x;
  const own = chart.form === 'lines' && (chart.categories.length > 0 || chart.x.length <= 8);
  const marks = own ? {customValues: chart.x, hideOverlap: true,
                       formatter: (value) => chart.categories[chart.x.indexOf(value)] ?? brief(value)}
                    : {formatter: marked(across), hideOverlap: true};
  const places = finite(across).filter((value) => !chart.log_x || value > 0);
  const low = Math.min(...places), high = Math.max(...places);
  const type = chart.log_x && chart.form !== 'scatter' ? 'log' : 'value';
  const free = chart.form === 'scatter' || places.length === 0;
  const ends = free ? fences(chart)[0] ?? {scale: true, boundaryGap: ['5%', '5%']} : {min: low, max: high};
  return axis({...name, ...ends, type, axisLabel: marks, splitLine: {show: false},
               ...(own ? {axisTick: {customValues: chart.x}} : {})});
}

function y_axis(chart) {
  const values = finite(chart.series.flatMap((one) => [one.values, one.low ?? [], one.high ?? []].flat()));
  const above = values.filter((value) => value > 0);
  const named = {name: chart.y_label, nameLocation: 'middle', nameGap: 46,
                 axisLabel: {formatter: brief, hideOverlap: true}};
  if (!logarithmic_y(chart) || above.length === 0) {
    const free = chart.form === 'scatter' || (chart.form === 'lines' && !chart.from_zero);
    const whole = chart.form === 'stacked' && chart.y_label.startsWith('%') && Math.max(...sums(chart)) < 100.01;
    const ends = fences(chart)[1] ?? {scale: true, boundaryGap: ['5%', '5%']};
    const label = {...named.axisLabel, formatter: marked(values)};
    if (free) return axis({...named, type: 'value', ...ends, axisLabel: label});
    return axis({...named, type: 'value', ...(whole ? {max: 100} : {})});
  }
  const ticks = decade_ticks(Math.min(...above), Math.max(...above));
  const own = ticks.length > 12 ? {} : {customValues: ticks};
  return axis({...named, type: 'log', min: ticks[0], startValue: ticks[0], max: ticks.at(-1), axisTick: own,
               axisLabel: {...named.axisLabel, ...own}});
}

const states = ['busy', 'starved', 'blocked', 'memory'];

// The states of a unit have colors of their own, and so has each stream of memory.
function color_of(chart, at) {
  const names = chart.series.map(({name}) => name);
  if (chart.form === 'stacked' && names.every((name) => states.includes(name))) return css(names[at]);
  if (names.every(stream_color)) return stream_color(names[at]);
  return colors()[at % 8];
}

// Bars of streams have their colors, the second part of each is lighter.
const by_stream = (chart) => chart.categories.length > 0 && chart.categories.every(stream_color);

function painted(chart, at, place) {
  const opacity = at === 0 ? 1 : 0.55;
  if (by_stream(chart))
    return {color: place === undefined ? css('weak') : stream_color(chart.categories[place]), opacity};
  const color = color_of(chart, at);
  if (!chart.series[at].outlined) return {color};
  return {color: css('ground'), borderColor: color, borderWidth: 1.5, borderType: 'dashed'};
}

// Whether so many letters fit a bar's place.
const kDigit = 6;
function fits(chart, width) {
  const places = chart.categories.length * (chart.form === 'stacked' ? 1 : chart.series.length);
  const shown = chart.form === 'stacked' ? sums(chart) : finite(chart.series.flatMap(({values}) => values));
  return (width - kBeside) / places > kDigit * Math.max(...shown.map((value) => brief(value).length));
}

function bars(chart, at, width) {
  const stacked = chart.form === 'stacked', {name, values} = chart.series[at], whole = stacked ? sums(chart) : values;
  const labelled = fits(chart, width);
  // The sum stands on the last part that there is.
  const last = (place) => chart.series.findLastIndex((one) => (shown(one.values[place]) ?? 0) > 0) === at;
  return {
    type: 'bar', name, stack: stacked ? 'all' : undefined, barMaxWidth: 56, itemStyle: painted(chart, at),
    barMinHeight: 0, barGap: '8%', barCategoryGap: stacked ? '36%' : '20%', emphasis: {disabled: true},
    data: values.map((value, place) => ({
      value: shown(value), itemStyle: by_stream(chart) ? painted(chart, at, place) : undefined,
      label: {show: labelled && (!stacked || last(place)), position: 'top', distance: 3, color: css('weak'),
              fontSize: 10, formatter: () => brief(whole[place])},
    })),
    labelLayout: {hideOverlap: true},
  };
}

// On a logarithmic axis no bar has a length: a dot, and the range round it.
function dots(chart, at) {
  const {name, values, low = [], high = []} = chart.series[at], color = color_of(chart, at);
  const longest = Math.max(...finite(values).map((value) => brief(value).length));
  return {
    type: 'custom', name, itemStyle: {color}, encode: {x: 0, y: [1, 2, 3]},
    data: values.map((value, place) => [place, shown(value, true), shown(low[place], true), shown(high[place], true)]),
    renderItem: (_, api) => {
      const value = api.value(1), aside = (at - (chart.series.length - 1) / 2) * 14;
      if (!(value > 0)) return null;
      const place = (y) => {
        const [x, down] = api.coord([api.value(0), y]);
        return [x + aside, down];
      };
      const [x, y] = place(value), text = brief(value);
      const ends = [api.value(2), api.value(3)].filter((end) => end > 0).map((end) => place(end)[1]);
      const stroke = (x1, y1, x2, y2) => ({type: 'line', shape: {x1, y1, x2, y2},
                                           style: {stroke: color, lineWidth: 1.5}});
      const room = api.size([1, 0])[0] / chart.series.length > 14 + kDigit * longest;
      return {type: 'group', children: [
        ...(ends.length === 2 ? [stroke(x, ends[0], x, ends[1])] : []),
        ...ends.map((end) => stroke(x - 5, end, x + 5, end)),
        {type: 'circle', shape: {cx: x, cy: y, r: 5}, style: {fill: color}},
        ...(room ? [{type: 'text', style: {text, x: x + 8, y, fill: css('text'), fontSize: 10,
                                           verticalAlign: 'middle'}}] : []),
      ]};
    },
  };
}

function line(chart, at) {
  const {name, values, outlined} = chart.series[at];
  return {
    type: 'line', name, symbol: 'circle', symbolSize: 7, showAllSymbol: true, emphasis: {disabled: true},
    itemStyle: {color: colors()[at % 8]}, lineStyle: {width: 2, type: outlined ? 'dashed' : 'solid'},
    data: chart.x.map((x, place) => [x, shown(values[place], chart.log_y)]),
  };
}

function bins(chart) {
  const {name, values} = chart.series[0];
  return {
    type: 'custom', name, encode: {x: [0, 1], y: 2},
    data: values.map((value, at) => [chart.x[at], chart.x[at + 1], value]),
    renderItem: (_, api) => {
      const [left, top] = api.coord([api.value(0), api.value(2)]), [right, bottom] = api.coord([api.value(1), 0]);
      const width = Math.max(right - left - 1, 0.5), height = Math.max(bottom - top, 0);
      return {type: 'rect', style: {fill: colors()[0]}, shape: {x: left + 0.5, y: top, width, height}};
    },
  };
}

function cloud(chart, at) {
  const {name, values, x, labels, outlined, named, copies} = chart.series[at];
  const points = values.map((value, place) => ({
    value: [shown(x[place]), shown(value)], name: labels[place], copies: copies?.[place],
    cursor: copies?.[place] === undefined ? 'default' : 'pointer',
  }));
  return {
    type: outlined ? 'line' : 'scatter', name, data: points, symbol: 'circle', symbolSize: named ? 10 : 7,
    itemStyle: outlined ? {color: css('ground'), borderColor: colors()[at % 8], borderWidth: 2}
                        : {color: colors()[at % 8], opacity: named ? 1 : 0.75},
    lineStyle: {type: 'dashed', width: 1.5, color: colors()[at % 8]}, showAllSymbol: true, z: outlined || named ? 3 : 2,
    label: {show: named === true || outlined === true, position: 'top', color: css('text'), fontSize: 10,
            formatter: '{b}', width: 110, overflow: 'truncate'},
    labelLayout: {hideOverlap: true, moveOverlap: 'shiftY'}, emphasis: {disabled: true},
  };
}

function series_of(chart, width) {
  const side = chart.log_y ? dots : bars;
  const make = {bars: side, stacked: bars, lines: line, histogram: bins, scatter: cloud}[chart.form];
  return chart.series.map((_, at) => make(chart, at, width));
}

// A tooltip is made of elements: whatever a name holds, it is text.
function hint(chart, given) {
  const rows = Array.isArray(given) ? given : [given], first = rows[0];
  const lines = (head, pairs) => element('div', {class: 'hint'}, element('strong', {}, head),
    ...pairs.map(([name, value]) => element('div', {}, `${name}: ${value}`)));
  if (chart.form === 'scatter') {
    const [x, y] = first.value;
    return lines(first.name || first.seriesName, [
      ...(first.name ? [['of', first.seriesName]] : []), [chart.x_label, short(x)], [chart.y_label, short(y)],
      ...(first.data.copies === undefined ? [] : [['click', 'copies the configuration']])]);
  }
  if (chart.form === 'histogram') {
    const [from, to, count] = first.value;
    return lines(`${short(from)} to ${short(to)}`, [[chart.y_label || first.seriesName, short(count)]]);
  }
  const at = first.dataIndex;
  const head = chart.categories[at] ?? `${short(chart.x[at])} ${chart.x_label}`;
  const pairs = rows.map((row) => {
    const {values, low, high} = chart.series[row.seriesIndex];
    return [row.seriesName, short(values[at]) + (low ? ` (${short(low[at])} to ${short(high[at])})` : '')];
  });
  if (chart.form === 'stacked' && pairs.length > 1) pairs.push(['sum', short(sums(chart)[at])]);
  return lines(head, pairs);
}

// Of a chart so wide; as much as there is without it.
export function chart_option(chart, width = Infinity) {
  const label = label_option(chart, width - kBeside);
  const [first] = chart.series;
  const legend = chart.series.length > 1 || first?.outlined === true || first?.low !== undefined;
  return {
    animation: false,
    color: colors(),
    backgroundColor: 'transparent',
    textStyle: {fontFamily: font(), color: css('text')},
    aria: {enabled: true, label: {description: described(chart)}},
    legend: {show: legend, type: 'scroll', top: 0, left: 0, right: 0, icon: 'roundRect', itemWidth: 13, itemHeight: 11,
             inactiveColor: css('line'), textStyle: {color: css('text'), fontSize: 12},
             pageTextStyle: {color: css('weak')}, pageIconColor: css('strong'), pageIconInactiveColor: css('line')},
    grid: {left: chart.y_label ? 68 : 48, right: 18, top: legend ? 40 : 22,
           bottom: (chart.x_label ? 52 : 34) + (label.rotate ? 18 : 0)},
    xAxis: x_axis(chart, label),
    yAxis: y_axis(chart),
    tooltip: {...tooltip_box(), trigger: ['scatter', 'histogram'].includes(chart.form) ? 'item' : 'axis',
              axisPointer: {type: chart.form === 'lines' ? 'line' : 'shadow', label: {show: false}},
              formatter: (given) => hint(chart, given)},
    series: series_of(chart, width),
  };
}

function described(chart) {
  const forms = {bars: 'bars', stacked: 'stacked bars', lines: 'lines', histogram: 'a histogram', scatter: 'points'};
  const axes = [chart.y_label, chart.x_label].filter((label) => label).join(' over ');
  return `${chart.title}: ${forms[chart.form]}${axes ? ' of ' + axes : ''}. ` +
         `${chart.series.map(({name}) => name).join(', ')}. The numbers are in the table that follows.`;
}

// The numbers of a chart as a table: a row for each category, bin, place or point.
export function chart_table(chart) {
  if (chart.form === 'scatter') {
    return {columns: [{name: 'series', word: true}, {name: 'point', word: true}, {name: chart.x_label},
                      {name: chart.y_label}],
            rows: chart.series.flatMap(({name, labels, x, values}) => values.map(
              (value, at) => [name, labels[at], x[at], value]))};
  }
  const first = {name: chart.x_label || 'category', word: chart.form !== 'lines' || chart.categories.length > 0};
  const head = (at) => chart.form === 'histogram' ? `${short(chart.x[at])} to ${short(chart.x[at + 1])}`
                                                  : chart.categories[at] ?? chart.x[at];
  const count = Math.max(0, ...chart.series.map(({values}) => values.length));
  const ends = ({low, high}) => low ? [{name: 'least', values: low}, {name: 'most', values: high}] : [];
  const columns = chart.series.flatMap((one) => [{name: one.name || chart.y_label, values: one.values}, ...ends(one)]);
  return {columns: [first, ...columns.map(({name}) => ({name}))],
          rows: Array.from({length: count}, (_, at) => [head(at), ...columns.map(({values}) => values[at])])};
}

// A figure with title, chart, note and its numbers. `on_click` gets {series, index, name, copies} of a point that has
// something to copy.
export function draw_chart(container, chart, {on_click} = {}) {
  const place = element('div', {class: 'chart'});
  const numbers = element('details', {class: 'numbers', ontoggle: () => {
    if (numbers.open && numbers.children.length === 1) numbers.append(table(chart_table(chart)));
  }}, element('summary', {}, 'numbers of this chart'));
  container.append(element('figure', {class: 'charted'}, element('h3', {}, chart.title), place,
                           note_of(chart) ? element('figcaption', {}, note_of(chart)) : null, numbers));
  const drawn = init(place, null, {renderer: 'svg'});
  // On paper the drawing is scaled: it says how large it is.
  const sized = () => {
    place.querySelector('svg').setAttribute('viewBox', `0 0 ${drawn.getWidth()} ${drawn.getHeight()}`);
  };
  const redraw = () => {
    drawn.setOption(chart_option(chart, drawn.getWidth()), {notMerge: true});
    sized();
  };
  redraw();
  on_look(redraw);
  new ResizeObserver(() => {
    if (paper()) return;
    drawn.resize();
    redraw();
  }).observe(place);
  drawn.on('click', ({seriesIndex, dataIndex, data}) => {
    if (data?.copies !== undefined && on_click)
      on_click({series: seriesIndex, index: dataIndex, name: data.name, copies: data.copies});
  });
  return drawn;
}
