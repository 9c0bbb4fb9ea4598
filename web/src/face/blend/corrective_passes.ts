/** Runs the corrective passes on the GPU, all characters at once, as `omote.perform.blending.correctives` does on the CPU. */

import { RUNGS } from "../../link/constants";
import { type CorrectivesData, DATA_WIDTH, rolesOf } from "../anatomy/correctives_data";
import { createProgram, dataTexture, floatTexture, targetTexture, uniformAt, wholeTexture } from "../gpu/gl";
import { PASS_VERTEX, ROW_WIDTH } from "../gpu/pass_shaders";
import { CORRECTIVE_FRAGMENTS, correctiveHead, type Lines, SLOTS, samplersOf } from "./corrective_shaders";

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

/** A texture that is drawn into, its texels to a line, and its lines to a slot. */
interface Target {
  texture: WebGLTexture;
  frame: WebGLFramebuffer;
  width: number;
  tall: number;
}

/** A program, and the samplers of its shader, one to a texture unit. */
interface Pass {
  program: WebGLProgram;
  samplers: readonly string[];
}

type PassName = keyof typeof CORRECTIVE_FRAGMENTS;
type TargetName = "before" | "first" | "second" | "third" | "rungs" | "rest" | "normals" | "goals" | "patches";
type Textures = Record<string, WebGLTexture>;

/**
 * Corrects sums of compounds on the GPU, pass by pass as `omote.perform.blending.correctives` does. Each pass takes the
 * characters of up to `SLOTS` slots at once: small passes cost by their number more than by their texels.
 */
