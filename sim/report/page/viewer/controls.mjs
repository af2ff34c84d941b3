// SPDX-License-Identifier: Apache-2.0
// controls.mjs: the viewer's camera by mouse, touch and keys.
//
// Idea    It turns about a point in front of the camera at the depth of the scene, sideways about the frame's own
//         upright, so that the horizon stays where the frame has it. The wheel is the page's until the canvas has the
//         focus.
import {Matrix4, Vector3} from 'three';

import {place} from './camera.mjs';

const kTurn = Math.PI / 36;  // a key
const kStep = 0.05;          // of the way to the point, a key

export class Controls {
  constructor(canvas, moved) {
    this.canvas = canvas;
    this.moved = moved;
    canvas.addEventListener('keydown', (event) => this.key(event));
    canvas.addEventListener('pointerdown', (event) => {
      canvas.focus();
      canvas.setPointerCapture(event.pointerId);
      this.last = event;
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!canvas.hasPointerCapture(event.pointerId)) return;
      const share_x = (event.clientX - this.last.clientX) / canvas.clientWidth;
      const share_y = (event.clientY - this.last.clientY) / canvas.clientHeight;
      this.last = event;
      if (event.shiftKey || event.buttons === 2) this.shift(-2 * share_x, 2 * share_y, 0);
      else this.turn(-Math.PI * share_x, -Math.PI * share_y);
    });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => {
      if (document.activeElement !== canvas) return;
      event.preventDefault();
      this.shift(0, 0, Math.sign(event.deltaY) * kStep);
    }, {passive: false});
  }

  // From here on it moves this camera, about a point at this depth.
  take(camera, depth) {
    this.camera = camera;
    this.upright = new Vector3(0, 1, 0).transformDirection(camera.matrixWorld);
    this.depth = depth;
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const act = {
      ArrowLeft: () => this.turn(-kTurn, 0),
      ArrowRight: () => this.turn(kTurn, 0),
      ArrowUp: () => this.turn(0, -kTurn),
      ArrowDown: () => this.turn(0, kTurn),
      w: () => this.shift(0, 0, -kStep),
      s: () => this.shift(0, 0, kStep),
      a: () => this.shift(-kStep, 0, 0),
      d: () => this.shift(kStep, 0, 0),
      q: () => this.shift(0, -kStep, 0),
      e: () => this.shift(0, kStep, 0),
    }[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  turn(sideways, over) {
    const {camera} = this;
    const point = new Vector3(0, 0, -this.depth).applyMatrix4(camera.matrixWorld);
    const right = new Vector3(1, 0, 0).transformDirection(camera.matrixWorld);
    const turned = new Matrix4().makeTranslation(point)
                     .multiply(new Matrix4().makeRotationAxis(this.upright, sideways))
                     .multiply(new Matrix4().makeRotationAxis(right, over))
                     .multiply(new Matrix4().makeTranslation(point.clone().negate()))
                     .multiply(camera.matrixWorld);
    place(camera, turned);
    this.moved();
  }

  // Along the camera's own axes, in depths of the point, which goes along but for what is forward.
  shift(right, up, back) {
    const way = new Matrix4().makeTranslation(right * this.depth, up * this.depth, back * this.depth);
    place(this.camera, this.camera.matrixWorld.clone().multiply(way));
    this.moved();
  }
}
