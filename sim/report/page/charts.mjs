// SPDX-License-Identifier: Apache-2.0
// charts.mjs: a Chart of the program (sim/report/chart.hpp writes it as JSON) drawn by ECharts as SVG, in a page here
// and in a file by svg.mjs.
//
// Format  {name, form: bars, stacked, lines, histogram or scatter; title, x_label, y_label, note; categories; x; log_x,
//         log_y, from_zero; series: [{name, values, outlined, x, labels, named, copies}]}. null leaves a gap.
// Rule    Colors are the page's (page.css). What can be seen in a chart can be read beneath it, in a table.
import {BarChart, CustomChart, LineChart, ScatterChart} from 'echarts/charts';
import {AriaComponent, GridComponent, LegendComponent, TooltipComponent} from 'echarts/components';
import {init, use} from 'echarts/core';
import {LabelLayout} from 'echarts/features';
import {SVGRenderer} from 'echarts/renderers';
import {axis, colors, css, decade_ticks, font, on_look, paper, tooltip_box} from './look.mjs';
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

const finite = (values) => values.filter((value) => Number.isFinite(value));
const by_category = (chart) => chart.form === 'bars' || chart.form === 'stacked';
const logarithmic_y = (chart) => chart.log_y && (chart.form === 'bars' || chart.form === 'lines');
// What an axis cannot show leaves a gap.
const shown = (value, log) => Number.isFinite(value) && (!log || value > 0) ? value : null;

function sums(chart) {
  return chart.categories.map(
    (_, at) => chart.series.reduce((sum, {values}) => sum + Math.max(shown(values[at]) ?? 0, 0), 0));
}

function x_axis(chart) {
  const name = {name: chart.x_label, nameLocation: 'middle', nameGap: 30};
  if (by_category(chart)) {
    return axis({...name, type: 'category', data: chart.categories,
                 axisLabel: {interval: 0, hideOverlap: false, width: 90, overflow: 'break'}, axisTick: {show: false}});
  }
  const own = chart.form === 'lines' && (chart.categories.length > 0 || chart.x.length <= 8);
  const label = own ? {customValues: chart.x, hideOverlap: true,
                       formatter: (value) => chart.categories[chart.x.indexOf(value)] ?? brief(value)}
                    : {formatter: brief, hideOverlap: true};
  const places = finite(chart.form === 'scatter' ? chart.series.flatMap((one) => one.x) : chart.x)
                   .filter((value) => !chart.log_x || value > 0);
  const low = Math.min(...places), high = Math.max(...places);
  const type = chart.log_x && chart.form !== 'scatter' ? 'log' : 'value';
  const ends = chart.form === 'scatter' || places.length === 0 ? {scale: true, boundaryGap: ['5%', '5%']}
                                                               : {min: low, max: high};
  return axis({...name, ...ends, type, axisLabel: label, splitLine: {show: false},
               ...(own ? {axisTick: {customValues: chart.x}} : {})});
}

function y_axis(chart) {
  const named = {name: chart.y_label, nameLocation: 'middle', nameGap: 46,
                 axisLabel: {formatter: brief, hideOverlap: true}};
  const values = finite(chart.series.flatMap((one) => one.values)), above = values.filter((value) => value > 0);
  if (!logarithmic_y(chart) || above.length === 0) {
    const free = chart.form === 'scatter' || (chart.form === 'lines' && !chart.from_zero);
    const whole = chart.form === 'stacked' && chart.y_label.startsWith('%') && Math.max(...sums(chart)) < 100.01;
    return axis({...named, type: 'value', ...(free ? {scale: true, boundaryGap: ['5%', '5%']} : {}),
                 ...(whole ? {max: 100} : {})});
  }
  // The smallest bar has a height, too.
  const low = Math.min(...above) * (chart.form === 'bars' ? 0.5 : 1), ticks = decade_ticks(low, Math.max(...above));
  const own = ticks.length > 12 ? {} : {customValues: ticks};
  return axis({...named, type: 'log', min: ticks[0], startValue: ticks[0], max: ticks.at(-1), axisTick: own,
               axisLabel: {...named.axisLabel, ...own}});
}

const states = ['busy', 'starved', 'blocked', 'memory'];

// The states of a unit have colors of their own.
function color_of(chart, at) {
  const own = chart.form === 'stacked' && chart.series.every(({name}) => states.includes(name));
  return own ? css(chart.series[at].name) : colors()[at % 8];
}

