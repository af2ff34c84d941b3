// SPDX-License-Identifier: Apache-2.0
// parts.mjs: what all pages are put together from: elements, sections, numbers as people read them.

// element('p', {class: 'note'}, 'text', child ...); a property that begins with `on` is a listener.
export function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
    else if (value !== undefined && value !== false) made.setAttribute(key, value === true ? '' : value);
  }
  made.append(...children.filter((child) => child !== undefined && child !== null));
  return made;
}

export function section(title, ...children) {
  const id = title.toLowerCase().replace(/[^a-z0-9]+/g, '-');
  return element('section', {id, 'aria-labelledby': id + '-title'}, element('h2', {id: id + '-title'}, title),
                 ...children);
}

// 1234567 -> 1 234 567
export function grouped(value) {
  return Math.round(value).toString().replace(/\B(?=(\d{3})+$)/g, '\u202f');
}

// As many digits as say something: 0.000123, 1.23, 123.
export function short(value) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '-';
  if (Number.isInteger(value)) return Math.abs(value) < 10000 ? String(value) : grouped(value);
  const size = Math.abs(value);
  if (size >= 10000) return grouped(value);
  if (size >= 0.001) return Number(value.toPrecision(4)).toString();
  return value === 0 ? '0' : value.toExponential(2);
}

export const percent = (share, digits = 1) => (100 * share).toFixed(digits) + ' %';

// A button that copies `text`, and says so.
export function copy_button(text, label = 'copy') {
  const button = element('button', {
    type: 'button',
    class: 'copy',
    onclick: async () => {
      await copy(text);
      button.textContent = 'copied';
      setTimeout(() => { button.textContent = label; }, 1200);
    },
  }, label);
  return button;
}

// A page that was opened from a file may have no clipboard: the old way is a selection.
export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = element('textarea', {}, text);
    document.body.append(area);
    area.select();
    document.execCommand('copy');
    area.remove();
  }
}

export function command_line(command) {
  return element('div', {class: 'command'}, element('code', {}, command), copy_button(command));
}

// What a page says at its end: how it was made.
export function made_by(data) {
  return section('How this page was made', command_line(data.command),
                 element('p', {class: 'note'}, data.version));
}
