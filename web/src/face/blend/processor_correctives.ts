/**
 * Corrects sums of compounds on the processor, as `omote.perform.blending.correctives` does. Only triangles beside what has
 * moved are looked at again, so that a sum with little wrong in it costs little.
 */

import { RUNGS } from "../../link/constants";
import type { CorrectivesData } from "../anatomy/correctives_data";
import type { Sockets } from "./corrective_passes";
import { ProcessorDamping } from "./processor_damping";
import { areaLeft, between, cornersOf, cross, dot, type Rested, restTriangles } from "./rest_triangles";

/** Corrects one sum after another; what it needs for that is allocated once. */
export class ProcessorCorrectives {
  private readonly damping: ProcessorDamping;
  private readonly before: Float64Array;
  private readonly points: Float64Array;
  private readonly push: Float64Array;
  private readonly wanted: Float64Array;
  private readonly step: Float64Array;
  private readonly goals: Float64Array;
  private readonly halves: Float64Array;
  private readonly seen: Uint32Array; // by triangle: when it was last looked at
  private readonly lids: readonly number[]; // places that an eyeball may push
  private sweep = 0;

  constructor(private readonly data: CorrectivesData) {
    const [places, triangles] = [data.rows.length, data.triangles.length / 4];
    this.damping = new ProcessorDamping(data);
    this.before = new Float64Array(3 * places);
    this.points = new Float64Array(3 * places);
    this.push = new Float64Array(3 * places);
    this.wanted = new Float64Array(places);
    this.step = new Float64Array(3 * places);
    this.goals = new Float64Array(triangles);
    this.halves = new Float64Array(3 * RUNGS * data.upward.length);
    this.seen = new Uint32Array(triangles);
    this.lids = Array.from(data.rows.keys()).filter((place) => (data.spans[4 * place] as number) > 0);
  }

  /** What is needed of positions (rows, 3) of a mixed face without expression. */
  rested(positions: Float64Array): Rested {
    const { triangles } = this.data;
    const points = new Float64Array(this.points.length);
    this.gather(positions, points);
    return restTriangles(points, triangles);
  }

  /** Corrects positions (rows, 3), in place; `allowed`: the compounds' allowances, weighted and added. */
  correct(positions: Float64Array, rest: Rested, allowed: Float32Array, sockets: Sockets): void {
    const { points, before, data } = this;
    this.gather(positions, points);
    before.set(points);
    const damped = this.damping.damp(points, rest, allowed);
    let moved = this.part(rest, allowed) || damped;
    data.document.rounds.forEach((rounds, block) => {
      if (block > 0 && !moved) return; // the last block found all as it should be
      const parted = moved && this.part(rest, allowed);
      const left = this.leaveEyeballs(rest, allowed, sockets);
      if (block === 0) this.aim(rest, allowed);
      const turned = this.unfold(rest, rounds);
      moved = parted || left || turned;
    });
    this.spread(positions);
  }

  private gather(positions: Float64Array, into: Float64Array): void {
    const { rows } = this.data;
    for (let place = 0; place < rows.length; place++) {
      const row = 3 * (rows[place] as number);
      for (let axis = 0; axis < 3; axis++) into[3 * place + axis] = positions[row + axis] as number;
    }
  }

  /** Opens lines that cross, either side by half; whether any did. */
  private part(rest: Rested, allowed: Float32Array): boolean {
    const { points, halves, data } = this;
    if (!this.measureCrossings(rest, allowed)) return false;
    for (let place = 0; place < data.rows.length; place++) {
      const line = data.pulls[4 * place] as number;
      if (line < 0) continue;
      const along = Math.min(Math.max((data.pulls[4 * place + 2] as number) * RUNGS - 0.5, 0), RUNGS - 1);
      const first = Math.min(Math.trunc(along), RUNGS - 2);
      const after = along - first;
      for (let axis = 0; axis < 3; axis++) {
        const rung = 3 * (line * RUNGS + first) + axis;
        const half = (1 - after) * (halves[rung] as number) + after * (halves[rung + 3] as number);
        points[3 * place + axis] = (points[3 * place + axis] as number) + (data.pulls[4 * place + 1] as number) * half;
      }
    }
    return true;
  }