function painted(chart, at) {
  const color = color_of(chart, at);
  if (!chart.series[at].outlined) return {color};
  return {color: css('ground'), borderColor: color, borderWidth: 1.5, borderType: 'dashed'};
}

function bars(chart, at) {
  const stacked = chart.form === 'stacked', {name, values} = chart.series[at], whole = stacked ? sums(chart) : values;
  // The sum stands on the last part that there is.
  const last = (place) => chart.series.findLastIndex((one) => (shown(one.values[place]) ?? 0) > 0) === at;
  return {
    type: 'bar', name, stack: stacked ? 'all' : undefined, barMaxWidth: 56, itemStyle: painted(chart, at),
    barMinHeight: 0, barGap: '8%', barCategoryGap: stacked ? '36%' : '20%', emphasis: {disabled: true},
    data: values.map((value, place) => ({
      value: shown(value, !stacked && chart.log_y),
      label: {show: !stacked || last(place), position: 'top', distance: 3, color: css('weak'), fontSize: 10,
              formatter: () => brief(whole[place])},
    })),
    labelLayout: {hideOverlap: true},
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

function series_of(chart) {
  const make = {bars, stacked: bars, lines: line, histogram: bins, scatter: cloud}[chart.form];
  return chart.series.map((_, at) => make(chart, at));
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
  const pairs = rows.map((row) => [row.seriesName, short(chart.series[row.seriesIndex].values[at])]);
  if (chart.form === 'stacked' && pairs.length > 1) pairs.push(['sum', short(sums(chart)[at])]);
  return lines(head, pairs);
}

export function chart_option(chart) {
  const legend = chart.series.length > 1 || chart.series[0]?.outlined === true;
  return {
    animation: false,
    color: colors(),
    backgroundColor: 'transparent',
    textStyle: {fontFamily: font(), color: css('text')},
    aria: {enabled: true, label: {description: described(chart)}},
    legend: {show: legend, type: 'scroll', top: 0, left: 0, right: 0, icon: 'roundRect', itemWidth: 13, itemHeight: 11,
             inactiveColor: css('line'), textStyle: {color: css('text'), fontSize: 12},
             pageTextStyle: {color: css('weak')}, pageIconColor: css('strong'), pageIconInactiveColor: css('line')},
    grid: {left: chart.y_label ? 68 : 48, right: 18, top: legend ? 40 : 22, bottom: chart.x_label ? 52 : 34},
    xAxis: x_axis(chart),
    yAxis: y_axis(chart),
    tooltip: {...tooltip_box(), trigger: ['scatter', 'histogram'].includes(chart.form) ? 'item' : 'axis',
              axisPointer: {type: chart.form === 'lines' ? 'line' : 'shadow', label: {show: false}},
              formatter: (given) => hint(chart, given)},
    series: series_of(chart),
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
  return {columns: [first, ...chart.series.map(({name}) => ({name: name || chart.y_label}))],
          rows: Array.from({length: count}, (_, at) => [head(at), ...chart.series.map(({values}) => values[at])])};
}

// A figure with title, chart, note and its numbers. `on_click` gets {series, index, name, copies} of a point that has
// something to copy.
export function draw_chart(container, chart, {on_click} = {}) {
  const place = element('div', {class: 'chart'});
  const numbers = element('details', {class: 'numbers', ontoggle: () => {
    if (numbers.open && numbers.children.length === 1) numbers.append(table(chart_table(chart)));
  }}, element('summary', {}, 'numbers of this chart'));
  container.append(element('figure', {class: 'charted'}, element('h3', {}, chart.title), place,
                           chart.note ? element('figcaption', {}, chart.note) : null, numbers));
  const drawn = init(place, null, {renderer: 'svg'});
  // On paper the drawing is scaled: it says how large it is.
  const sized = () => {
    place.querySelector('svg').setAttribute('viewBox', `0 0 ${drawn.getWidth()} ${drawn.getHeight()}`);
  };
  const redraw = () => {
    drawn.setOption(chart_option(chart), {notMerge: true});
    sized();
  };
  redraw();
  on_look(redraw);
  new ResizeObserver(() => {
    if (paper()) return;
    drawn.resize();
    sized();
  }).observe(place);
  drawn.on('click', ({seriesIndex, dataIndex, data}) => {
    if (data?.copies !== undefined && on_click)
      on_click({series: seriesIndex, index: dataIndex, name: data.name, copies: data.copies});
  });
  return drawn;
}
