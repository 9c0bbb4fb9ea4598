/** Blends faces and expressions on the GPU: weighted sum, correctives, normals. */

import type { CorrectivesData } from "../anatomy/correctives_data";
import { type Fans, fanSpans } from "../anatomy/topology";
import { createProgram, dataTexture, targetTexture, uniformAt } from "../gpu/gl";
import { NORMAL_FRAGMENT, PASS_VERTEX, ROW_WIDTH } from "../gpu/pass_shaders";
import { type Correction, CorrectivePasses } from "./corrective_passes";
import { SLOTS } from "./corrective_shaders";
import { LayerTable } from "./layer_table";
import { ProcessorBlend, socketsOf } from "./processor_blend";
import { StrainPass } from "./strain_pass";
import { type CompoundSum, type Eyeballs, SumPass } from "./sum_pass";

/** Where one character is blended to: everything that is drawn of it reads these two textures. */
export interface BlendTarget {
  readonly positions: WebGLTexture;
  readonly normals: WebGLTexture;
  readonly positionFrame: WebGLFramebuffer;
  readonly normalFrame: WebGLFramebuffer;
  /** How far its skin is pressed, where `pressed`. */
  readonly strains: WebGLTexture;
  readonly strainFrame: WebGLFramebuffer;
  readonly rests: WebGLTexture;
  readonly restFrame: WebGLFramebuffer;
  /** Whether anything but its faces is worn, and strains say how that presses the skin. */
  pressed: boolean;
  /** The mix that lies in `rests`. */
  rested: string;
}

/** What will be blended with the frame's others. */
interface Job {
  mix: CompoundSum;
  eyes: Eyeballs;
  target: BlendTarget;
}

const FIRST_CAPACITY = 128;
const CORNER_WIDTH = 512;

