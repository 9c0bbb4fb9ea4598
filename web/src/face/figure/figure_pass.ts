/** Hangs bodies below heads on the GPU, and skins both: positions and normals of whole figures. */

import { SHAPES } from "../../link/constants";
import { type Body, type FigureSpace, ROW_BONES } from "../../link/figures";
import { fanSpans, fans } from "../anatomy/topology";
import { createProgram, dataTexture, floatTexture, targetTexture, uniformAt, wholeTexture } from "../gpu/gl";
import { NORMAL_FRAGMENT, PASS_VERTEX, ROW_WIDTH } from "../gpu/pass_shaders";
import { BONE_TEXELS, edgeFragment, figureFragment, MOST_BODIES } from "./figure_shaders";
import type { SharedFigures } from "./shared_figures";
import { suitFor } from "./suit";

/** Where one figure is drawn to; everything that is drawn of it reads positions and normals. */
export interface FigureTarget {
  readonly positions: WebGLTexture;
  readonly normals: WebGLTexture;
  readonly positionFrame: WebGLFramebuffer;
  readonly normalFrame: WebGLFramebuffer;
  readonly bones: WebGLTexture;
  readonly bodyEdge: WebGLTexture;
  readonly limbFields: WebGLTexture;
}

/** What one figure is: its bones (`BONE_TEXELS` a bone), bodies by layer and weight, and the mix of their edges (e, 4). */
export interface FigureJob {
  readonly bones: Float32Array;
  readonly bodies: readonly (readonly [layer: number, weight: number])[];
  readonly bodyEdge: Float32Array;
  /** How much of each corrective each joint calls (joints, SHAPES). */
  readonly calls: Float32Array;
  /** The sum of its limb fields (4 numbers a row on limbs), whether it is new, and the axes of its limbs; undefined where none weighs anything. */
  readonly limbs: LimbJob | undefined;
  /** The head as it is blended. */
  readonly head: WebGLTexture;
  readonly target: FigureTarget;
}

/** What moves the limbs of a figure (`limb_mix`). */
export interface LimbJob {
  readonly fields: Float32Array;
  readonly fresh: boolean;
  readonly axes: Float32Array;
}

const CORNER_WIDTH = 512;

/** The passes of all figures of a graphics context, and the bodies that they mix, which lie in an array of their own. */
export class FigurePass {
  readonly space: FigureSpace;
  private readonly height: number;
  private readonly rows: number;
  private readonly programs: Record<"edge" | "figure" | "normal", WebGLProgram>;
  private readonly shared: Record<"rows" | "join" | "edgeRows" | "ranges" | "corners" | "limbPlaces", WebGLTexture>;
  private readonly off: WebGLTexture;
  private readonly offFrame: WebGLFramebuffer;
  private readonly bodies: WebGLTexture;
  private readonly layers = new Map<string, number>();
  private readonly dressed: (body: Body) => Float32Array;
  private readonly empty: WebGLVertexArrayObject;
  private readonly mixed = new Float32Array(2 * MOST_BODIES);

