/** Blends faces and expressions on the GPU: weighted sum, correctives, normals. */

import type { CorrectivesData } from "../anatomy/correctives_data";
import { type Fans, fanSpans } from "../anatomy/topology";
import { createProgram, dataTexture, targetTexture } from "../gpu/gl";
import { BLEND_FRAGMENT, NORMAL_FRAGMENT, PASS_VERTEX, ROW_WIDTH } from "../gpu/pass_shaders";
import { CorrectivePasses } from "./corrective_passes";
import { LayerTable } from "./layer_table";

/** One summand for the GPU: a layer of the texture array and its weight. */
export interface Entry {
  layer: number;
  weight: number;
}

/** The eyeballs, left then right: their rows, centres and radii (metres) and turns (3x3, column by column). */
export interface Eyeballs {
  rows: Int32Array; // first and end row of the left, then of the right
  centres: Float32Array; // 6
  radii: Float32Array; // 2
  turns: Float32Array; // 18
}

/** What is to be added up: all terms, those of them that are faces, and what the others are allowed. */
export interface Mix {
  entries: readonly Entry[];
  rest: readonly Entry[];
  /** Allowances, weighted and added (omote.perform.blending.correctives); undefined: nothing can be wrong, one compound is worn. */
  allowed: Float32Array | undefined;
}

/** The entries one pass takes; the uniform block of 8 KB holds two in each vec4. */
export const MOST_ENTRIES = 1024;
const FIRST_CAPACITY = 128;
const CORNER_WIDTH = 512;