export class CorrectivePasses {
  private readonly targets: Record<TargetName, Target>;
  private readonly mixed: Target[] = []; // by slot: all positions
  private readonly allowedTexels: Float32Array;
  private readonly data: Textures;
  /** What samplers of these names read in every pass. */
  private readonly fixed: Textures;
  private readonly passes: Record<PassName, Pass>;
  private readonly nothing: WebGLVertexArrayObject;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly correctives: CorrectivesData,
    private readonly height: number,
  ) {
    const linesOf = (count: number): number => Math.max(1, Math.ceil(count / DATA_WIDTH));
    const { rows, triangles, upward, size } = correctives;
    const lines: Lines = [
      linesOf(rows.length),
      linesOf(triangles.length / 4),
      Math.max(1, upward.length),
      linesOf(size),
    ];
    const slots = (tall: number, width = DATA_WIDTH) => this.target(width, tall, SLOTS);
    const places = () => slots(lines[0]);
    this.targets = {
      before: places(),
      first: places(),
      second: places(),
      third: places(),
      rungs: slots(lines[2], RUNGS),
      rest: places(),
      normals: slots(lines[1]),
      goals: slots(lines[1]),
      patches: slots(1),
    };
    this.allowedTexels = new Float32Array(SLOTS * lines[3] * DATA_WIDTH);
    this.data = this.readData();
    const { rest, normals, goals, patches, rungs, before } = this.targets;
    this.fixed = {
      ...this.data,
      rest: rest.texture,
      restNormals: normals.texture,
      goals: goals.texture,
      kept: goals.texture,
      least: patches.texture,
      rungs: rungs.texture,
      before: before.texture,
    };
    const head = correctiveHead(correctives, lines);
    const passes = Object.entries(CORRECTIVE_FRAGMENTS).map(([name, body]) => {
      return [name, this.createPass(head + samplersOf(body) + body)];
    });
    this.passes = Object.fromEntries(passes) as Record<PassName, Pass>;
    this.nothing = gl.createVertexArray();
  }

  /** Where the plain sum of the character in a slot is drawn to: all positions. */
  mixedIn(slot: number): WebGLFramebuffer {
    return this.mixedOf(slot).frame;
  }

  /** A mixed face without expression is new in a slot. */
  rested(slot: number): void {
    this.gather(this.targets.rest, slot);
    this.pass("rest", this.targets.normals, {}, 1, slot);
  }

  /** Draws what is mixed in the first slots, corrected, into their targets. */
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
      if (block === 0) this.pass("goal", targets.goals, { points: from.texture }, count);
      from = this.repair(from, count, rounds);
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
    for (const texture of Object.values(this.data)) gl.deleteTexture(texture);
    for (const { program } of Object.values(this.passes)) gl.deleteProgram(program);
    gl.deleteVertexArray(this.nothing);
  }

  private target(width: number, tall: number, slots = 1): Target {
    const [texture, frame] = targetTexture(this.gl, width, slots * tall);
    return { texture, frame, width, tall };
  }

  private mixedOf(slot: number): Target {
    const target = this.mixed[slot] ?? this.target(ROW_WIDTH, this.height);
    this.mixed[slot] = target;
    return target;
  }

  private createPass(fragment: string): Pass {
    const { gl } = this;
    const program = createProgram(gl, PASS_VERTEX, fragment);
    const samplers = [...fragment.matchAll(/uniform u?sampler2D (\w+);/g)].map(([, name]) => name as string);
    gl.useProgram(program);
    samplers.forEach((name, unit) => {
      gl.uniform1i(uniformAt(gl, program, name), unit);
    });
    return { program, samplers };
  }

  private readData(): Textures {
    const { gl, correctives, height } = this;
    const rows = new Uint32Array(2 * correctives.rows.length);
    correctives.rows.forEach((row, place) => {
      rows[2 * place] = row;
    });
    return {
      allowed: floatTexture(gl, this.allowedTexels, 1, DATA_WIDTH),
      rows: dataTexture(gl, rows, DATA_WIDTH),
      pulls: floatTexture(gl, correctives.pulls, 4, DATA_WIDTH),
      spans: wholeTexture(gl, correctives.spans, DATA_WIDTH),
      corners: wholeTexture(gl, correctives.corners, DATA_WIDTH),
      triangles: wholeTexture(gl, correctives.triangles, DATA_WIDTH),
      rungPlaces: wholeTexture(gl, correctives.rungs, RUNGS),
      rungWeights: floatTexture(gl, correctives.rungWeights, 4, RUNGS),
      anchors: floatTexture(gl, correctives.anchors, 2, DATA_WIDTH),
      patchTriangles: dataTexture(gl, correctives.patchTriangles, DATA_WIDTH),
      patches: dataTexture(gl, correctives.patches, DATA_WIDTH),
      members: floatTexture(gl, correctives.members, 2, DATA_WIDTH),
      roles: dataTexture(gl, rolesOf(correctives, ROW_WIDTH * height), ROW_WIDTH),
    };
  }

  private writeAllowed(corrections: readonly Correction[]): void {
    const { gl, allowedTexels } = this;
    const texelsPerSlot = allowedTexels.length / SLOTS;
    corrections.forEach(({ allowed }, slot) => {
      allowedTexels.set(allowed, slot * texelsPerSlot);
    });
    gl.bindTexture(gl.TEXTURE_2D, this.data.allowed as WebGLTexture);
    const tall = (corrections.length * texelsPerSlot) / DATA_WIDTH;
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, DATA_WIDTH, tall, gl.RED, gl.FLOAT, allowedTexels);
  }

  /** What stays the same in all passes of a frame. */
  private prepare(corrections: readonly Correction[]): void {
    const { gl } = this;
    const { program } = this.passes.part;
    const all = (part: keyof Sockets) => corrections.flatMap(({ sockets }) => [...sockets[part]]);
    gl.useProgram(program);
    gl.uniform3fv(uniformAt(gl, program, "centres"), all("centres"));
    gl.uniform1fv(uniformAt(gl, program, "radii"), all("radii"));
    gl.uniform3fv(uniformAt(gl, program, "sights"), all("sights"));
  }

  /** The rows that may move of what is mixed in a slot. */
  private gather(target: Target, slot: number): void {
    this.pass("gather", target, { mixed: this.mixedOf(slot).texture }, 1, slot);
  }

  /** Brings patches that fold triangles far back towards rest; where the result is. */
  private damp(from: Target, count: number): Target {
    const { goals, patches, first } = this.targets;
    const points = { points: from.texture };
    this.pass("keep", goals, points, count);
    this.pass("patch", patches, {}, count);
    this.pass("damp", first, points, count);
    return first;
  }

  /** Opens lines that cross; where leaving, lids leave the eyeballs too; where the result is. */
  private part(from: Target, count: number, leaving: boolean): Target {
    const { gl, targets, passes } = this;
    const points = { points: from.texture };
    const into = this.free(from);
    this.pass("rung", targets.rungs, points, count);
    gl.useProgram(passes.part.program);
    gl.uniform1i(uniformAt(gl, passes.part.program, "leaving"), leaving ? 1 : 0);
    this.pass("part", into, points, count);
    return into;
  }

  /** Repairs folds, by so many rounds; where the result is. */
  private repair(from: Target, count: number, rounds: number): Target {
    let [earlier, now] = [from, from];
    for (let round = 0; round < rounds; round++) {
      const into = this.free(now, earlier);
      this.pass("repair", into, { points: now.texture, earlier: earlier.texture }, count);
      [earlier, now] = [now, into];
    }
    return now;
  }

  /** A target of places that is none of these. */
  private free(...used: readonly Target[]): Target {
    const { first, second, third } = this.targets;
    return [first, second, third].find((target) => !used.includes(target)) as Target;
  }

  private spread(from: Target, slot: number, into: WebGLFramebuffer): void {
    const { gl, passes } = this;
    const mixed = this.mixedOf(slot);
    gl.useProgram(passes.spread.program);
    gl.uniform1i(uniformAt(gl, passes.spread.program, "slot"), slot);
    this.pass("spread", { ...mixed, frame: into }, { mixed: mixed.texture, points: from.texture });
  }

  /** Draws so many slots of a target from the first on; `own`: what samplers read that is not the same in every pass. */
  private pass(name: PassName, { frame, width, tall }: Target, own: Textures, count = 1, first = 0): void {
    const { gl, fixed } = this;
    const { program, samplers } = this.passes[name];
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.viewport(0, first * tall, width, count * tall);
    gl.useProgram(program);
    samplers.forEach((sampler, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, (own[sampler] ?? fixed[sampler]) as WebGLTexture);
    });
    gl.bindVertexArray(this.nothing);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
