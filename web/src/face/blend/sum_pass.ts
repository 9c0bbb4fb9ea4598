/** The pass that adds up layers by weight, one weight for the whole face or one for each region of it. */

import { createProgram, floatTexture, uniformAt } from "../gpu/gl";
import { blendFragment, MOST_ENTRIES, MOST_REGIONAL, PASS_VERTEX, ROW_WIDTH } from "../gpu/pass_shaders";

/** One summand for the GPU: a layer of the texture array and its weight. */
export interface Entry {
  layer: number;
  weight: number;
}

/** A summand that weighs another in each region (brows, eyes, mouth, rest). */
export interface RegionalEntry {
  layer: number;
  weights: readonly number[];
}

/** The eyeballs, left then right: their rows, centres and radii (metres) and turns (3x3, column by column). */
export interface Eyeballs {
  rows: Int32Array; // first and end row of the left, then of the right
  centres: Float32Array; // 6
  radii: Float32Array; // 2
  turns: Float32Array; // 18
}

/** What one pass adds up. */
export interface Sum {
  entries: readonly Entry[];
  regional: readonly RegionalEntry[];
}

/** What is to be added up: all terms, those of them that are faces, and what the others are allowed. */
export interface CompoundSum extends Sum {
  rest: readonly Entry[];
  /** Those of them that count as rest where skin is pressed: lids that blink and follow the gaze. */
  lids: readonly Entry[];
  /** Allowances, weighted and added (omote.perform.blending.correctives); undefined: nothing can be wrong, one compound is worn. */
  allowed: Float32Array | undefined;
}

/** A uniform block of a program, and the numbers in it. */
interface Block {
  buffer: WebGLBuffer;
  values: Float32Array;
}

/**
 * Adds layers up into a target, and turns the eyeballs. Where no region differs, nothing knows of regions: the program that
 * reads masks draws only sums that need it.
 */
export class SumPass {
  private readonly whole: WebGLProgram;
  private readonly regional: WebGLProgram | undefined;
  private readonly masks: WebGLTexture | undefined;
  private readonly mix: Block;
  private readonly more: Block;
  private readonly empty: WebGLVertexArrayObject;

  /** `masks`: how much of each row belongs to each region, (rows, 4); undefined: the head has none, regions show the whole face's mix. */
  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly height: number,
    masks: Float32Array | undefined,
  ) {
    this.whole = createProgram(gl, PASS_VERTEX, blendFragment(false));
    this.mix = createBlock(gl, 2 * MOST_ENTRIES);
    this.more = createBlock(gl, 5 * MOST_REGIONAL);
    this.empty = gl.createVertexArray();
    if (masks === undefined) return;
    this.regional = createProgram(gl, PASS_VERTEX, blendFragment(true));
    this.masks = floatTexture(gl, masks, 4, ROW_WIDTH);
  }

  /** Draws a sum of layers of `store`, the eyeballs turned, into a target. Entries past the most that fit are left out. */
  draw(store: WebGLTexture, { entries, regional }: Sum, eyes: Eyeballs, target: WebGLFramebuffer): void {
    const { gl } = this;
    const own = regional.length > 0 ? this.regional : undefined;
    const program = own ?? this.whole;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.viewport(0, 0, ROW_WIDTH, this.height);
    gl.bindVertexArray(this.empty);
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, store);
    const at = (name: string) => uniformAt(gl, program, name);
    gl.uniform1i(at("layers"), 0);
    gl.uniform1i(at("pairs"), this.writeEntries(program, entries));
    gl.uniform4iv(at("eyeRows"), eyes.rows);
    gl.uniform3fv(at("eyeCentres"), eyes.centres);
    gl.uniformMatrix3fv(at("eyeTurns"), false, eyes.turns);
    if (own !== undefined) this.prepareRegional(own, regional);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  dispose(): void {
    const { gl, regional, masks } = this;
    for (const program of [this.whole, ...(regional ? [regional] : [])]) gl.deleteProgram(program);
    for (const { buffer } of [this.mix, this.more]) gl.deleteBuffer(buffer);
    if (masks !== undefined) gl.deleteTexture(masks);
    gl.deleteVertexArray(this.empty);
  }

  /** Writes the entries, two to a vec4; how many pairs there are. */
  private writeEntries(program: WebGLProgram, entries: readonly Entry[]): number {
    const { values } = this.mix;
    const count = Math.min(entries.length, MOST_ENTRIES);
    for (let index = 0; index < count; index++) {
      const { layer, weight } = entries[index] as Entry;
      values[2 * index] = layer;
      values[2 * index + 1] = weight;
    }
    if (count % 2 === 1) values.fill(0, 2 * count, 2 * count + 2);
    const pairs = Math.ceil(count / 2);
    this.bind(program, "Mix", 0, this.mix, 4 * pairs);
    return pairs;
  }

  private prepareRegional(program: WebGLProgram, entries: readonly RegionalEntry[]): void {
    const { gl } = this;
    const { values } = this.more;
    const count = Math.min(entries.length, MOST_REGIONAL);
    for (let index = 0; index < count; index++) {
      const { layer, weights } = entries[index] as RegionalEntry;
      values.set(weights, 4 * index);
      values[4 * MOST_REGIONAL + index] = layer;
    }
    this.bind(program, "Regional", 1, this.more, values.length);
    gl.uniform1i(uniformAt(gl, program, "count"), count);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.masks ?? null);
    gl.uniform1i(uniformAt(gl, program, "masks"), 1);
  }

  private bind(program: WebGLProgram, name: string, place: number, { buffer, values }: Block, count: number): void {
    const { gl } = this;
    gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
    gl.bufferSubData(gl.UNIFORM_BUFFER, 0, values, 0, count);
    gl.bindBufferBase(gl.UNIFORM_BUFFER, place, buffer);
    gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, name), place);
  }
}

function createBlock(gl: WebGL2RenderingContext, count: number): Block {
  const [buffer, values] = [gl.createBuffer(), new Float32Array(count)];
  gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
  gl.bufferData(gl.UNIFORM_BUFFER, values.byteLength, gl.DYNAMIC_DRAW);
  return { buffer, values };
}
