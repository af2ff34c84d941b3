// SPDX-License-Identifier: Apache-2.0
// data.mjs: what the program wrote into the page: JSON, and planes of numbers (sim/report/html/document.hpp).
//
// Format  A plane is base64 of a picture in lossless WebP: of kind rgb8 three numbers a place, of u8 one (green), of
//         u16 one of two bytes (red is the high one). A file is base64 of deflated bytes.

export const data = JSON.parse(document.getElementById('data').textContent);

const kept = new Map();

function from_base64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

const bytes_of = (name) => from_base64(document.getElementById('plane:' + name).textContent);

// The picture that a plane is.
export const picture_of = (name) => new Blob([bytes_of(name)], {type: 'image/webp'});

async function unpack(name) {
  const {width, height, kind} = data.planes[name];
  const picture = await createImageBitmap(picture_of(name), {colorSpaceConversion: 'none', premultiplyAlpha: 'none'});
  const context = new OffscreenCanvas(width, height).getContext('2d', {willReadFrequently: true});
  context.drawImage(picture, 0, 0);
  const rgba = context.getImageData(0, 0, width, height).data, places = width * height;
  const values = kind === 'u16' ? new Uint16Array(places) : new Uint8Array(kind === 'u8' ? places : 3 * places);
  if (kind === 'rgb8') {
    for (let at = 0, to = 0; at < 4 * places; at += 4) {
      values[to++] = rgba[at];
      values[to++] = rgba[at + 1];
      values[to++] = rgba[at + 2];
    }
  } else {
    const high = kind === 'u16' ? 256 : 0;
    for (let at = 0; at < places; ++at) values[at] = rgba[4 * at] * high + rgba[4 * at + 1];
  }
  return values;
}

// The numbers of a plane, unpacked when they are first asked for.
export function plane(name) {
  if (!kept.has(name)) kept.set(name, unpack(name));
  return kept.get(name);
}

// The bytes of a file that the page holds.
export async function file(name) {
  const stream = new Blob([bytes_of(name)]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
