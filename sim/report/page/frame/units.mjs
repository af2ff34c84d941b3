// SPDX-License-Identifier: Apache-2.0
// units.mjs: where each cycle went: a bar of 100 % for each unit, and a sentence for each kind.
import {element, grouped, percent} from '../parts.mjs';

export const states = ['busy', 'starved', 'blocked', 'memory'];
export const meanings = {
  busy: 'works', starved: 'waits for input', blocked: 'waits until its output is taken',
  memory: 'waits for external memory',
};
const kinds = [['dopu', 'DOPU'], ['pu', 'PU'], ['su', 'SU'], ['ru', 'RU']];

export function state_legend() {
  return element('ul', {class: 'key'}, ...states.map((state) => element(
    'li', {}, element('span', {class: 'swatch ' + state, 'aria-hidden': 'true'}), `${state}: ${meanings[state]}`)));
}

function bar(name, unit, cycles) {
  const parts = states.map((state) => [state, unit[state] / cycles]);
  const text = parts.map(([state, share]) => `${state} ${percent(share)}`).join(', ');
  return element('div', {class: 'unit', role: 'img', 'aria-label': `${name}: ${text}`, title: `${name}: ${text}`},
    element('span', {class: 'who'}, name),
    element('span', {class: 'hundred'}, ...parts.filter(([, share]) => share > 0).map(([state, share]) => element(
      'span', {class: state, style: `width: ${100 * share}%`, 'data-share': share.toFixed(6)},
      share > 0.06 ? percent(share, share >= 0.995 ? 0 : 1) : ''))));
}

export function units_section(report, sentences) {
  const rows = [];
  for (const [key, name] of kinds) {
    const units = report.units[key];
    units.forEach((unit, at) => rows.push(bar(units.length > 1 ? `${name} ${at}` : name, unit, report.cycles)));
    rows.push(element('p', {class: 'says'}, sentences.units[key]));
  }
  return [element('p', {}, `Each bar is the frame's ${grouped(report.cycles)} cycles, of which a unit spends each in ` +
                           'one of four states:'), state_legend(), element('div', {class: 'units'}, ...rows)];
}
