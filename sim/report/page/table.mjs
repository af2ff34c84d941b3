// SPDX-License-Identifier: Apache-2.0
// table.mjs: a table whose columns sort.
//
// Format  {title, columns: [{name, word, long, copy}], rows: [[cell ...]], marked: [rows]}. A cell is text, a number or
//         {text, value, copy, link}: `value` is what it sorts by, `copy` what its button copies, `link` where it leads
//         to in this page. Words stand left, numbers right; what is not there comes last in either order.
import {copy_button, element, short} from './parts.mjs';

const text_of = (cell) => cell === null || cell === undefined ? ''
                        : typeof cell === 'number' ? short(cell) : typeof cell === 'object' ? cell.text : String(cell);

function key_of(cell) {
  if (cell === null || cell === undefined) return null;
  if (typeof cell === 'object') return cell.value ?? (cell.text === '' ? null : cell.text);
  return cell === '' || Number.isNaN(cell) ? null : cell;
}

function compare(a, b) {
  if (typeof a === 'number' && typeof b === 'number') return a - b;
  if (typeof a === 'number') return -1;
  if (typeof b === 'number') return 1;
  return a.localeCompare(b, 'en', {numeric: true});
}

function cell_of(cell, {word, long, copy}) {
  const rich = typeof cell === 'object' ? cell : null;
  const text = text_of(cell), what = copy ? rich?.copy ?? text : '';
  const shown = rich?.link ? element('a', {href: '#' + rich.link}, text) : text;
  const kind = long ? 'long' : word ? 'word' : undefined;
  return element('td', {class: kind}, ...(what === '' ? [shown] : [copy_button(what), ' ', shown]));
}

// `scrolled`: the table in its own room, which scrolls sideways when it must.
export function table(data) {
  const body = element('tbody'), order = data.rows.map((_, at) => at), marked = new Set(data.marked ?? []);
  const rows = data.rows.map((row, at) => {
    const cells = data.columns.map((column, k) => cell_of(row[k], column));
    const whole = data.columns.findIndex(({copy}) => copy), copies = whole < 0 ? undefined : row[whole]?.copy;
    return element('tr', {class: marked.has(at) && 'marked', 'data-copies': copies}, ...cells);
  });
  body.append(...rows);
  let sorted = -1, rising = true;
  const sort = (column) => {
    rising = sorted === column ? !rising : true;
    sorted = column;
    order.sort((left, right) => {
      const a = key_of(data.rows[left][column]), b = key_of(data.rows[right][column]);
      if (a === null || b === null) return (a === null) - (b === null) || left - right;
      return (rising ? compare(a, b) : compare(b, a)) || left - right;
    });
    body.append(...order.map((at) => rows[at]));
    heads.forEach((head, at) => {
      if (at === column) head.setAttribute('aria-sort', rising ? 'ascending' : 'descending');
      else head.removeAttribute('aria-sort');
    });
  };
  const heads = data.columns.map(({name, word, long}, at) => element(
    'th', {scope: 'col', class: (word || long) && 'word'},
    element('button', {type: 'button', onclick: () => sort(at)}, name || '\u00a0')));
  return element('div', {class: 'wide', tabindex: '0', role: 'region', 'aria-label': data.title || 'table'},
                 element('table', {class: data.columns.length > 14 && 'dense'},
                         element('thead', {}, element('tr', {}, ...heads)), body));
}

// Marks the row that holds `copies`, in all tables of `within`, and brings the first of them into view.
export function mark_row(within, copies) {
  let first = null;
  for (const row of within.querySelectorAll('tr[data-copies]')) {
    const same = row.dataset.copies === copies;
    row.classList.toggle('marked', same);
    if (same && first === null) first = row;
  }
  first?.scrollIntoView({block: 'nearest'});
  return first;
}
