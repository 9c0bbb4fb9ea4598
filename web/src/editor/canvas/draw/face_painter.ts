/** Draws faces of the crowd into boxes of the canvas. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import { dome } from "../../../face/anatomy/eye_mesh";
import { edgesBefore } from "../../../face/anatomy/openings";
import { createProgram, vertexArray } from "../../../face/gpu/gl";
import { decodeSrgb } from "../../../face/light/tone";
import type { Mesh } from "../../../link/assets";
import type { Look } from "../../../link/messages";
import type { Camera } from "../math/camera";
import { FINENESS } from "../math/coarse_mesh";
import type { Surface } from "../math/triangle_cut";
import type { Ball } from "../model/gaze";
import type { FaceAtlas } from "./face_atlas";
import * as shaders from "./face_shaders";

/** What of one face is drawn. */
export interface DrawnFace {
  block: number;
  skinTexture: WebGLTexture;
  look: Look;
  balls: readonly Ball[];
  pupil: number;
}

/** Left, bottom, width and height in pixels. */
export type PixelBox = readonly [number, number, number, number];

/** A vertex array and how many indices or vertices of it are drawn. */
interface Shape {
  array: WebGLVertexArrayObject;
  count: number;
}

/** A list of triangles on the GPU. */
export interface Indices {
  buffer: WebGLBuffer;
  count: number;
}

/** A head that can be drawn in part. */
interface Head extends Surface {
  array: WebGLVertexArrayObject;
  all: Indices;
}

/** A list of lines over the work's skin: rows, two for each line, each with its colour. */
export type Lines = Shape;

/** Colours of what is no skin, linear, by mesh. */
const TINTS: Readonly<Record<string, readonly [number, number, number, number]>> = {
  teeth_upper: [0.74, 0.68, 0.56, 1],
  teeth_lower: [0.66, 0.6, 0.49, 1],
  tongue: [0.5, 0.16, 0.15, 1],
};
const WHITE = [0.78, 0.73, 0.68];
const ANIMAL_WHITE = [0.4, 0.31, 0.22];