  /** `skin`: the triangles of the head's skin, as rows. */
  constructor(
    private readonly gl: WebGL2RenderingContext,
    { space, first, bodies }: SharedFigures,
    skin: Uint32Array,
  ) {
    this.space = space;
    const { headRows, bodyRows, edge, rim, triangles, skirt, bending } = space;
    this.rows = headRows + bodyRows;
    this.dressed = suitFor(space, first);
    this.height = Math.ceil(this.rows / ROW_WIDTH);
    this.programs = {
      edge: createProgram(gl, PASS_VERTEX, edgeFragment(edge.length, rim)),
      figure: createProgram(
        gl,
        PASS_VERTEX,
        figureFragment({ head: headRows, body: bodyRows, edge: edge.length, bending: bending.length }),
      ),
      normal: createProgram(gl, PASS_VERTEX, NORMAL_FRAGMENT),
    };
    const around = fans([skin, triangles, skirt], this.rows);
    const edges = new Uint32Array(2 * edge.length);
    for (let place = 0; place < edge.length; place++) edges[2 * place] = edge[place] as number;
    this.shared = {
      rows: wholeTexture(gl, packedRows(space), 2 * ROW_WIDTH),
      join: floatTexture(gl, space.join, 1, edge.length),
      edgeRows: dataTexture(gl, edges, edge.length),
      ranges: dataTexture(gl, fanSpans(around), ROW_WIDTH),
      corners: dataTexture(gl, around.pairs, CORNER_WIDTH),
      limbPlaces: floatTexture(gl, limbPlaces(space), 2, ROW_WIDTH),
    };
    [this.off, this.offFrame] = targetTexture(gl, edge.length + 1, 1);
    this.bodies = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.bodies);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.RGBA32F, ROW_WIDTH, this.bodyLines, bodies.size);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    this.empty = gl.createVertexArray();
  }

  /** A target for one more figure. */
  createTarget(): FigureTarget {
    const { gl, height, space } = this;
    const [positions, positionFrame] = targetTexture(gl, ROW_WIDTH, height);
    const [normals, normalFrame] = targetTexture(gl, ROW_WIDTH, height);
    const bones = floatTexture(gl, new Float32Array(), 4, BONE_TEXELS * space.bones.length);
    const bodyEdge = floatTexture(gl, new Float32Array(), 4, space.edge.length);
    const limbFields = floatTexture(gl, new Float32Array(limbNumbers(space)), 4, ROW_WIDTH);
    return { positions, normals, positionFrame, normalFrame, bones, bodyEdge, limbFields };
  }

  /** Frees the target of a figure that is gone. */
  drop({ positions, normals, positionFrame, normalFrame, bones, bodyEdge, limbFields }: FigureTarget): void {
    for (const texture of [positions, normals, bones, bodyEdge, limbFields]) this.gl.deleteTexture(texture);
    for (const frame of [positionFrame, normalFrame]) this.gl.deleteFramebuffer(frame);
  }

  /** The layer of a body, which is uploaded in its suit when it is asked for first. */
  layerOf(name: string, body: Body): number {
    const layer = this.layers.get(name);
    if (layer !== undefined) return layer;
    const rows = [...this.dressed(body), ...body.correctives];
    const next = this.layers.size;
    const texels = new Float32Array(4 * ROW_WIDTH * this.bodyLines);
    for (let at = 0; at < rows.length; at++) texels[4 * Math.floor(at / 3) + (at % 3)] = rows[at] as number;
    const { gl } = this;
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.bodies);
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, next, ROW_WIDTH, this.bodyLines, 1, gl.RGBA, gl.FLOAT, texels);
    this.layers.set(name, next);
    return next;
  }

  /** Draws figures, when their heads are blended. */
  draw(jobs: readonly FigureJob[]): void {
    if (jobs.length === 0) return; // or what three has bound would no more be bound
    const { gl } = this;
    for (const state of [gl.BLEND, gl.DEPTH_TEST, gl.SCISSOR_TEST, gl.CULL_FACE]) gl.disable(state);
    gl.colorMask(true, true, true, true);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.bindVertexArray(this.empty);
    for (const job of jobs) this.drawFigure(job);
    gl.bindVertexArray(null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** The rows of a figure, (V + B, 3) metres, read back from the GPU (slow: for tests). */
  readPositions({ positionFrame }: FigureTarget): Float32Array {
    const { gl, height, rows } = this;
    const texels = new Float32Array(4 * ROW_WIDTH * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, positionFrame);
    gl.readPixels(0, 0, ROW_WIDTH, height, gl.RGBA, gl.FLOAT, texels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return Float32Array.from({ length: 3 * rows }, (_, at) => texels[4 * Math.floor(at / 3) + (at % 3)] as number);
  }

  dispose(): void {
    const { gl } = this;
    for (const program of Object.values(this.programs)) gl.deleteProgram(program);
    for (const texture of [...Object.values(this.shared), this.off, this.bodies]) gl.deleteTexture(texture);
    gl.deleteFramebuffer(this.offFrame);
    gl.deleteVertexArray(this.empty);
  }

  private get bodyLines(): number {
    const { bodyRows, bending } = this.space;
    return Math.ceil((bodyRows + SHAPES * bending.length) / ROW_WIDTH);
  }

  private drawFigure({ bones, bodies, bodyEdge, calls, limbs, head, target }: FigureJob): void {
    const { gl, space, programs, shared, off, height } = this;
    const edges = space.edge.length;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, target.bones);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, BONE_TEXELS * space.bones.length, 1, gl.RGBA, gl.FLOAT, bones);
    gl.bindTexture(gl.TEXTURE_2D, target.bodyEdge);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, edges, 1, gl.RGBA, gl.FLOAT, bodyEdge);
    if (limbs?.fresh) {
      const lines = limbs.fields.length / (4 * ROW_WIDTH);
      gl.bindTexture(gl.TEXTURE_2D, target.limbFields);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, ROW_WIDTH, lines, gl.RGBA, gl.FLOAT, limbs.fields);
    }
    const { edgeRows, rows, join, ranges, corners, limbPlaces } = shared;
    this.pass(programs.edge, this.offFrame, [edges + 1, 1], { head, edgeRows, bodyEdge: target.bodyEdge });
    gl.useProgram(programs.figure);
    bodies.slice(0, MOST_BODIES).forEach((pair, place) => {
      this.mixed.set(pair, 2 * place);
    });
    gl.uniform2fv(uniformAt(gl, programs.figure, "mixed"), this.mixed);
    gl.uniform1i(uniformAt(gl, programs.figure, "count"), Math.min(bodies.length, MOST_BODIES));
    gl.uniform4fv(uniformAt(gl, programs.figure, "calls"), calls);
    gl.uniform1i(uniformAt(gl, programs.figure, "limbsMove"), limbs === undefined ? 0 : 1);
    if (limbs !== undefined) gl.uniform3fv(uniformAt(gl, programs.figure, "limbAxes"), limbs.axes);
    gl.activeTexture(gl.TEXTURE7);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.bodies);
    gl.uniform1i(uniformAt(gl, programs.figure, "bodies"), 7);
    const whole = [ROW_WIDTH, height] as const;
    const { bones: turned, limbFields } = target;
    const read = { head, rows, join, off, bones: turned, limbPlaces, limbFields };
    this.pass(programs.figure, target.positionFrame, whole, read);
    this.pass(programs.normal, target.normalFrame, whole, { positions: target.positions, ranges, corners });
  }

  private pass(
    program: WebGLProgram,
    frame: WebGLFramebuffer,
    [width, height]: readonly [number, number],
    textures: Readonly<Record<string, WebGLTexture>>,
  ): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.viewport(0, 0, width, height);
    gl.useProgram(program);
    Object.entries(textures).forEach(([name, texture], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(uniformAt(gl, program, name), unit);
    });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}

