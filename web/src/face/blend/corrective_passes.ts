/** Runs the corrective passes on the GPU, all characters at once, as `omote.perform.blending.correctives` does on the CPU. */

import { RUNGS } from "../../link/constants";
import { type CorrectivesData, DATA_WIDTH, rolesOf } from "../anatomy/correctives_data";
import { dataTexture, floatTexture, targetTexture, uniformAt, wholeTexture } from "../gpu/gl";
import { ROW_WIDTH } from "../gpu/pass_shaders";
import { createPrograms, type Lines, type Programs } from "./corrective_programs";
import { SLOTS } from "./corrective_shaders";

/** The eyeballs as lids meet them: centres (6) and radii (2) metres, and where they look (6), unit vectors. */
export interface Sockets {
  centres: Float32Array;
  radii: Float32Array;
  sights: Float32Array;
}

/** One character's sum for the passes: the compounds' allowances, weighted and added, and its eyeballs. */
export interface Correction {
  allowed: Float32Array;
  sockets: Sockets;
  /** Where all positions are drawn to. */
  into: WebGLFramebuffer;
}

/** A texture that is drawn into, and its size in texels. */
interface Target {
  texture: WebGLTexture;
  frame: WebGLFramebuffer;
  size: [number, number];
}

type TargetName = "before" | "one" | "other" | "third" | "rungs" | "rest" | "normals" | "goals" | "patches";
type Textures = Record<string, WebGLTexture>;

/**
 * Puts the sums of compounds right on the GPU, pass by pass as `omote.perform.blending.correctives` does. Each pass takes
 * the characters of up to `SLOTS` slots at once: small passes cost by their number more than by their texels.
 */
