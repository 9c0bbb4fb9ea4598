import { createProgram, floatTexture, targetTexture, wholeTexture } from "./gl";
import { PASS_VERTEX, ROW_WIDTH } from "./pass_shaders";
import {
  COPY_FRAGMENT,
  DATA_WIDTH,
  FOLLOW_FRAGMENT,
  FOLLOWER_VERTEX,
  PART_FRAGMENT,
  REST_FRAGMENT,
  ROW_VERTEX,
  RUNG_FRAGMENT,
  UPRIGHT_FRAGMENT,
} from "./settle_shaders";
import { RUNGS, type Settling } from "./settling";

/** The eyeballs as lids meet them: centres (6) and radii (2) metres, and where they look (6), unit vectors. */
export interface Sockets {
  centres: Float32Array;
  radii: Float32Array;
  sights: Float32Array;
}

type Target = [WebGLTexture, WebGLFramebuffer];
type Textures = Record<string, WebGLTexture>;

/** Puts the sums of compounds right on the GPU, pass by pass as `omote.perform.settle` does. */
export class Settler {
  /** Where the plain sum is drawn to, and the mixed face without expression. */
  readonly mixed: Target;
  readonly rest: Target;
  private readonly steps: [Target, Target];
  private readonly rungs: Target;
  private readonly restNormals: Target;
  private readonly allowed: WebGLTexture;
  private readonly allowedTexels: Float32Array;
  private readonly data: Textures;
  private readonly programs: Record<"rung" | "part" | "normal" | "upright" | "copy" | "follow", WebGLProgram>;
  private readonly rows: WebGLVertexArrayObject;
  private readonly followers: WebGLVertexArrayObject;
  private readonly nothing: WebGLVertexArrayObject;
  private readonly buffers: WebGLBuffer[] = [];
  private readonly triangleLines: number;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly settling: Settling,
    private readonly height: number,
  ) {
    const target = (width: number, lines: number): Target => targetTexture(gl, width, Math.max(1, lines));
    [this.mixed, this.rest] = [target(ROW_WIDTH, height), target(ROW_WIDTH, height)];
    this.steps = [target(ROW_WIDTH, height), target(ROW_WIDTH, height)];
    this.rungs = target(RUNGS, settling.upward.length);
    this.triangleLines = Math.ceil(settling.triangles.length / 4 / DATA_WIDTH);
    this.restNormals = target(DATA_WIDTH, this.triangleLines);
    const lines = Math.max(1, Math.ceil(settling.size / DATA_WIDTH));
    this.allowedTexels = new Float32Array(DATA_WIDTH * lines);
    this.allowed = floatTexture(gl, this.allowedTexels, 1, DATA_WIDTH);
    this.data = {
      rungRows: wholeTexture(gl, settling.rungRows, RUNGS),
      rungWeights: floatTexture(gl, settling.rungWeights, 4, RUNGS),
      triangles: wholeTexture(gl, settling.triangles, DATA_WIDTH),
      corners: wholeTexture(gl, settling.corners, DATA_WIDTH),
      anchors: floatTexture(gl, settling.anchors, 2, DATA_WIDTH),
    };
    this.programs = {
      rung: createProgram(gl, PASS_VERTEX, RUNG_FRAGMENT),
      part: createProgram(gl, ROW_VERTEX, PART_FRAGMENT),
      normal: createProgram(gl, PASS_VERTEX, REST_FRAGMENT),
      upright: createProgram(gl, ROW_VERTEX, UPRIGHT_FRAGMENT),
      copy: createProgram(gl, ROW_VERTEX, COPY_FRAGMENT),
      follow: createProgram(gl, FOLLOWER_VERTEX, FOLLOW_FRAGMENT),
    };
    this.nothing = gl.createVertexArray();
    const { rows, pulls, lids, spans, followers } = settling;
    this.rows = this.vertexArray([
      [rows, 1],
      [pulls, 3],
      [lids, 2],
      [spans, 2],
    ]);
    this.followers = this.vertexArray([[followers, 1]]);
  }

  /** The mixed face without expression is new in `rest`. */
  rested(): void {
    const { gl } = this;
    this.begin(this.programs.normal, this.restNormals[1], [DATA_WIDTH, this.triangleLines]);
    this.read(this.programs.normal, { rest: this.rest[0], triangles: this.data.triangles as WebGLTexture });
    gl.bindVertexArray(this.nothing);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** Draws what is in `mixed`, put right, into `target`; `allowed`: the compounds' allowances, weighted and added. */
  settle(target: WebGLFramebuffer, allowed: Float32Array, sockets: Sockets): void {
    this.writeAllowed(allowed);
    this.prepare(sockets);
    const half = this.settling.document.rounds / 2;
    let from: Target = this.mixed;
    const step = (program: WebGLProgram, leaving: boolean, extra: Textures): void => {
      const into = from === this.steps[0] ? this.steps[1] : this.steps[0];
      this.draw(program, into[1], leaving, { points: from[0], ...extra });
      from = into;
    };
    const part = (leaving: boolean): void => {
      this.measureRungs(from[0]);
      step(this.programs.part, leaving, { rungs: this.rungs[0] });
    };
    const unfold = (rounds: number, last: boolean): void => {
      for (let round = 0; round < rounds; round++)
        step(this.programs.upright, last && round === rounds - 1, {
          restNormals: this.restNormals[0],
          corners: this.data.corners as WebGLTexture,
        });
    };
    part(false);
    part(true);
    unfold(half, false);
    part(false);
    unfold(half, true);
    this.finish(from[0], target);
  }

  dispose(): void {
    const { gl } = this;
    for (const [texture, target] of [this.mixed, this.rest, ...this.steps, this.rungs, this.restNormals]) {
      gl.deleteTexture(texture);
      gl.deleteFramebuffer(target);
    }
    for (const texture of [this.allowed, ...Object.values(this.data)]) gl.deleteTexture(texture);
    for (const program of Object.values(this.programs)) gl.deleteProgram(program);
    for (const array of [this.rows, this.followers, this.nothing]) gl.deleteVertexArray(array);
    for (const buffer of this.buffers) gl.deleteBuffer(buffer);
  }

  private writeAllowed(allowed: Float32Array): void {
    const { gl } = this;
    this.allowedTexels.set(allowed);
    const lines = this.allowedTexels.length / DATA_WIDTH;
    gl.bindTexture(gl.TEXTURE_2D, this.allowed);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, DATA_WIDTH, lines, gl.RED, gl.FLOAT, this.allowedTexels);
  }

  /** What stays the same in all passes of a frame. */
  private prepare({ centres, radii, sights }: Sockets): void {
    const { gl, programs, settling } = this;
    const { bulge, cornea, upright, eager, flattest } = settling.document;
    for (const program of [programs.part, programs.upright]) {
      gl.useProgram(program);
      const at = (name: string) => gl.getUniformLocation(program, name);
      gl.uniform3fv(at("centres"), centres);
      gl.uniform2fv(at("radii"), radii);
      gl.uniform3fv(at("sights"), sights);
      gl.uniform2f(at("cornea"), bulge, Math.cos(cornea));
      gl.uniform1f(at("upright"), upright);
      gl.uniform1f(at("eager"), eager);
      gl.uniform1f(at("flattest"), flattest);
    }
    gl.useProgram(programs.rung);
    gl.uniform1i(gl.getUniformLocation(programs.rung, "first"), settling.triangles.length / 4);
    gl.uniform1fv(gl.getUniformLocation(programs.rung, "upward"), settling.upward);
    gl.useProgram(programs.follow);
    gl.uniform1i(gl.getUniformLocation(programs.follow, "width"), settling.width);
  }

  private measureRungs(points: WebGLTexture): void {
    const { gl, programs, data } = this;
    this.begin(programs.rung, this.rungs[1], [RUNGS, this.settling.upward.length]);
    const { rungRows, rungWeights } = data as { rungRows: WebGLTexture; rungWeights: WebGLTexture };
    this.read(programs.rung, { points, rest: this.rest[0], allowed: this.allowed, rungRows, rungWeights });
    gl.bindVertexArray(this.nothing);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  private draw(program: WebGLProgram, target: WebGLFramebuffer, leaving: boolean, textures: Textures): void {
    const { gl } = this;
    this.begin(program, target, [ROW_WIDTH, this.height]);
    this.read(program, { rest: this.rest[0], allowed: this.allowed, ...textures });
    gl.uniform1i(gl.getUniformLocation(program, "leaving"), leaving ? 1 : 0);
    gl.bindVertexArray(this.rows);
    gl.drawArrays(gl.POINTS, 0, this.settling.rows.length);
  }

  private finish(points: WebGLTexture, target: WebGLFramebuffer): void {
    const { gl, programs, height } = this;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.mixed[1]);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, target);
    gl.blitFramebuffer(0, 0, ROW_WIDTH, height, 0, 0, ROW_WIDTH, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    this.draw(programs.copy, target, false, { points });
    this.begin(programs.follow, target, [ROW_WIDTH, height]);
    this.read(programs.follow, { points, mixed: this.mixed[0], anchors: this.data.anchors as WebGLTexture });
    gl.bindVertexArray(this.followers);
    gl.drawArrays(gl.POINTS, 0, this.settling.followers.length);
  }

  private begin(program: WebGLProgram, target: WebGLFramebuffer, size: [number, number]): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.viewport(0, 0, ...size);
    gl.useProgram(program);
    gl.uniform2f(gl.getUniformLocation(program, "size"), ...size);
  }

  private read(program: WebGLProgram, textures: Textures): void {
    const { gl } = this;
    Object.entries(textures).forEach(([name, texture], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(gl.getUniformLocation(program, name), unit);
    });
  }

  /** A vertex array of values and how many of them a point has, at locations 0, 1, ... */
  private vertexArray(parts: [ArrayBufferView, number][]): WebGLVertexArrayObject {
    const { gl } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    parts.forEach(([values, width], at) => {
      const buffer = gl.createBuffer();
      this.buffers.push(buffer);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(at);
      if (values instanceof Float32Array) gl.vertexAttribPointer(at, width, gl.FLOAT, false, 0, 0);
      else gl.vertexAttribIPointer(at, width, values instanceof Int32Array ? gl.INT : gl.UNSIGNED_INT, 0, 0);
    });
    gl.bindVertexArray(null);
    return array;
  }
}