/** Blends layers into characters' position textures and derives the normals; the layers are shared by all of them. */
export class Blender {
  readonly layers: LayerTable;
  private readonly height: number;
  private readonly sumPass: SumPass;
  private readonly normalPass: WebGLProgram;
  private readonly empty: WebGLVertexArrayObject;
  private readonly ranges: WebGLTexture;
  private readonly corners: WebGLTexture;
  private readonly correctivePasses: CorrectivePasses | undefined;
  /** By slot of the corrective passes: the mix of faces that lies there without expression. */
  private readonly rested: string[] = [];
  private readonly processor: ProcessorBlend | undefined;
  private readonly targets = new Set<BlendTarget>();
  private readonly strainPass: StrainPass | undefined;
  private jobs: Job[] = [];
  /** Whether all is blended on the processor, where it can be (`software`); either way draws the same. */
  onProcessor = false;
  private store: WebGLTexture;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly rows: number,
    fan: Fans,
    correctives?: CorrectivesData,
    regions?: Float32Array,
    folding?: Fans,
    software = false,
  ) {
    if (gl.getExtension("EXT_color_buffer_float") === null)
      throw new Error("This graphics driver cannot draw into float textures (EXT_color_buffer_float); update it.");
    this.height = Math.ceil(rows / ROW_WIDTH);
    this.layers = new LayerTable(
      FIRST_CAPACITY,
      Math.min(1024, gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS) as number),
    );
    this.sumPass = new SumPass(gl, this.height, regions);
    this.strainPass = folding === undefined ? undefined : new StrainPass(gl, this.height, folding);
    this.normalPass = createProgram(gl, PASS_VERTEX, NORMAL_FRAGMENT);
    this.store = this.createStore(FIRST_CAPACITY);
    this.empty = gl.createVertexArray();
    this.ranges = dataTexture(gl, fanSpans(fan), ROW_WIDTH);
    this.corners = dataTexture(gl, fan.pairs, CORNER_WIDTH);
    this.correctivePasses = correctives === undefined ? undefined : new CorrectivePasses(gl, correctives, this.height);
    this.processor = software ? new ProcessorBlend(rows, fan, correctives, regions) : undefined;
  }

  /** A target for one more character. */
  createTarget(): BlendTarget {
    const [positions, positionFrame] = targetTexture(this.gl, ROW_WIDTH, this.height);
    const [normals, normalFrame] = targetTexture(this.gl, ROW_WIDTH, this.height);
    const [strains, strainFrame] = targetTexture(this.gl, ROW_WIDTH, this.height);
    const [rests, restFrame] = targetTexture(this.gl, ROW_WIDTH, this.height);
    const strained = { strains, strainFrame, rests, restFrame, pressed: false, rested: "" };
    const target = { positions, normals, positionFrame, normalFrame, ...strained };
    this.targets.add(target);
    return target;
  }

  /** Frees the target of a character that is gone. */
  drop(target: BlendTarget): void {
    const { positions, normals, strains, rests, positionFrame, normalFrame, strainFrame, restFrame } = target;
    this.targets.delete(target);
    for (const texture of [positions, normals, strains, rests]) this.gl.deleteTexture(texture);
    for (const frame of [positionFrame, normalFrame, strainFrame, restFrame]) this.gl.deleteFramebuffer(frame);
  }

  /** Puts `rows` times (x, y, z, unused) into a layer, growing the array where it must. */
  upload(layer: number, values: Float32Array): void {
    const { gl } = this;
    this.rested.length = 0; // a layer holds something else now
    for (const target of this.targets) target.rested = "";
    this.processor?.keep(layer, values);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.store);
    if (layer >= this.storeDepth) this.growStore();
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, layer, ROW_WIDTH, this.height, 1, gl.RGBA, gl.FLOAT, values);
  }

  /** A buffer of the size `upload` wants. */
  blankLayer(): Float32Array {
    return new Float32Array(4 * ROW_WIDTH * this.height);
  }

  /** Takes on one character's frame: blended positions with turned eyeballs, put right, then normals; `finish` draws it. */
  blend(mix: CompoundSum, eyes: Eyeballs, target: BlendTarget): void {
    this.jobs.push({ mix, eyes, target });
  }

  /** Draws all that was taken on since the last time, the correctives of several characters at once. */
  finish(): void {
    const { jobs } = this;
    this.jobs = [];
    if (this.onProcessor && this.processor !== undefined) this.blendOn(this.processor, jobs);
    else this.draw(jobs);
  }

  /** Draws sums, correctives and normals with the graphics context. */
  private draw(jobs: readonly Job[]): void {
    const { gl } = this;
    for (const state of [gl.BLEND, gl.DEPTH_TEST, gl.SCISSOR_TEST, gl.CULL_FACE]) gl.disable(state);
    gl.colorMask(true, true, true, true);
    const passes = this.correctivePasses;
    const corrected = passes === undefined ? [] : jobs.filter(({ mix }) => mix.allowed !== undefined);
    const plain = jobs.filter((job) => !corrected.includes(job));
    for (const { mix, eyes, target } of plain) this.sumPass.draw(this.store, mix, eyes, target.positionFrame);
    if (passes !== undefined)
      for (let first = 0; first < corrected.length; first += SLOTS)
        this.correct(passes, corrected.slice(first, first + SLOTS));
    for (const { target } of jobs) this.deriveNormals(target);
    for (const job of jobs) this.deriveStrain(job);
    gl.bindVertexArray(null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** A character's blended positions, (rows, 3) metres, read back from the GPU (slow: for tests). */
  readPositions({ positionFrame }: BlendTarget): Float32Array {
    return this.read(positionFrame);
  }

  /** How far its skin is pressed, (rows, 3): level, mixed, upright; read back from the GPU (slow: for tests). */
  readStrains({ strainFrame }: BlendTarget): Float32Array {
    return this.read(strainFrame);
  }

  private read(frame: WebGLFramebuffer): Float32Array {
    const { gl } = this;
    const texels = this.blankLayer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.readPixels(0, 0, ROW_WIDTH, this.height, gl.RGBA, gl.FLOAT, texels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const positions = new Float32Array(3 * this.rows);
    for (let row = 0; row < this.rows; row++) positions.set(texels.subarray(4 * row, 4 * row + 3), 3 * row);
    return positions;
  }

  dispose(): void {
    const { gl } = this;
    for (const texture of [this.store, this.ranges, this.corners]) gl.deleteTexture(texture);
    gl.deleteProgram(this.normalPass);
    for (const passes of [this.sumPass, this.correctivePasses, this.strainPass]) passes?.dispose();
    gl.deleteVertexArray(this.empty);
  }

  /** Sums and correctives of as many characters as there are slots. */
  private correct(passes: CorrectivePasses, jobs: readonly Job[]): void {
    const { sumPass, store, rested } = this;
    const corrections = jobs.map(({ mix, eyes, target }, slot): Correction => {
      const faces = JSON.stringify(mix.rest);
      if (faces !== rested[slot]) {
        rested[slot] = faces;
        sumPass.draw(store, { entries: mix.rest, regional: [] }, eyes, passes.mixedIn(slot));
        passes.rested(slot);
      }
      sumPass.draw(store, mix, eyes, passes.mixedIn(slot));
      return { allowed: mix.allowed ?? new Float32Array(), sockets: socketsOf(eyes), into: target.positionFrame };
    });
    passes.correct(corrections);
  }

  /** Hands over what the processor blends, one character after the other. */
  private blendOn(processor: ProcessorBlend, jobs: readonly Job[]): void {
    const { gl, height } = this;
    for (const { target } of jobs) target.pressed = false;
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.activeTexture(gl.TEXTURE0);
    for (const { mix, eyes, target } of jobs) {
      processor.blend(mix, eyes, target);
      for (const kind of ["positions", "normals"] as const) {
        gl.bindTexture(gl.TEXTURE_2D, target[kind]);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, ROW_WIDTH, height, gl.RGBA, gl.FLOAT, processor[kind]);
      }
    }
  }

  /** How the skin is pressed by what is worn over its faces; blinks and looks count as rest. */
  private deriveStrain({ mix, eyes, target }: Job): void {
    const { strainPass, sumPass, store } = this;
    const rest = [...mix.rest, ...mix.lids];
    target.pressed = strainPass !== undefined && mix.entries.length + mix.regional.length > rest.length;
    if (strainPass === undefined || !target.pressed) return;
    const rested = JSON.stringify(rest);
    if (rested !== target.rested) sumPass.draw(store, { entries: rest, regional: [] }, eyes, target.restFrame);
    target.rested = rested;
    strainPass.draw(target.positions, target.rests, target.strainFrame);
  }

  private deriveNormals({ positions, normalFrame }: BlendTarget): void {
    const { gl, normalPass } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, normalFrame);
    gl.viewport(0, 0, ROW_WIDTH, this.height);
    gl.bindVertexArray(this.empty);
    gl.useProgram(normalPass);
    [positions, this.ranges, this.corners].forEach((texture, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    });
    ["positions", "ranges", "corners"].forEach((name, unit) => {
      gl.uniform1i(uniformAt(gl, normalPass, name), unit);
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
