// SPDX-License-Identifier: Apache-2.0
// measure.mjs: two pictures of 8 bits held against each other.

// `machine` is R G B, `viewer` R G B A. The difference picture is R G B A, each code `factor` times its size.
export function compared(machine, viewer, factor) {
  const places = machine.length / 3, picture = new Uint8ClampedArray(4 * places).fill(255);
  let squares = 0, largest = 0;
  for (let at = 0; at < places; ++at) {
    for (let c = 0; c < 3; ++c) {
      const difference = Math.abs(machine[3 * at + c] - viewer[4 * at + c]);
      squares += difference * difference;
      largest = Math.max(largest, difference);
      picture[4 * at + c] = factor * difference;
    }
  }
  const mean = squares / machine.length;
  return {psnr: mean === 0 ? Infinity : 10 * Math.log10(255 * 255 / mean), rms: Math.sqrt(mean), largest, picture};
}

export function show(canvas, width, height, rgba) {
  canvas.width = width;
  canvas.height = height;
  canvas.getContext('2d').putImageData(new ImageData(rgba, width, height), 0, 0);
}

export function show_rgb(canvas, width, height, rgb) {
  const rgba = new Uint8ClampedArray(4 * width * height).fill(255);
  for (let at = 0; at < width * height; ++at) {
    for (let c = 0; c < 3; ++c) rgba[4 * at + c] = rgb[3 * at + c];
  }
  show(canvas, width, height, rgba);
}
