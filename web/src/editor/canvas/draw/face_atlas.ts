/** All faces of the canvas on the GPU: one atlas of positions and normals, of which only what changes is drawn anew. */

import { type Fans, fanSpans } from "../../../face/anatomy/topology";
import { createProgram, dataTexture, floatTexture, targetTexture } from "../../../face/gpu/gl";
import { ROW_WIDTH } from "../../../face/gpu/pass_shaders";
import type { Followers } from "../../session/control_net";
import type { Figure } from "../model/figure";
import { bandsOf } from "./atlas_bands";
import { BAND_VERTEX, MOST_BLOCKS, MOVE_FRAGMENT, PLACE_FRAGMENT, TURN_FRAGMENT } from "./atlas_shaders";

const CORNER_WIDTH = 512;

/** What one frame of the passes is given. */
export interface Step {
  /** Rows that move, and those whose normals turn for it. */
  moved: Uint32Array;
  turned: Uint32Array;
  /** For each block which of the fields it takes (-1: none), and what easing holds back. */
  slots: Int32Array;
  lags: Float32Array;
}

type Sampled = readonly [name: string, target: "flat" | "layers", texture: WebGLTexture];

/** The atlas: `lines` lines of ROW_WIDTH texels for each block (a face). */
export class FaceAtlas {
  readonly lines: number;
  readonly positions: WebGLTexture;
  readonly normals: WebGLTexture;
  private readonly moves: WebGLTexture;
  private readonly bases: WebGLTexture;
  private readonly offsets: WebGLTexture;
  private readonly fields: WebGLTexture;
  private readonly tangents: WebGLTexture;
  private readonly ranges: WebGLTexture;
  private readonly corners: WebGLTexture;
  private spans: WebGLTexture;
  private anchors: WebGLTexture;
  private readonly targets: Record<"moves" | "positions" | "normals", WebGLFramebuffer>;
  private readonly programs: Record<"move" | "place" | "turn", WebGLProgram>;
  private readonly list: WebGLVertexArrayObject;
  private readonly listed: WebGLBuffer;
  private readonly scratch: Float32Array;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly rows: number,
    fans: Fans,
  ) {
    if (gl.getExtension("EXT_color_buffer_float") === null)
      throw new Error("This graphics driver cannot draw into float textures (EXT_color_buffer_float); update it.");
    this.lines = Math.ceil(rows / ROW_WIDTH);
    const height = this.lines * MOST_BLOCKS;
    const blank = (): [WebGLTexture, WebGLFramebuffer] => targetTexture(gl, ROW_WIDTH, height);
    const [moves, positions, normals] = [blank(), blank(), blank()];
    [this.moves, this.positions, this.normals] = [moves[0], positions[0], normals[0]];
    this.targets = { moves: moves[1], positions: positions[1], normals: normals[1] };
    const empty = new Float32Array(4 * ROW_WIDTH * height);
    [this.bases, this.offsets, this.fields] = [0, 1, 2].map(() => floatTexture(gl, empty, 4, ROW_WIDTH)) as [
      WebGLTexture,
      WebGLTexture,
      WebGLTexture,
    ];
    this.tangents = layeredTexture(gl, ROW_WIDTH, height, 3);
    this.ranges = dataTexture(gl, fanSpans(fans), ROW_WIDTH);
    this.corners = dataTexture(gl, fans.pairs, CORNER_WIDTH);
    this.spans = dataTexture(gl, new Uint32Array(2 * rows), ROW_WIDTH);
    this.anchors = floatTexture(gl, new Float32Array(2), 2, CORNER_WIDTH);
    this.programs = {
      move: createProgram(gl, BAND_VERTEX, MOVE_FRAGMENT),
      place: createProgram(gl, BAND_VERTEX, PLACE_FRAGMENT),
      turn: createProgram(gl, BAND_VERTEX, TURN_FRAGMENT),
    };
    [this.list, this.listed] = [gl.createVertexArray(), gl.createBuffer()];
    this.scratch = new Float32Array(4 * ROW_WIDTH * this.lines);
  }

  /** Tells which rows follow which. */
  setFollowers(followers: Followers): void {
    const { gl } = this;
    const spans = new Uint32Array(2 * this.rows);
    const links: number[] = [];
    followers.rows.forEach((row, place) => {
      spans[2 * row] = links.length / 2;
      for (let link = place * followers.links; link < (place + 1) * followers.links; link++)
        if (followers.shares[link] !== 0)
          links.push(followers.anchors[link] as number, followers.shares[link] as number);
      spans[2 * row + 1] = links.length / 2;
    });
    gl.deleteTexture(this.spans);
    gl.deleteTexture(this.anchors);
    this.spans = dataTexture(gl, spans, ROW_WIDTH);
    this.anchors = floatTexture(gl, Float32Array.from(links), 2, CORNER_WIDTH);
  }

  /** Puts a face's base, offsets and, where they are new, tangents into its block. */
  upload(block: number, figure: Figure, tangents: boolean): void {
    const { gl } = this;
    this.fill(this.bases, block, figure.base, 3);
    this.fill(this.offsets, block, figure.offset, 3);
    if (!tangents || figure.tangents === undefined) return;
    const size = figure.tangents.length / 3;
    for (let part = 0; part < 3; part++) {
      spaced(this.scratch, figure.tangents.subarray(part * size, (part + 1) * size), 3);
      gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.tangents);
      const [y, height] = [block * this.lines, this.lines];
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, y, part, ROW_WIDTH, height, 1, gl.RGBA, gl.FLOAT, this.scratch);
    }
  }

  /** Puts a field (V, 4) into a slot. */
  setField(slot: number, field: Float32Array): void {
    this.fill(this.fields, slot, field, 4);
  }

  /** Runs the passes for `count` faces from block `first` on. */
  run(step: Step, first: number, count: number): void {
    const { gl } = this;
    if (step.turned.length === 0 || count === 0) return;
    for (const feature of [gl.BLEND, gl.DEPTH_TEST, gl.SCISSOR_TEST, gl.CULL_FACE]) gl.disable(feature);
    gl.colorMask(true, true, true, true);
    gl.viewport(0, 0, ROW_WIDTH, this.lines * MOST_BLOCKS);
    gl.bindVertexArray(this.list);
    const moved = this.write(step.moved);
    this.pass("move", "moves", [first, count, moved], step);
    this.pass("place", "positions", [first, count, moved], step);
    const turned = this.write(step.turned);
    this.pass("turn", "normals", [first, count, turned], step);
    gl.bindVertexArray(null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** A block's positions, (rows, 3) metres, read back (slow: for tests). */
  read(block: number): Float32Array {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.targets.positions);
    gl.readPixels(0, block * this.lines, ROW_WIDTH, this.lines, gl.RGBA, gl.FLOAT, this.scratch);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const out = new Float32Array(3 * this.rows);
    for (let row = 0; row < this.rows; row++) out.set(this.scratch.subarray(4 * row, 4 * row + 3), 3 * row);
    return out;
  }

  dispose(): void {
    const { gl } = this;
    const { moves, positions, normals, bases, offsets, fields, tangents, ranges, corners, spans, anchors } = this;
    for (const texture of [
      moves,
      positions,
      normals,
      bases,
      offsets,
      fields,
      tangents,
      ranges,
      corners,
      spans,
      anchors,
    ])
      gl.deleteTexture(texture);
    for (const target of Object.values(this.targets)) gl.deleteFramebuffer(target);
    for (const program of Object.values(this.programs)) gl.deleteProgram(program);
    gl.deleteVertexArray(this.list);
    gl.deleteBuffer(this.listed);
  }

  private fill(texture: WebGLTexture, block: number, values: Float32Array, parts: 3 | 4): void {
    const { gl } = this;
    spaced(this.scratch, values, parts);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, block * this.lines, ROW_WIDTH, this.lines, gl.RGBA, gl.FLOAT, this.scratch);
  }

  /** Lists the bands that hold these rows; how many there are. */
  private write(rows: Uint32Array): number {
    const { gl } = this;
    const bands = bandsOf(rows);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.listed);
    gl.bufferData(gl.ARRAY_BUFFER, bands, gl.STREAM_DRAW);
    return bands.length;
  }

  /** What a pass samples; followers may have come since the pass before. */
  private inputs(pass: "move" | "place" | "turn"): readonly Sampled[] {
    if (pass === "move")
      return [
        ["tangents", "layers", this.tangents],
        ["fields", "flat", this.fields],
      ];
    const names =
      pass === "place"
        ? (["bases", "offsets", "moves", "spans", "anchors"] as const)
        : (["positions", "ranges", "corners"] as const);
    return names.map((name) => [name, "flat", this[name]]);
  }

  private pass(
    name: "move" | "place" | "turn",
    target: "moves" | "positions" | "normals",
    [first, faces, bands]: readonly [number, number, number],
    { slots, lags }: Step,
  ): void {
    const { gl } = this;
    const program = this.programs[name];
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.targets[target]);
    gl.useProgram(program);
    const at = (uniform: string) => gl.getUniformLocation(program, uniform);
    this.inputs(name).forEach(([uniform, kind, texture], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(kind === "layers" ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D, texture);
      gl.uniform1i(at(uniform), unit);
    });
    gl.activeTexture(gl.TEXTURE0);
    gl.uniform1i(at("lines"), this.lines);
    gl.uniform1i(at("firstBlock"), first);
    gl.uniform1i(at("faces"), faces);
    gl.uniform1f(at("height"), this.lines * MOST_BLOCKS);
    gl.uniform1iv(at("slots"), slots);
    gl.uniform1fv(at("lags"), lags);
    const band = gl.getAttribLocation(program, "band");
    gl.enableVertexAttribArray(band);
    gl.vertexAttribIPointer(band, 1, gl.UNSIGNED_INT, 0, 0);
    gl.vertexAttribDivisor(band, faces);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, bands * faces);
  }
}

/** Rows of `parts` numbers as rows of four; the rest is zero. */
function spaced(into: Float32Array, values: Float32Array, parts: 3 | 4): void {
  into.fill(0);
  if (parts === 4) into.set(values);
  else
    for (let row = 0; 3 * row < values.length; row++) {
      into[4 * row] = values[3 * row] as number;
      into[4 * row + 1] = values[3 * row + 1] as number;
      into[4 * row + 2] = values[3 * row + 2] as number;
    }
}

function layeredTexture(gl: WebGL2RenderingContext, width: number, height: number, depth: number): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
  gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.RGBA32F, width, height, depth);
  gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return texture;
}