export class FacePainter {
  private readonly skin: WebGLProgram;
  private readonly eye: WebGLProgram;
  private readonly line: WebGLProgram;
  /** Finer and coarser: what is shown large, and what is shown small. */
  private readonly heads: readonly Head[];
  private readonly balls: readonly Shape[];
  private readonly uniforms = new Map<WebGLProgram, Map<string, WebGLUniformLocation | null>>();

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly faceAtlas: FaceAtlas,
    meshes: readonly Mesh[],
    coarse: readonly (readonly Mesh[])[],
    private readonly anatomy: Pick<Anatomy, "lines" | "positions">,
  ) {
    this.skin = createProgram(gl, shaders.SKIN_VERTEX, shaders.SKIN_FRAGMENT);
    this.eye = createProgram(gl, shaders.EYE_VERTEX, shaders.EYE_FRAGMENT);
    this.line = createProgram(gl, shaders.LINE_VERTEX, shaders.LINE_FRAGMENT);
    this.heads = [meshes, ...coarse].map((list) => this.buildHead(list));
    this.balls = [this.buildBall(10, 18), this.buildBall(8, 14), this.buildBall(6, 12)];
  }

  /** Empties the whole canvas. */
  clear(ground: readonly [number, number, number]): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.disable(gl.SCISSOR_TEST);
    gl.clearColor(...ground, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  /**
   * Draws from now on into `box` of a framebuffer (null: the canvas), pixels from its lower left corner; only what lies in
   * `part` changes.
   */
  frame(box: PixelBox, part = box, framebuffer: WebGLFramebuffer | null = null): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.viewport(...box);
    gl.scissor(...part);
    gl.enable(gl.SCISSOR_TEST);
  }

  /** Empties what `frame` has said. */
  wipe(ground: readonly [number, number, number]): void {
    const { gl } = this;
    gl.clearColor(...ground, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  /** Draws a face's depth alone: what comes after stays away from where its skin stands before it. */
  mask(portrait: DrawnFace, camera: Camera): void {
    this.gl.colorMask(false, false, false, false);
    this.face(portrait, camera);
    this.gl.colorMask(true, true, true, true);
  }

  /** What a face is drawn as with this camera: fine where it is large, coarse where it is small. */
  surface(camera: Camera): Head {
    return this.heads[this.level(camera)] as Head;
  }

  /** Puts triangles of a surface into a list, in place of what `into` held. */
  list(triangles: Uint16Array, into?: Indices): Indices {
    const { gl } = this;
    const buffer = into?.buffer ?? gl.createBuffer();
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.DYNAMIC_DRAW);
    return { buffer, count: triangles.length };
  }

  /** Draws a face, or these triangles of it. */
  face(portrait: DrawnFace, camera: Camera, only?: Indices): void {
    const { gl } = this;
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    gl.disable(gl.BLEND);
    this.use(this.skin, camera);
    this.atlas(this.skin, portrait.block);
    gl.activeTexture(gl.TEXTURE2);
    gl.bindTexture(gl.TEXTURE_2D, portrait.skinTexture);
    gl.uniform1i(this.at(this.skin, "skinTexture"), 2);
    const head = this.surface(camera);
    gl.bindVertexArray(head.array);
    const { buffer, count } = only ?? head.all;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_SHORT, 0);
    this.use(this.eye, camera);
    this.dressEyes(portrait);
    for (const ball of portrait.balls) {
      gl.uniform3fv(this.at(this.eye, "centre"), ball.centre);
      gl.uniformMatrix3fv(this.at(this.eye, "axes"), false, ball.axes);
      this.draw(this.balls[this.level(camera)] as Shape);
    }
    gl.bindVertexArray(null);
  }

  private level(camera: Camera): number {
    const each = camera.metresPerPixel(camera.middle);
    return FINENESS.filter(({ from }) => each > from).length;
  }

  private draw({ array, count }: Shape): void {
    this.gl.bindVertexArray(array);
    this.gl.drawElements(this.gl.TRIANGLES, count, this.gl.UNSIGNED_SHORT, 0);
  }

  /** Draws lines over a face, `lift` metres off its skin. */
  lines({ array, count }: Lines, block: number, camera: Camera, lift: number): void {
    const { gl } = this;
    if (count === 0) return;
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    this.use(this.line, camera);
    this.atlas(this.line, block);
    gl.uniform1f(this.at(this.line, "lift"), lift);
    gl.bindVertexArray(array);
    gl.depthMask(false);
    gl.drawArrays(gl.LINES, 0, count);
    gl.depthMask(true);
    gl.bindVertexArray(null);
  }

  /** Lines between rows, two each, in one colour each (0..1, four numbers a line). */
  buildLines(rows: ArrayLike<number>, colours: ArrayLike<number>): Lines {
    const spread = Float32Array.from(
      { length: 4 * rows.length },
      (_, at) => colours[4 * (at >> 3) + (at & 3)] as number,
    );
    const array = this.array(this.line, { row: Uint16Array.from(rows), colour: spread });
    return { array, count: rows.length };
  }

  /** The uniforms of the camera, for a program of this canvas. */
  use(program: WebGLProgram, camera: Camera): void {
    const { gl } = this;
    gl.useProgram(program);
    gl.uniformMatrix4fv(this.at(program, "matrix"), false, camera.matrix);
    for (const axis of ["right", "up", "back"] as const) gl.uniform3fv(this.at(program, axis), camera[axis]);
  }

  /** The atlas of the crowd, at a face's block. */
  atlas(program: WebGLProgram, block: number): void {
    const { gl, faceAtlas } = this;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, faceAtlas.positions);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, faceAtlas.normals);
    gl.uniform1i(this.at(program, "positions"), 0);
    gl.uniform1i(this.at(program, "normals"), 1);
    gl.uniform1i(this.at(program, "top"), block * faceAtlas.lines);
  }

  at(program: WebGLProgram, name: string): WebGLUniformLocation | null {
    const known = this.uniforms.get(program) ?? new Map<string, WebGLUniformLocation | null>();
    this.uniforms.set(program, known);
    const location = known.has(name) ? known.get(name) : this.gl.getUniformLocation(program, name);
    known.set(name, location ?? null);
    return location ?? null;
  }

  /** A vertex array of a program's attributes by name; `row` is whole numbers, all else floats. */
  array(
    program: WebGLProgram,
    attributes: Readonly<Record<string, Float32Array | Uint16Array>>,
    indices?: Uint16Array,
  ): WebGLVertexArrayObject {
    const count = attributes.row?.length ?? (attributes.direction?.length ?? 3) / 3;
    const sized = Object.entries(attributes).map(
      ([name, values]) => [name, values, values instanceof Uint16Array ? 1 : values.length / count] as const,
    );
    return vertexArray(this.gl, program, sized, indices);
  }

  private dressEyes({ look, pupil }: DrawnFace): void {
    const { gl, eye } = this;
    const white = WHITE.map((part, axis) => part + ((ANIMAL_WHITE[axis] as number) - part) * look.fur);
    gl.uniform3fv(this.at(eye, "iris"), [...decodeSrgb(look.iris)]);
    gl.uniform3fv(this.at(eye, "white"), white);
    gl.uniform1f(this.at(eye, "irisSize"), look.iris_size);
    gl.uniform1f(this.at(eye, "slit"), look.slit);
    gl.uniform1f(this.at(eye, "pupil"), pupil);
  }

  private buildHead(meshes: readonly Mesh[]): Head {
    const drawn = meshes.filter(({ name }) => name === "skin" || name in TINTS);
    const total = drawn.reduce((sum, mesh) => sum + mesh.source.length, 0);
    const [row, uv, tint] = [new Uint16Array(total), new Float32Array(2 * total), new Float32Array(4 * total)];
    const [upperRow, lowerRow] = [new Uint16Array(total), new Uint16Array(total)];
    const lips = edgesBefore(this.anatomy.lines.get("lips"), this.anatomy.positions);
    const indices: number[] = [];
    let first = 0;
    for (const mesh of drawn) {
      row.set(mesh.source, first);
      uv.set(mesh.uv, 2 * first);
      mesh.source.forEach((source, n) => {
        tint.set(TINTS[mesh.name] ?? [0, 0, 0, 0], 4 * (first + n));
        if (mesh.name !== "skin") [upperRow[first + n], lowerRow[first + n]] = lips(source);
      });
      for (const corner of mesh.triangles) indices.push(first + corner);
      first += mesh.source.length;
    }
    const triangles = Uint16Array.from(indices);
    const all = this.list(triangles);
    const array = this.array(this.skin, { row, upperRow, lowerRow, uv, tint });
    return { array, rows: row, triangles, all };
  }

  private buildBall(rings: number, spokes: number): Shape {
    const { directions, triangles } = dome(rings, spokes);
    const array = this.array(this.eye, { direction: directions }, Uint16Array.from(triangles));
    return { array, count: triangles.length };
  }
}
