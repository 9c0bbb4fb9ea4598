/** The programs of the corrective passes, with the uniforms that never change. */

import type { CorrectivesData } from "../anatomy/correctives_data";
import { createProgram, uniformAt } from "../gpu/gl";
import { PASS_VERTEX } from "../gpu/pass_shaders";
import {
  GATHER_FRAGMENT,
  GOAL_FRAGMENT,
  PART_FRAGMENT,
  REST_FRAGMENT,
  RUNG_FRAGMENT,
  SPREAD_FRAGMENT,
  UPRIGHT_FRAGMENT,
} from "./corrective_shaders";
import { DAMP_FRAGMENT, KEEP_FRAGMENT, PATCH_FRAGMENT } from "./damping_shaders";

/** Lines of a slot in the textures: places, triangles, rungs, allowances. */
export type Lines = readonly [places: number, triangles: number, rungs: number, allowed: number];

type Name = "gather" | "keep" | "patch" | "damp" | "rung" | "part" | "normal" | "goal" | "upright" | "spread";
export type Programs = Record<Name, WebGLProgram>;

/** The programs, told what holds for all frames: what is to be corrected, and where its textures' lines begin. */
export function createPrograms(gl: WebGL2RenderingContext, correctives: CorrectivesData, lines: Lines): Programs {
  const programs = {
    gather: createProgram(gl, PASS_VERTEX, GATHER_FRAGMENT),
    keep: createProgram(gl, PASS_VERTEX, KEEP_FRAGMENT),
    patch: createProgram(gl, PASS_VERTEX, PATCH_FRAGMENT),
    damp: createProgram(gl, PASS_VERTEX, DAMP_FRAGMENT),
    rung: createProgram(gl, PASS_VERTEX, RUNG_FRAGMENT),
    part: createProgram(gl, PASS_VERTEX, PART_FRAGMENT),
    normal: createProgram(gl, PASS_VERTEX, REST_FRAGMENT),
    goal: createProgram(gl, PASS_VERTEX, GOAL_FRAGMENT),
    upright: createProgram(gl, PASS_VERTEX, UPRIGHT_FRAGMENT),
    spread: createProgram(gl, PASS_VERTEX, SPREAD_FRAGMENT),
  };
  for (const program of Object.values(programs)) {
    gl.useProgram(program);
    gl.uniform4i(uniformAt(gl, program, "lines"), ...lines);
  }
  fixSteps(gl, programs, correctives);
  fixDamping(gl, programs, correctives);
  gl.useProgram(programs.rung);
  gl.uniform1i(uniformAt(gl, programs.rung, "first"), correctives.triangles.length / 4);
  gl.uniform1fv(uniformAt(gl, programs.rung, "upward"), correctives.upward);
  gl.useProgram(programs.spread);
  gl.uniform1i(uniformAt(gl, programs.spread, "width"), correctives.width);
  return programs;
}

/** How far lids and triangles are moved. */
function fixSteps(gl: WebGL2RenderingContext, programs: Programs, { document }: CorrectivesData): void {
  const { bulge, cornea, upright, floor, eager, flattest, full, momentum, margin, farthest } = document;
  gl.useProgram(programs.part);
  gl.uniform2f(uniformAt(gl, programs.part, "cornea"), bulge, Math.cos(cornea));
  gl.useProgram(programs.upright);
  for (const [name, value] of Object.entries({ momentum, eager, flattest, full }))
    gl.uniform1f(uniformAt(gl, programs.upright, name), value);
  gl.useProgram(programs.goal);
  gl.uniform1f(uniformAt(gl, programs.goal, "upright"), upright);
  gl.uniform1f(uniformAt(gl, programs.goal, "least"), floor);
  gl.uniform2f(uniformAt(gl, programs.goal, "margin"), margin, farthest);
}

/** How far a sum is damped, and by which patches. */
function fixDamping(gl: WebGL2RenderingContext, programs: Programs, correctives: CorrectivesData): void {
  const { upright, deep, kept } = correctives.document;
  gl.useProgram(programs.keep);
  gl.uniform3f(uniformAt(gl, programs.keep, "limits"), upright, deep, kept);
  gl.useProgram(programs.patch);
  gl.uniform1ui(uniformAt(gl, programs.patch, "count"), correctives.patches.length / 2);
  gl.useProgram(programs.damp);
  gl.uniform1i(uniformAt(gl, programs.damp, "each"), correctives.patchesEach);
}
