/** Runs the corrective passes on the GPU, as `omote.perform.blending.correctives` does on the CPU. */

import { RUNGS } from "../../link/constants";
import { type CorrectivesData, DATA_WIDTH, rolesOf } from "../anatomy/correctives_data";
import { createProgram, dataTexture, floatTexture, targetTexture, wholeTexture } from "../gpu/gl";
import { PASS_VERTEX, ROW_WIDTH } from "../gpu/pass_shaders";
import {
  GATHER_FRAGMENT,
  PART_FRAGMENT,
  REST_FRAGMENT,
  RUNG_FRAGMENT,
  SPREAD_FRAGMENT,
  UPRIGHT_FRAGMENT,
} from "./corrective_shaders";

/** The eyeballs as lids meet them: centres (6) and radii (2) metres, and where they look (6), unit vectors. */
export interface Sockets {
  centres: Float32Array;
  radii: Float32Array;
  sights: Float32Array;
}

/** A texture that is drawn into, and its size in texels. */
interface Target {
  texture: WebGLTexture;
  frame: WebGLFramebuffer;
  size: [number, number];
}

type Textures = Record<string, WebGLTexture>;
type Programs = Record<"gather" | "rung" | "part" | "normal" | "upright" | "spread", WebGLProgram>;

/** Puts the sums of compounds right on the GPU, pass by pass as `omote.perform.blending.correctives` does. */
export class CorrectivePasses {
  /** Where the plain sum is drawn to, and the mixed face without expression: all positions. */
  readonly mixed: WebGLFramebuffer;
  readonly still: WebGLFramebuffer;
  private readonly targets: Record<
    "mixed" | "still" | "before" | "rest" | "one" | "other" | "rungs" | "normals",
    Target
  >;
  private readonly allowed: WebGLTexture;
  private readonly allowedTexels: Float32Array;
  private readonly data: Textures;
  private readonly programs: Programs;
  private readonly nothing: WebGLVertexArrayObject;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly correctives: CorrectivesData,
    private readonly height: number,
  ) {
    const lines = (count: number): number => Math.max(1, Math.ceil(count / DATA_WIDTH));
    const target = (width: number, tall: number): Target => {
      const [texture, frame] = targetTexture(gl, width, tall);
      return { texture, frame, size: [width, tall] };
    };
    const places = (): Target => target(DATA_WIDTH, lines(correctives.rows.length));
    this.targets = {
      mixed: target(ROW_WIDTH, height),
      still: target(ROW_WIDTH, height),
      before: places(),
      rest: places(),
      one: places(),
      other: places(),
      rungs: target(RUNGS, Math.max(1, correctives.upward.length)),
      normals: target(DATA_WIDTH, lines(correctives.triangles.length / 4)),
    };
    this.mixed = this.targets.mixed.frame;
    this.still = this.targets.still.frame;
    this.allowedTexels = new Float32Array(DATA_WIDTH * lines(correctives.size));
    this.allowed = floatTexture(gl, this.allowedTexels, 1, DATA_WIDTH);
    this.data = this.readData();
    this.programs = createPrograms(gl);
    this.nothing = gl.createVertexArray();
    this.fix();
  }

  /** The mixed face without expression is new in `still`. */
  rested(): void {
    const { targets, data } = this;
    this.pass("gather", targets.rest, { mixed: targets.still.texture, rows: data.rows as WebGLTexture });
    this.pass("normal", targets.normals, { rest: targets.rest.texture, triangles: data.triangles as WebGLTexture });
  }

  /** Draws what is in `mixed`, put right, into `target`; `allowed`: the compounds' allowances, weighted and added. */
  correct(target: WebGLFramebuffer, allowed: Float32Array, sockets: Sockets): void {
    const { targets, data } = this;
    this.writeAllowed(allowed);
    this.prepare(sockets);
    this.pass("gather", targets.before, { mixed: targets.mixed.texture, rows: data.rows as WebGLTexture });
    const half = this.correctives.document.rounds / 2;
    let from = this.part(targets.before, false);
    from = this.part(from, true);
    for (let round = 0; round < half; round++) from = this.unfold(from, false);
    from = this.part(from, false);
    for (let round = 0; round < half; round++) from = this.unfold(from, round === half - 1);
    this.pass(
      "spread",
      { ...targets.mixed, frame: target },
      {
        mixed: targets.mixed.texture,
        before: targets.before.texture,
        points: from.texture,
        roles: data.roles as WebGLTexture,
        anchors: data.anchors as WebGLTexture,
      },
    );
  }

  dispose(): void {
    const { gl } = this;
    for (const { texture, frame } of Object.values(this.targets)) {
      gl.deleteTexture(texture);
      gl.deleteFramebuffer(frame);
    }
    for (const texture of [this.allowed, ...Object.values(this.data)]) gl.deleteTexture(texture);
    for (const program of Object.values(this.programs)) gl.deleteProgram(program);
    gl.deleteVertexArray(this.nothing);
  }

  private readData(): Textures {
    const { gl, correctives, height } = this;
    const rows = new Uint32Array(2 * correctives.rows.length);
    correctives.rows.forEach((row, place) => {
      rows[2 * place] = row;
    });
    return {
      rows: dataTexture(gl, rows, DATA_WIDTH),
      pulls: floatTexture(gl, correctives.pulls, 4, DATA_WIDTH),
      spans: wholeTexture(gl, correctives.spans, DATA_WIDTH),
      corners: wholeTexture(gl, correctives.corners, DATA_WIDTH),
      triangles: wholeTexture(gl, correctives.triangles, DATA_WIDTH),
      rungPlaces: wholeTexture(gl, correctives.rungs, RUNGS),
      rungWeights: floatTexture(gl, correctives.rungWeights, 4, RUNGS),
      anchors: floatTexture(gl, correctives.anchors, 2, DATA_WIDTH),
      roles: dataTexture(gl, rolesOf(correctives, ROW_WIDTH * height), ROW_WIDTH),
    };
  }

  private writeAllowed(allowed: Float32Array): void {
    const { gl } = this;
    this.allowedTexels.set(allowed);
    const lines = this.allowedTexels.length / DATA_WIDTH;
    gl.bindTexture(gl.TEXTURE_2D, this.allowed);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, DATA_WIDTH, lines, gl.RED, gl.FLOAT, this.allowedTexels);
  }

  /** What never changes. */
  private fix(): void {
    const { gl, programs, correctives } = this;
    const { bulge, cornea, upright, eager, flattest, full } = correctives.document;
    for (const program of [programs.part, programs.upright]) {
      gl.useProgram(program);
      gl.uniform2f(gl.getUniformLocation(program, "cornea"), bulge, Math.cos(cornea));
    }
    const last = (name: string) => gl.getUniformLocation(programs.upright, name);
    gl.uniform1f(last("upright"), upright);
    gl.uniform1f(last("eager"), eager);
    gl.uniform1f(last("flattest"), flattest);
    gl.uniform1f(last("full"), full);
    gl.useProgram(programs.rung);
    gl.uniform1i(gl.getUniformLocation(programs.rung, "first"), correctives.triangles.length / 4);
    gl.uniform1fv(gl.getUniformLocation(programs.rung, "upward"), correctives.upward);
    gl.useProgram(programs.spread);
    gl.uniform1i(gl.getUniformLocation(programs.spread, "width"), correctives.width);
  }

  /** What stays the same in all passes of a frame. */
  private prepare({ centres, radii, sights }: Sockets): void {
    const { gl, programs } = this;
    for (const program of [programs.part, programs.upright]) {
      gl.useProgram(program);
      const at = (name: string) => gl.getUniformLocation(program, name);
      gl.uniform3fv(at("centres"), centres);
      gl.uniform2fv(at("radii"), radii);
      gl.uniform3fv(at("sights"), sights);
    }
  }

  /** Opens lines that cross; where the result is. */
  private part(from: Target, leaving: boolean): Target {
    const { targets, data } = this;
    const { pulls, rungPlaces, rungWeights } = data as Record<"pulls" | "rungPlaces" | "rungWeights", WebGLTexture>;
    const [points, rest] = [from.texture, targets.rest.texture];
    this.pass("rung", targets.rungs, { points, rest, allowed: this.allowed, rungPlaces, rungWeights });
    return this.step("part", from, leaving, { pulls, rungs: targets.rungs.texture });
  }

  /** Turns back triangles that lack area, by one round; where the result is. */
  private unfold(from: Target, leaving: boolean): Target {
    const { targets, data } = this;
    const corners = data.corners as WebGLTexture;
    return this.step("upright", from, leaving, { restNormals: targets.normals.texture, corners });
  }

  private step(name: "part" | "upright", from: Target, leaving: boolean, textures: Textures): Target {
    const { targets, data, gl } = this;
    const into = from === targets.one ? targets.other : targets.one;
    gl.useProgram(this.programs[name]);
    gl.uniform1i(gl.getUniformLocation(this.programs[name], "leaving"), leaving ? 1 : 0);
    const shared = { points: from.texture, rest: targets.rest.texture, spans: data.spans as WebGLTexture };
    this.pass(name, into, { ...shared, allowed: this.allowed, ...textures });
    return into;
  }

  /** Draws one texel after the other into a target. */
  private pass(name: keyof Programs, target: Target, textures: Textures): void {
    const { gl } = this;
    const program = this.programs[name];
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
    gl.viewport(0, 0, ...target.size);
    gl.useProgram(program);
    Object.entries(textures).forEach(([sampler, texture], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(gl.getUniformLocation(program, sampler), unit);
    });
    gl.bindVertexArray(this.nothing);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}

const createPrograms = (gl: WebGL2RenderingContext): Programs => ({
  gather: createProgram(gl, PASS_VERTEX, GATHER_FRAGMENT),
  rung: createProgram(gl, PASS_VERTEX, RUNG_FRAGMENT),
  part: createProgram(gl, PASS_VERTEX, PART_FRAGMENT),
  normal: createProgram(gl, PASS_VERTEX, REST_FRAGMENT),
  upright: createProgram(gl, PASS_VERTEX, UPRIGHT_FRAGMENT),
  spread: createProgram(gl, PASS_VERTEX, SPREAD_FRAGMENT),
});