  /** Half of what each rung lacks, into `halves`; whether any lacks something. */
  private measureCrossings(rest: Rested, allowed: Float32Array): boolean {
    const { points, halves, data } = this;
    const firstRung = data.triangles.length / 4;
    let some = false;
    for (let rung = 0; rung < RUNGS * data.upward.length; rung++) {
      const still = this.onRung(rest.points, rung);
      const now = this.onRung(points, rung);
      const long = Math.max(Math.hypot(...still), 1e-9);
      const upward = (data.upward[Math.floor(rung / RUNGS)] as number) > 0.5;
      const along = upward ? [0, 1, 0] : still.map((value) => value / long);
      const lack = Math.max(
        Math.min(dot(along, still), 0) - (allowed[firstRung + rung] as number) - dot(along, now),
        0,
      );
      for (let axis = 0; axis < 3; axis++) halves[3 * rung + axis] = 0.5 * lack * (along[axis] as number);
      some ||= lack > 0;
    }
    return some;
  }

  private onRung(points: Float64Array, rung: number): number[] {
    const { rungs, rungWeights } = this.data;
    const sum = [0, 0, 0];
    for (let k = 4 * rung; k < 4 * rung + 4; k++)
      for (let axis = 0; axis < 3; axis++)
        sum[axis] =
          (sum[axis] as number) + (rungWeights[k] as number) * (points[3 * (rungs[k] as number) + axis] as number);
    return sum;
  }

  /** Pushes lids out of the eyeballs as far as they lie deeper than at rest and than allowed; whether any did. */
  private leaveEyeballs(rest: Rested, allowed: Float32Array, sockets: Sockets): boolean {
    const { points, data, lids } = this;
    let some = false;
    for (const place of lids) {
      const eye = (data.spans[4 * place] as number) - 1;
      const deep =
        this.depth(points, place, eye, sockets, true) - (allowed[data.spans[4 * place + 1] as number] as number);
      if (deep <= 0) continue;
      const push = deep - Math.max(this.depth(rest.points, place, eye, sockets, false), 0);
      if (push <= 0) continue;
      some = true;
      const outward = between(sockets.centres, points, eye, place);
      const far = Math.max(Math.hypot(...outward), 1e-9);
      for (let axis = 0; axis < 3; axis++)
        points[3 * place + axis] = (points[3 * place + axis] as number) + (push * (outward[axis] as number)) / far;
    }
    return some;
  }

  /** How deep a place lies in an eyeball that looks where it does, or straight ahead; metres. */
  private depth(points: Float64Array, place: number, eye: number, sockets: Sockets, looking: boolean): number {
    const { bulge, cornea } = this.data.document;
    const { centres, sights } = sockets;
    const x = (points[3 * place] as number) - (centres[3 * eye] as number);
    const y = (points[3 * place + 1] as number) - (centres[3 * eye + 1] as number);
    const z = (points[3 * place + 2] as number) - (centres[3 * eye + 2] as number);
    const far = Math.max(Math.sqrt(x * x + y * y + z * z), 1e-9);
    const ahead = looking
      ? x * (sights[3 * eye] as number) + y * (sights[3 * eye + 1] as number) + z * (sights[3 * eye + 2] as number)
      : z;
    const end = Math.cos(cornea);
    const up = Math.max((ahead / far - end) / (1 - end), 0);
    return (sockets.radii[eye] as number) * (1 + bulge * up * up * (3 - 2 * up)) - far;
  }

  /** What each triangle is to keep of its area. */
  private aim(rest: Rested, allowed: Float32Array): void {
    const { goals, points, data } = this;
    const { upright, floor, margin, farthest } = data.document;
    for (let t = 0; t < goals.length; t++) {
      const keeps = Math.max(upright - (allowed[t] as number), floor);
      const lack = Math.max(keeps - areaLeft(points, data.triangles, rest, t), 0);
      goals[t] = keeps + Math.min(margin * lack, farthest);
    }
  }

  /** Turns back triangles that lack area, by so many rounds at most (`omote.geometry.orientation`); whether any moved. */
  private unfold(rest: Rested, rounds: number): boolean {
    this.step.fill(0);
    let moved: number[] = [];
    for (let round = 0; round < rounds; round++) {
      const wanting: number[] = [];
      if (round === 0) for (let t = 0; t < this.goals.length; t++) this.pushApart(rest, t, wanting);
      else this.pushBeside(rest, moved, wanting);
      for (const place of moved) if ((this.wanted[place] as number) === 0) this.step.fill(0, 3 * place, 3 * place + 3);
      if (wanting.length === 0) return round > 0;
      for (const place of wanting) this.advance(place);
      moved = wanting;
    }
    return rounds > 0;
  }