/** Eight numbers a row: its bones (bytes), its weights (pairs), its share with its place among those that
 * bend, from 1, and their joint (from bits 0, 8, 24), and its places among the joined and on limbs, from 1 (bits 0, 16). */
function packedRows({
  rowBones,
  rowWeights,
  shares,
  joined,
  headRows,
  bending,
  bendingHinges,
  limbRows,
}: FigureSpace): Uint32Array {
  const rows = shares.length;
  const packed = new Uint32Array(8 * rows);
  for (let row = 0; row < rows; row++) {
    for (let place = 0; place < ROW_BONES; place++) {
      const from = ROW_BONES * row + place;
      packed[8 * row + (place >> 2)] =
        ((packed[8 * row + (place >> 2)] as number) | ((rowBones[from] as number) << (8 * (place & 3)))) >>> 0;
      const pair = 8 * row + 2 + (place >> 1);
      packed[pair] = ((packed[pair] as number) | ((rowWeights[from] as number) << (16 * (place & 1)))) >>> 0;
    }
    packed[8 * row + 6] = shares[row] as number;
  }
  bending.forEach((row, place) => {
    const hinge = bendingHinges[place] as number;
    packed[8 * row + 6] = ((packed[8 * row + 6] as number) | ((place + 1) << 8) | (hinge << 24)) >>> 0;
  });
  joined.forEach((row, place) => {
    packed[8 * (headRows + row) + 7] = place + 1;
  });
  limbRows.forEach((row, place) => {
    packed[8 * row + 7] = ((packed[8 * row + 7] as number) | ((place + 1) << 16)) >>> 0;
  });
  return packed;
}

/** Numbers in the sum of limb fields: whole lines of its texture. */
export const limbNumbers = ({ limbRows }: FigureSpace): number =>
  4 * ROW_WIDTH * Math.max(1, Math.ceil(limbRows.length / ROW_WIDTH));

/** Of the rows on limbs: how far along, and which limb. */
function limbPlaces({ limbs, limbWays }: FigureSpace): Float32Array {
  return Float32Array.from(
    { length: 2 * limbs.length },
    (_, at) => (at % 2 === 0 ? limbWays : limbs)[at >> 1] as number,
  );
}