/** Blends layers into the position texture and derives the normals: everything that is drawn reads these two. */
export class Blender {
  readonly layers: LayerTable;
  readonly positions: WebGLTexture;
  readonly normals: WebGLTexture;
  private readonly height: number;
  private readonly blendPass: WebGLProgram;
  private readonly normalPass: WebGLProgram;
  private readonly positionTarget: WebGLFramebuffer;
  private readonly normalTarget: WebGLFramebuffer;
  private readonly entryBuffer: WebGLBuffer;
  private readonly empty: WebGLVertexArrayObject;
  private readonly ranges: WebGLTexture;
  private readonly corners: WebGLTexture;
  private readonly entryData = new Float32Array(2 * MOST_ENTRIES);
  private readonly correctivePasses: CorrectivePasses | undefined;
  private rested = "";
  private store: WebGLTexture;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly rows: number,
    fan: Fans,
    correctives?: CorrectivesData,
  ) {
    if (gl.getExtension("EXT_color_buffer_float") === null)
      throw new Error("This graphics driver cannot draw into float textures (EXT_color_buffer_float); update it.");
    this.height = Math.ceil(rows / ROW_WIDTH);
    this.layers = new LayerTable(
      FIRST_CAPACITY,
      Math.min(1024, gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS) as number),
    );
    this.blendPass = createProgram(gl, PASS_VERTEX, BLEND_FRAGMENT);
    this.normalPass = createProgram(gl, PASS_VERTEX, NORMAL_FRAGMENT);
    [this.positions, this.positionTarget] = targetTexture(gl, ROW_WIDTH, this.height);
    [this.normals, this.normalTarget] = targetTexture(gl, ROW_WIDTH, this.height);
    this.store = this.createStore(FIRST_CAPACITY);
    this.empty = gl.createVertexArray();
    this.entryBuffer = gl.createBuffer();
    gl.bindBuffer(gl.UNIFORM_BUFFER, this.entryBuffer);
    gl.bufferData(gl.UNIFORM_BUFFER, this.entryData.byteLength, gl.DYNAMIC_DRAW);
    this.ranges = dataTexture(gl, fanSpans(fan), ROW_WIDTH);
    this.corners = dataTexture(gl, fan.pairs, CORNER_WIDTH);
    this.correctivePasses = correctives === undefined ? undefined : new CorrectivePasses(gl, correctives, this.height);
  }

  /** Puts `rows` times (x, y, z, unused) into a layer, growing the array where it must. */
  upload(layer: number, values: Float32Array): void {
    const { gl } = this;
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.store);
    if (layer >= this.storeDepth) this.growStore();
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, layer, ROW_WIDTH, this.height, 1, gl.RGBA, gl.FLOAT, values);
  }

  /** A buffer of the size `upload` wants. */
  blankLayer(): Float32Array {
    return new Float32Array(4 * ROW_WIDTH * this.height);
  }

  /** One frame: blended positions with turned eyeballs, put right, then normals. Entries past MOST_ENTRIES are left out. */
  blend(mix: Mix, eyes: Eyeballs): void {
    const { gl } = this;
    gl.disable(gl.BLEND);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.SCISSOR_TEST);
    gl.disable(gl.CULL_FACE);
    gl.colorMask(true, true, true, true);
    gl.bindVertexArray(this.empty);
    if (this.correctivePasses === undefined || mix.allowed === undefined)
      this.add(mix.entries, eyes, this.positionTarget);
    else this.correct(this.correctivePasses, mix, mix.allowed, eyes);
    this.deriveNormals();
    gl.bindVertexArray(null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** The blended positions, (rows, 3) metres, read back from the GPU (slow: for tests). */
  readPositions(): Float32Array {
    const { gl } = this;
    const texels = this.blankLayer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.positionTarget);
    gl.readPixels(0, 0, ROW_WIDTH, this.height, gl.RGBA, gl.FLOAT, texels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const positions = new Float32Array(3 * this.rows);
    for (let row = 0; row < this.rows; row++) positions.set(texels.subarray(4 * row, 4 * row + 3), 3 * row);
    return positions;
  }

  dispose(): void {
    const { gl } = this;
    for (const texture of [this.positions, this.normals, this.store, this.ranges, this.corners])
      gl.deleteTexture(texture);
    for (const target of [this.positionTarget, this.normalTarget]) gl.deleteFramebuffer(target);
    for (const program of [this.blendPass, this.normalPass]) gl.deleteProgram(program);
    this.correctivePasses?.dispose();
    gl.deleteBuffer(this.entryBuffer);
    gl.deleteVertexArray(this.empty);
  }

  private writeEntries(entries: readonly Entry[]): number {
    const count = Math.min(entries.length, MOST_ENTRIES);
    for (let index = 0; index < count; index++) {
      const { layer, weight } = entries[index] as Entry;
      this.entryData[2 * index] = layer;
      this.entryData[2 * index + 1] = weight;
    }
    if (count % 2 === 1) this.entryData.fill(0, 2 * count, 2 * count + 2);
    return count;
  }

  private correct(
    correctivePasses: CorrectivePasses,
    { entries, rest }: Mix,
    allowed: Float32Array,
    eyes: Eyeballs,
  ): void {
    const faces = JSON.stringify(rest);
    if (faces !== this.rested) {
      this.rested = faces;
      this.add(rest, eyes, correctivePasses.still);
      correctivePasses.rested();
    }
    this.add(entries, eyes, correctivePasses.mixed);
    const sights = [6, 7, 8, 15, 16, 17].map((at) => eyes.turns[at] as number);
    correctivePasses.correct(this.positionTarget, allowed, { ...eyes, sights: Float32Array.from(sights) });
  }

  /** Draws the sum of some entries, the eyeballs turned, into a target. */
  private add(entries: readonly Entry[], eyes: Eyeballs, target: WebGLFramebuffer): void {
    const { gl, blendPass } = this;
    const count = this.writeEntries(entries);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.viewport(0, 0, ROW_WIDTH, this.height);
    gl.bindVertexArray(this.empty);
    gl.useProgram(blendPass);
    gl.bindBuffer(gl.UNIFORM_BUFFER, this.entryBuffer);
    gl.bufferSubData(gl.UNIFORM_BUFFER, 0, this.entryData, 0, 4 * Math.ceil(count / 2));
    gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, this.entryBuffer);
    gl.uniformBlockBinding(blendPass, gl.getUniformBlockIndex(blendPass, "Mix"), 0);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.store);
    const at = (name: string) => gl.getUniformLocation(blendPass, name);
    gl.uniform1i(at("layers"), 0);
    gl.uniform1i(at("pairs"), Math.ceil(count / 2));
    gl.uniform4iv(at("eyeRows"), eyes.rows);
    gl.uniform3fv(at("eyeCentres"), eyes.centres);
    gl.uniformMatrix3fv(at("eyeTurns"), false, eyes.turns);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  private deriveNormals(): void {
    const { gl, normalPass } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.normalTarget);
    gl.viewport(0, 0, ROW_WIDTH, this.height);
    gl.bindVertexArray(this.empty);
    gl.useProgram(normalPass);
    [this.positions, this.ranges, this.corners].forEach((texture, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    });
    ["positions", "ranges", "corners"].forEach((name, unit) => {
      gl.uniform1i(gl.getUniformLocation(normalPass, name), unit);
    });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  private storeDepth = FIRST_CAPACITY;

  private createStore(depth: number): WebGLTexture {
    const { gl } = this;
    const store = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, store);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.RGBA32F, ROW_WIDTH, this.height, depth);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    this.storeDepth = depth;
    return store;
  }

  /** Twice the layers; what the old ones hold is copied on the GPU, so nothing on air is missed. */
  private growStore(): void {
    const { gl, store: old, storeDepth: depth } = this;
    this.store = this.createStore(Math.min(2 * depth, this.layers.limit));
    const reader = gl.createFramebuffer();
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, reader);
    for (let layer = 0; layer < depth; layer++) {
      gl.framebufferTextureLayer(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, old, 0, layer);
      gl.copyTexSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, layer, 0, 0, ROW_WIDTH, this.height);
    }
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    gl.deleteFramebuffer(reader);
    gl.deleteTexture(old);
  }
}
