// SPDX-License-Identifier: Apache-2.0
// camera.mjs: the camera of a frame as three.js has it.
//
// Terms   A frame's camera is INRIA's: x right, y down, z forward, and a pixel's center is its number. three.js has x
//         right, y up, z backward. `part` is the rectangle of the picture that the machine rendered.
import {Matrix4, PerspectiveCamera} from 'three';

const kFar = 1e5;  // in near planes

// The corners of the part on the plane z = 1 of the camera, y down.
function window_of({width, height, fx, fy, cx, cy}, [x, y, w, h] = [0, 0, width, height]) {
  return {
    left: (x - cx - 0.5) / fx,
    right: (x + w - cx - 0.5) / fx,
    top: (y - cy - 0.5) / fy,
    bottom: (y + h - cy - 0.5) / fy,
  };
}

export function pose(frame) {
  const [r0, r1, r2] = frame.rotation, [x, y, z] = frame.position;
  return new Matrix4(r0[0], -r0[1], -r0[2], x, r1[0], -r1[1], -r1[2], y, r2[0], -r2[1], -r2[2], z, 0, 0, 0, 1);
}

export function camera_of(frame, near) {
  const {left, right, top, bottom} = window_of(frame, frame.part);
  const camera = new PerspectiveCamera();
  camera.near = near;
  camera.far = kFar * near;
  camera.projectionMatrix.makePerspective(left * near, right * near, -top * near, -bottom * near, near, camera.far);
  camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
  camera.fov = 360 / Math.PI * Math.atan((bottom - top) / 2);  // of its movements alone
  place(camera, pose(frame));
  camera.up.transformDirection(camera.matrixWorld);
  return camera;
}

export function place(camera, matrix) {
  matrix.decompose(camera.position, camera.quaternion, camera.scale);
  camera.updateMatrixWorld();
}

// How far the whole picture reaches, in half sides of its part: 1 when the part is all.
export function reach(frame) {
  const whole = window_of(frame), part = window_of(frame, frame.part);
  const along = (low, high, part_low, part_high) => {
    const middle = (part_low + part_high) / 2, half = (part_high - part_low) / 2;
    return Math.max(middle - low, high - middle) / half;
  };
  return Math.max(1, along(whole.left, whole.right, part.left, part.right),
                  along(whole.top, whole.bottom, part.top, part.bottom));
}
