// SPDX-License-Identifier: Apache-2.0
// study.mjs: the page of a study: what it asks, charts, tables, pictures, and the command that makes it again.
//
// Format  {title, command, version, lead: [sentences], sections: [{title, notes: [sentences], charts, tables, pictures:
//         [{caption, id}]}]}. A picture is the plane of its id.
import {draw_chart} from './charts.mjs';
import {picture_of} from './data.mjs';
import {copy, element, made_by, section} from './parts.mjs';
import {mark_row, table} from './table.mjs';

const list = (given) => Array.isArray(given) ? given : [];

async function picture(one) {
  const shown = element('img', {src: URL.createObjectURL(picture_of(one.id)), alt: one.caption});
  await shown.decode().catch(() => shown.replaceWith(element('p', {class: 'note'}, 'This picture cannot be shown.')));
  return element('figure', {id: one.id}, shown, element('figcaption', {}, one.caption));
}

async function add_section(main, data, said) {
  const room = section(data.title);
  room.classList.add('long');  // may go over several sheets of paper
  main.append(room);
  room.append(...list(data.notes).map((text) => element('p', {}, text)));
  const grid = element('div', {class: 'grid'});
  if (list(data.charts).length > 0) room.append(grid);
  for (const chart of list(data.charts)) {
    draw_chart(grid, chart, {on_click: async ({name, copies}) => {
      await copy(copies);
      mark_row(main, copies);
      said.textContent = `copied the configuration of ${name}: ${copies}`;
      said.classList.add('shown');
    }});
  }
  for (const one of list(data.tables)) {
    if (one.title) room.append(element('h3', {}, one.title));
    room.append(table(one), ...list(one.notes).map((text) => element('p', {class: 'note'}, text)));
  }
  const pictures = await Promise.all(list(data.pictures).map(picture));
  if (pictures.length > 0) room.append(element('div', {class: 'pictures'}, ...pictures));
}

export async function study_page(main, data) {
  const said = element('p', {class: 'said', role: 'status'});
  main.append(element('h1', {}, data.title), ...list(data.lead).map((text) => element('p', {class: 'lead'}, text)));
  for (const one of list(data.sections)) await add_section(main, one, said);
  main.append(made_by(data), said);
}