  /** Looks at each triangle beside what has moved. */
  private pushBeside(rest: Rested, moved: readonly number[], wanting: number[]): void {
    const { seen, data } = this;
    this.sweep += 1;
    for (const place of moved)
      for (let n = data.spans[4 * place + 2] as number; n < (data.spans[4 * place + 3] as number); n++) {
        const t = data.corners[4 * n + 2] as number;
        if (seen[t] === this.sweep) continue;
        seen[t] = this.sweep;
        this.pushApart(rest, t, wanting);
      }
  }

  /** Adds what a triangle wants that lacks area; the places that want something for the first time go to `wanting`. */
  private pushApart(rest: Rested, t: number, wanting: number[]): void {
    const { points, data, goals } = this;
    const lack = (goals[t] as number) - areaLeft(points, data.triangles, rest, t);
    if (lack <= 0) return;
    const { full, flattest } = data.document;
    const [i, j, k] = cornersOf(data.triangles, t);
    const size = rest.sizes[t] as number;
    const normal = [0, 1, 2].map((axis) => (rest.normals[3 * t + axis] as number) / size);
    const atJ = cross(between(points, points, i, k), normal);
    const atK = cross(normal, between(points, points, i, j));
    const atI = [0, 1, 2].map((axis) => -(atJ[axis] as number) - (atK[axis] as number));
    const slope = dot(atI, atI) + dot(atJ, atJ) + dot(atK, atK);
    const weight = Math.min(lack / full, 1);
    const far = (weight * lack) / Math.max(slope, flattest / Math.sqrt(size));
    this.want(i, far, atI, weight, wanting);
    this.want(j, far, atJ, weight, wanting);
    this.want(k, far, atK, weight, wanting);
  }

  private want(place: number, far: number, way: readonly number[], weight: number, wanting: number[]): void {
    const { push, wanted } = this;
    if ((wanted[place] as number) === 0) wanting.push(place);
    wanted[place] = (wanted[place] as number) + weight;
    for (let axis = 0; axis < 3; axis++)
      push[3 * place + axis] = (push[3 * place + axis] as number) + far * (way[axis] as number);
  }

  /** Moves a place by the mean of what is wanted there and a share of its last step. */
  private advance(place: number): void {
    const { points, push, wanted, step } = this;
    const { eager, momentum } = this.data.document;
    const weight = wanted[place] as number;
    const kept = momentum * Math.min(weight, 1);
    for (let axis = 3 * place; axis < 3 * place + 3; axis++) {
      step[axis] = kept * (step[axis] as number) + (eager / weight) * (push[axis] as number);
      points[axis] = (points[axis] as number) + (step[axis] as number);
      push[axis] = 0;
    }
    wanted[place] = 0;
  }

  /** All positions again: what has been corrected, and what hangs on it. */
  private spread(positions: Float64Array): void {
    const { points, before: move, data } = this;
    let some = false;
    for (let n = 0; n < points.length; n++) {
      move[n] = (points[n] as number) - (move[n] as number);
      some ||= move[n] !== 0;
    }
    if (!some) return;
    for (let place = 0; place < data.rows.length; place++) {
      const row = 3 * (data.rows[place] as number);
      for (let axis = 0; axis < 3; axis++) positions[row + axis] = points[3 * place + axis] as number;
    }
    for (let n = 0; n < data.followers.length; n++) this.follow(positions, n);
  }

  /** Moves what hangs on places that have been corrected by as much of their move as it takes. */
  private follow(positions: Float64Array, follower: number): void {
    const { before: move, data } = this;
    let [x, y, z] = [0, 0, 0];
    for (let n = data.width * follower; n < data.width * (follower + 1); n++) {
      const place = 3 * (data.anchors[2 * n] as number);
      const weight = data.anchors[2 * n + 1] as number;
      x += weight * (move[place] as number);
      y += weight * (move[place + 1] as number);
      z += weight * (move[place + 2] as number);
    }
    const row = 3 * (data.followers[follower] as number);
    positions[row] = (positions[row] as number) + x;
    positions[row + 1] = (positions[row + 1] as number) + y;
    positions[row + 2] = (positions[row + 2] as number) + z;
  }
}