export class CorrectivePasses {
  private readonly lines: Lines;
  private readonly targets: Record<TargetName, Target>;
  private readonly mixed: Target[] = []; // by slot: all positions
  private readonly allowed: WebGLTexture;
  private readonly allowedTexels: Float32Array;
  private readonly data: Textures;
  private readonly programs: Programs;
  private readonly bound = new Set<WebGLProgram>(); // whose samplers know their units
  private readonly nothing: WebGLVertexArrayObject;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly correctives: CorrectivesData,
    private readonly height: number,
  ) {
    const { rows, triangles, upward, size } = correctives;
    this.lines = [linesOf(rows.length), linesOf(triangles.length / 4), Math.max(1, upward.length), linesOf(size)];
    const [places, faces, rungs, allowed] = this.lines;
    const slots = (lines: number, width = DATA_WIDTH) => this.target(width, SLOTS * lines);
    this.targets = {
      before: slots(places),
      one: slots(places),
      other: slots(places),
      third: slots(places),
      rungs: slots(rungs, RUNGS),
      rest: slots(places),
      normals: slots(faces),
      goals: slots(faces),
      patches: slots(1),
    };
    this.allowedTexels = new Float32Array(SLOTS * allowed * DATA_WIDTH);
    this.allowed = floatTexture(gl, this.allowedTexels, 1, DATA_WIDTH);
    this.data = this.readData();
    this.programs = createPrograms(gl, correctives, this.lines);
    this.nothing = gl.createVertexArray();
  }

  /** Where the plain sum of the character in a slot is drawn to: all positions. */
  mixedIn(slot: number): WebGLFramebuffer {
    return this.mixedOf(slot).frame;
  }

  /** A mixed face without expression is new in a slot. */
  rested(slot: number): void {
    const { data, targets, lines } = this;
    this.gather(targets.rest, slot);
    const textures = { rest: targets.rest.texture, triangles: data.triangles as WebGLTexture };
    this.pass("normal", targets.normals, [slot * lines[1], lines[1]], textures);
  }

  /** Draws what is mixed in the first slots, put right, into their targets. */
  correct(corrections: readonly Correction[]): void {
    const { targets } = this;
    const count = corrections.length;
    this.writeAllowed(corrections);
    this.prepare(corrections);
    corrections.forEach((_, slot) => {
      this.gather(targets.before, slot);
    });
    let from = this.part(this.damp(targets.before, count), count, false);
    this.correctives.document.rounds.forEach((rounds, block) => {
      from = this.part(from, count, true);
      if (block === 0) this.aim(from, count);
      from = this.unfold(from, count, rounds);
    });
    corrections.forEach(({ into }, slot) => {
      this.spread(from, slot, into);
    });
  }

  dispose(): void {
    const { gl } = this;
    for (const { texture, frame } of [...Object.values(this.targets), ...this.mixed]) {
      gl.deleteTexture(texture);
      gl.deleteFramebuffer(frame);
    }
    for (const texture of [this.allowed, ...Object.values(this.data)]) gl.deleteTexture(texture);
    for (const program of Object.values(this.programs)) gl.deleteProgram(program);
    gl.deleteVertexArray(this.nothing);
  }

  private target(width: number, tall: number): Target {
    const [texture, frame] = targetTexture(this.gl, width, tall);
    return { texture, frame, size: [width, tall] };
  }

  private mixedOf(slot: number): Target {
    const known = this.mixed[slot] ?? this.target(ROW_WIDTH, this.height);
    this.mixed[slot] = known;
    return known;
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
      heard: dataTexture(gl, correctives.heard, DATA_WIDTH),
      patches: dataTexture(gl, correctives.patches, DATA_WIDTH),
      members: floatTexture(gl, correctives.members, 2, DATA_WIDTH),
      roles: dataTexture(gl, rolesOf(correctives, ROW_WIDTH * height), ROW_WIDTH),
    };
  }

  private writeAllowed(corrections: readonly Correction[]): void {
    const { gl, lines } = this;
    const one = DATA_WIDTH * lines[3];
    corrections.forEach(({ allowed }, slot) => {
      this.allowedTexels.set(allowed, slot * one);
    });
    gl.bindTexture(gl.TEXTURE_2D, this.allowed);
    const tall = corrections.length * lines[3];
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, DATA_WIDTH, tall, gl.RED, gl.FLOAT, this.allowedTexels);
  }

  /** What stays the same in all passes of a frame. */
  private prepare(corrections: readonly Correction[]): void {
    const { gl, programs } = this;
    const all = (part: keyof Sockets) => corrections.flatMap(({ sockets }) => [...sockets[part]]);
    const [centres, radii, sights] = [all("centres"), all("radii"), all("sights")];
    gl.useProgram(programs.part);
    gl.uniform3fv(uniformAt(gl, programs.part, "centres"), centres);
    gl.uniform1fv(uniformAt(gl, programs.part, "radii"), radii);
    gl.uniform3fv(uniformAt(gl, programs.part, "sights"), sights);
  }

  /** The rows that may move of what is mixed in a slot. */
  private gather(target: Target, slot: number): void {
    const { gl, programs, lines, data } = this;
    gl.useProgram(programs.gather);
    gl.uniform1i(uniformAt(gl, programs.gather, "slot"), slot);
    const textures = { mixed: this.mixedOf(slot).texture, rows: data.rows as WebGLTexture };
    this.pass("gather", target, [slot * lines[0], lines[0]], textures);
  }

  /** Brings patches that turn triangles far over back towards rest; where the result is. */
  private damp(from: Target, count: number): Target {
    const { targets, data, lines } = this;
    const { heard, patches, members, triangles } = data as Record<string, WebGLTexture>;
    const shared = { points: from.texture, rest: targets.rest.texture };
    const turned = { allowed: this.allowed, restNormals: targets.normals.texture, triangles };
    this.pass("keep", targets.goals, [0, count * lines[1]], { ...shared, ...turned } as Textures);
    this.pass("patch", targets.patches, [0, count], { kept: targets.goals.texture, heard, patches } as Textures);
    this.pass("damp", targets.one, [0, count * lines[0]], {
      ...shared,
      least: targets.patches.texture,
      members,
    } as Textures);
    return targets.one;
  }

  /** Opens lines that cross; where leaving, lids leave the eyeballs too; where the result is. */
  private part(from: Target, count: number, leaving: boolean): Target {
    const { gl, targets, data, lines } = this;
    const { pulls, rungPlaces, rungWeights } = data as Record<"pulls" | "rungPlaces" | "rungWeights", WebGLTexture>;
    const [points, rest] = [from.texture, targets.rest.texture];
    const textures = { points, rest, allowed: this.allowed, rungPlaces, rungWeights };
    this.pass("rung", targets.rungs, [0, count * lines[2]], textures);
    gl.useProgram(this.programs.part);
    gl.uniform1i(uniformAt(gl, this.programs.part, "leaving"), leaving ? 1 : 0);
    return this.step("part", from, count, { pulls, rungs: targets.rungs.texture });
  }

  /** What each triangle is to keep of its area. */
  private aim(from: Target, count: number): void {
    const { targets, data, lines } = this;
    const textures = { restNormals: targets.normals.texture, triangles: data.triangles as WebGLTexture };
    const shared = { points: from.texture, allowed: this.allowed };
    this.pass("goal", targets.goals, [0, count * lines[1]], { ...shared, ...textures });
  }

  /** Turns back triangles that lack area, by so many rounds; where the result is. */
  private unfold(from: Target, count: number, rounds: number): Target {
    const { targets, data } = this;
    const fixed = { restNormals: targets.normals.texture, goals: targets.goals.texture };
    let [earlier, now] = [from, from];
    for (let round = 0; round < rounds; round++) {
      const textures = { earlier: earlier.texture, ...fixed, corners: data.corners as WebGLTexture };
      const into = this.step("upright", now, count, textures, earlier);
      [earlier, now] = [now, into];
    }
    return now;
  }

  private step(name: "part" | "upright", from: Target, count: number, textures: Textures, kept = from): Target {
    const { targets, data, lines } = this;
    const into = [targets.one, targets.other, targets.third].find((each) => each !== from && each !== kept) as Target;
    const shared = { points: from.texture, rest: targets.rest.texture, spans: data.spans as WebGLTexture };
    this.pass(name, into, [0, count * lines[0]], { ...shared, allowed: this.allowed, ...textures });
    return into;
  }

  private spread(from: Target, slot: number, into: WebGLFramebuffer): void {
    const { gl, programs, targets, data } = this;
    const mixed = this.mixedOf(slot);
    gl.useProgram(programs.spread);
    gl.uniform1i(uniformAt(gl, programs.spread, "slot"), slot);
    this.pass("spread", { ...mixed, frame: into }, [0, this.height], {
      mixed: mixed.texture,
      before: targets.before.texture,
      points: from.texture,
      roles: data.roles as WebGLTexture,
      anchors: data.anchors as WebGLTexture,
    });
  }

  /** Draws one texel after the other into so many lines of a target from the first on; a program's samplers come in one order. */
  private pass(name: keyof Programs, target: Target, [first, tall]: [number, number], textures: Textures): void {
    const { gl, bound } = this;
    const program = this.programs[name];
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
    gl.viewport(0, first, target.size[0], tall);
    gl.useProgram(program);
    Object.entries(textures).forEach(([sampler, texture], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      if (!bound.has(program)) gl.uniform1i(uniformAt(gl, program, sampler), unit);
    });
    bound.add(program);
    gl.bindVertexArray(this.nothing);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}

/** Lines of texels that so many values take. */
const linesOf = (count: number): number => Math.max(1, Math.ceil(count / DATA_WIDTH));
