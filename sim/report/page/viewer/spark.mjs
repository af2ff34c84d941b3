// SPDX-License-Identifier: Apache-2.0
// spark.mjs: Spark on a canvas: the scene, the settings, and draws that end when the picture is the camera's.
//
// Idea    Spark sorts in a worker and shows what it has until then. A draw here is: colors and order for this camera,
//         then the picture; while one runs, any number of requests becomes one more. So after `drawn` the pixels are
//         those of the camera, and can be compared.
import {SparkRenderer, SplatMesh} from '@sparkjsdev/spark';
import {Color, Scene, SRGBColorSpace, WebGLRenderer} from 'three';

// What each choice gives to Spark. The blur of 0.3 square pixels is either part of the footprint (INRIA) or one that
// the opacity makes up for (the antialiased variant, Spark's default). extSplats would keep the scene in float, but
// Spark 2.2.0 then cuts the largest channel of an SH coefficient to the power of two below, which costs more: up to
// 5 dB.
export function choices(antialias) {
  const renderer = {
    preBlurAmount: antialias ? 0 : 0.3,
    blurAmount: antialias ? 0.3 : 0,
    maxStdDev: 3.33,
    minAlpha: 1 / 255,
    maxPixelRadius: 1e5,
    clipXY: 2,
    sortRadial: false,
    accumExtSplats: true,
    enableLod: false,
  };
  return {
    machine: {name: 'like the machine', mesh: {extSplats: false}, renderer},
    float: {name: 'like the machine, scene in float', mesh: {extSplats: true}, renderer},
    own: {name: 'Spark\'s own defaults', mesh: {}, renderer: {}},
  };
}

// Spark's own, where they are others.
export const defaults = {
  preBlurAmount: 0,
  blurAmount: 0.3,
  maxStdDev: Math.sqrt(8),
  minAlpha: 0.5 / 255,
  maxPixelRadius: 512,
  clipXY: 1.4,
  sortRadial: true,
  accumExtSplats: false,
  enableLod: true,
  extSplats: false,
};

export class Viewer {
  constructor(canvas, [red, green, blue], drawn) {
    this.renderer = new WebGLRenderer({canvas, antialias: false, preserveDrawingBuffer: true});
    this.renderer.setPixelRatio(1);
    this.renderer.setClearColor(new Color().setRGB(red / 255, green / 255, blue / 255, SRGBColorSpace), 1);
    this.drawn = drawn;
    this.busy = this.again = false;
  }

  // The scene anew, as a choice of settings has it.
  async open(files, form, choice) {
    this.again = false;
    await this.running;  // nothing is taken away from a draw
    this.close();
    const spark = new SparkRenderer({renderer: this.renderer, autoUpdate: false, ...choice.renderer});
    const meshes = files.map((bytes) => new SplatMesh({fileBytes: bytes.slice(), fileType: form, ...choice.mesh}));
    await Promise.all(meshes.map((mesh) => mesh.initialized));
    const scene = new Scene();
    scene.add(spark, ...meshes);
    this.shown = {spark, meshes, scene, clip: spark.clipXY};
  }

  close() {
    for (const mesh of this.shown?.meshes ?? []) mesh.dispose();
    this.shown?.spark.dispose();
    this.shown = undefined;
  }

  size(width, height) { this.renderer.setSize(width, height, false); }

  // `reach`: camera.mjs.
  draw(camera, reach) {
    this.wanted = {camera, reach};
    this.again = true;
    if (!this.busy) this.running = this.draw_all();
    return this.running;
  }

  async draw_all() {
    this.busy = true;
    try {
      while (this.again && this.shown) {
        this.again = false;
        const {spark, scene, clip} = this.shown, {camera, reach} = this.wanted;
        spark.clipXY = clip * reach;
        scene.updateMatrixWorld();
        this.renderer.getDrawingBufferSize(spark.renderSize);
        await spark.update({scene, camera});
        this.renderer.render(scene, camera);
      }
    } finally {
      this.busy = false;
    }
    if (this.shown) this.drawn();
  }

  // Rows from the top, R G B A.
  pixels() {
    const gl = this.renderer.getContext(), width = gl.drawingBufferWidth, height = gl.drawingBufferHeight;
    const upward = new Uint8Array(4 * width * height), rows = new Uint8Array(upward.length);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, upward);
    for (let y = 0; y < height; ++y)
      rows.set(upward.subarray(4 * width * (height - 1 - y), 4 * width * (height - y)), 4 * width * y);
    return rows;
  }

  // How far in front of the camera the middle one of the Gaussians lies that are in its picture.
  depth(camera) {
    if (!this.shown) return 10 * camera.near;
    const mesh = this.shown.meshes[0], splats = mesh.extSplats ?? mesh.packedSplats;
    const count = splats.getNumSplats(), step = Math.max(1, Math.floor(count / 4000)), depths = [];
    for (let i = 0; i < count; i += step) {
      const point = splats.getSplat(i).center.applyMatrix4(camera.matrixWorldInverse), z = -point.z;
      point.applyMatrix4(camera.projectionMatrix);
      if (z > camera.near && Math.abs(point.x) < 1 && Math.abs(point.y) < 1) depths.push(z);
    }
    depths.sort((a, b) => a - b);
    return depths.length > 0 ? depths[depths.length >> 1] : 10 * camera.near;
  }
}
