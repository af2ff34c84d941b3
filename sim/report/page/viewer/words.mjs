// SPDX-License-Identifier: Apache-2.0
// words.mjs: what the page of the viewer says of itself: the scene in it, the settings, where differences come from.
import {element, grouped, section} from '../parts.mjs';
import {defaults} from './spark.mjs';

const what = {
  preBlurAmount: 'square pixels added to every footprint, as INRIA\'s renderer does',
  blurAmount: 'the same, and the opacity makes up for it: what scenes for antialiasing want',
  maxStdDev: 'standard deviations at which a footprint ends; an opaque Gaussian has an alpha of 1/255 at 3.33',
  minAlpha: 'the least alpha that is drawn',
  maxPixelRadius: 'pixels beyond which a footprint is made smaller',
  clipXY: 'a Gaussian whose center lies so many half pictures from the middle is not drawn',
  sortRadial: 'order by distance instead of depth',
  accumExtSplats: 'what is drawn in float, instead of 8 to 16 bits',
  enableLod: 'levels of detail, for scenes that have them',
  extSplats: 'the scene in float, instead of 8 to 16 bits; but Spark 2.2.0 then cuts the largest channel of an SH ' +
    'coefficient to the power of two below: better for far positions, worse for colors that change with direction',
};

const value_text = (value) => typeof value === 'number' ? String(Number(value.toPrecision(3))) : String(value);

function settings_table(all) {
  const columns = Object.values(all).map(
    ({name, mesh, renderer}) => ({name, values: {...defaults, ...mesh, ...renderer}}));
  const head = ['setting', ...columns.map(({name}) => name), 'means'];
  const row = (key) => element('tr', {}, element('td', {class: 'word'}, element('code', {}, key)),
                               ...columns.map(({values}) => element('td', {}, value_text(values[key]))),
                               element('td', {class: 'long'}, what[key]));
  return element('div', {class: 'wide'},
                 element('table', {},
                         element('thead', {}, element('tr', {}, ...head.map((text, i) => element(
                           'th', {scope: 'col', class: [0, head.length - 1].includes(i) ? 'word' : false}, text)))),
                         element('tbody', {}, ...Object.keys(what).map(row))));
}

export function about(data, all) {
  const {scene} = data, {reduced} = scene, bytes = scene.files.reduce((a, b) => a + b, 0);
  return element(
    'div', {},
    section('The scene in this page',
            element('p', {}, scene.name + ': ' + grouped(scene.gaussians) + ' Gaussians, SH degree ' + scene.sh_degree +
                    ', ' + (bytes / 1e6).toFixed(1) + ' MB as .' + scene.form + '. No SH degree is left out.'),
            reduced.length === 0
              ? element('p', {id: 'reduced'}, 'Its numbers are those of the file, all of them in float.')
              : element('ul', {id: 'reduced'}, ...reduced.map((text) => element('li', {}, text)))),
    section('The settings', settings_table(all),
            element('p', {class: 'note'}, 'The machine: ' + data.machine + '; near plane ' + data.near + '.')),
    section('Where differences come from',
            element('p', {}, 'Spark blends into a canvas of 8 bits: a pixel is rounded to a code at each of its ' +
                    'Gaussians. It takes the projection\'s slope where a Gaussian lies, also outside of the ' +
                    'picture, where the machine and INRIA\'s renderer hold it at 1.3 of the picture\'s edge. It ' +
                    'keeps the scene in fewer bits than the machine. And it orders all Gaussians of the picture by ' +
                    'depth, the machine by layers.')));
}
