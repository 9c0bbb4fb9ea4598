/**
 * Corrects sums of compounds on the processor, as `omote.perform.blending.correctives` does. Only triangles beside what has
 * moved are looked at again, so that a sum with little wrong in it costs little.
 */

import { RUNGS } from "../../link/constants";
import type { CorrectivesData } from "../anatomy/correctives_data";
import type { Sockets } from "./corrective_passes";

/** A mixed face without expression: its places (m, 3), its triangles' normals (t, 3), twice the areas long, and their squared lengths (t,). */
export interface Rested {
  readonly points: Float64Array;
  readonly normals: Float64Array;
  readonly sizes: Float64Array;
}

type Vector = readonly [number, number, number];
type Positions = Float64Array | Float32Array;

const at = (points: Positions, place: number): Vector => [
  points[3 * place] as number,
  points[3 * place + 1] as number,
  points[3 * place + 2] as number,
];
const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (a: Vector, by: number): Vector => [by * a[0], by * a[1], by * a[2]];
const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const add = (points: Float64Array, place: number, vector: Vector): void => {
  for (let axis = 0; axis < 3; axis++)
    points[3 * place + axis] = (points[3 * place + axis] as number) + (vector[axis] as number);
};

/** Corrects one sum after another; what it needs for that is allocated once. */
export class ProcessorCorrectives {
  private readonly before: Float64Array;
  private readonly points: Float64Array;
  private readonly push: Float64Array;
  private readonly step: Float64Array;
  private readonly wanted: Float64Array;
  private readonly kept: Float64Array; // by triangle: the share of a sum that it may keep
  private readonly lost: Float64Array; // by patch
  private readonly goals: Float64Array;
  private readonly seen: Uint32Array; // by triangle: when it was last looked at
  private readonly lids: readonly number[]; // places that an eyeball may push
  private sweep = 0;

  constructor(private readonly data: CorrectivesData) {
    const [places, triangles] = [data.rows.length, data.triangles.length / 4];
    [this.before, this.points] = [new Float64Array(3 * places), new Float64Array(3 * places)];
    [this.push, this.step] = [new Float64Array(3 * places), new Float64Array(3 * places)];
    this.wanted = new Float64Array(places);
    [this.kept, this.goals] = [new Float64Array(triangles), new Float64Array(triangles)];
    this.lost = new Float64Array(data.patches.length / 2);
    this.seen = new Uint32Array(triangles);
    this.lids = Array.from(data.rows.keys()).filter((place) => (data.spans[4 * place] as number) > 0);
  }

  /** What is needed of positions (rows, 3) of a mixed face without expression. */
  rested(positions: Float64Array): Rested {
    const points = this.gather(positions, new Float64Array(this.points.length));
    const [normals, sizes] = [new Float64Array(3 * this.goals.length), new Float64Array(this.goals.length)];
    for (let t = 0; t < sizes.length; t++) {
      const normal = cross(...this.edges(points, t));
      normals.set(normal, 3 * t);
      sizes[t] = dot(normal, normal);
    }
    return { points, normals, sizes };
  }

  /** Corrects positions (rows, 3), in place; `allowed`: the compounds' allowances, weighted and added. */
  correct(positions: Float64Array, rest: Rested, allowed: Float32Array, sockets: Sockets): void {
    this.before.set(this.gather(positions, this.points));
    const damped = this.dampFolds(rest, allowed);
    let moved = this.openCrossings(rest, allowed) || damped;
    this.data.document.rounds.forEach((rounds, block) => {
      if (block > 0 && !moved) return; // the last block left all as it should be
      const opened = moved && this.openCrossings(rest, allowed);
      const left = this.leaveEyeballs(rest, allowed, sockets);
      if (block === 0) this.aim(rest, allowed);
      const repaired = this.repairFolds(rest, rounds);
      moved = opened || left || repaired;
    });
    this.spread(positions);
  }

  /** The share of a triangle's area at rest that is left, seen along its normal at rest; negative: folded. In plain
   * numbers, for every triangle is asked. */
  areaShare(points: Float64Array, rest: Rested, t: number): number {
    const { triangles } = this.data;
    const i = 3 * (triangles[4 * t] as number);
    const j = 3 * (triangles[4 * t + 1] as number);
    const k = 3 * (triangles[4 * t + 2] as number);
    const bx = (points[j] as number) - (points[i] as number);
    const by = (points[j + 1] as number) - (points[i + 1] as number);
    const bz = (points[j + 2] as number) - (points[i + 2] as number);
    const cx = (points[k] as number) - (points[i] as number);
    const cy = (points[k + 1] as number) - (points[i + 1] as number);
    const cz = (points[k + 2] as number) - (points[i + 2] as number);
    const along =
      (by * cz - bz * cy) * (rest.normals[3 * t] as number) +
      (bz * cx - bx * cz) * (rest.normals[3 * t + 1] as number) +
      (bx * cy - by * cx) * (rest.normals[3 * t + 2] as number);
    return along / (rest.sizes[t] as number);
  }

  /** The ways from a triangle's first corner to the other two. */
  private edges(points: Float64Array, t: number): [Vector, Vector] {
    const corner = (n: number): Vector => at(points, this.data.triangles[4 * t + n] as number);
    const first = corner(0);
    return [minus(corner(1), first), minus(corner(2), first)];
  }

  private gather(positions: Float64Array, into: Float64Array): Float64Array {
    this.data.rows.forEach((row, place) => {
      into.set(at(positions, row), 3 * place);
    });
    return into;
  }

  /** Brings places back towards rest by what their patches lose; whether any moved. */
  private dampFolds(rest: Rested, allowed: Float32Array): boolean {
    const { points, kept, lost, data } = this;
    const { patches, patchTriangles, members, rowPatches } = data;
    if (!this.measureKept(rest, allowed)) return false;
    for (let patch = 0; patch < lost.length; patch++) {
      let least = 1;
      for (let n = patches[2 * patch] as number; n < (patches[2 * patch + 1] as number); n++)
        least = Math.min(least, kept[patchTriangles[2 * n] as number] as number);
      lost[patch] = 1 - least;
    }
    for (let place = 0; place < data.rows.length; place++) {
      let share = 0;
      for (let n = 2 * rowPatches * place; n < 2 * rowPatches * (place + 1); n += 2)
        share += (members[n + 1] as number) * (lost[members[n] as number] as number);
      add(points, place, times(minus(at(rest.points, place), at(points, place)), share));
    }
    return true;
  }

  /** The share of the sum that each triangle may keep; whether any is less than all. */
  private measureKept(rest: Rested, allowed: Float32Array): boolean {
    const { points, kept, data } = this;
    const { least_area, deep, kept: least, sliver } = data.document;
    kept.fill(1);
    let some = false;
    for (let t = 0; t < kept.length; t++) {
      const lacking = deep * Math.max(sliver / Math.sqrt(rest.sizes[t] as number), 1);
      const goal = least_area - (allowed[t] as number) - lacking;
      if (this.areaShare(points, rest, t) >= goal) continue;
      some = true;
      const [b, c] = this.edges(rest.points, t);
      const [nowB, nowC] = this.edges(points, t);
      const [moveB, moveC] = [minus(nowB, b), minus(nowC, c)];
      const normal = times(at(rest.normals, t), 1 / (rest.sizes[t] as number));
      // The area at a share s of the move is 1 + slope s + square s^2.
      const slope = dot(cross(b, moveC), normal) + dot(cross(moveB, c), normal);
      const square = dot(cross(moveB, moveC), normal);
      const root = Math.sqrt(Math.max(slope * slope - 4 * square * (1 - goal), 0));
      kept[t] = Math.max((2 * (1 - goal)) / Math.max(root - slope, 1e-12), least);
    }
    return some;
  }

  /** Opens lines that cross, either side by half; whether any did. */
  private openCrossings(rest: Rested, allowed: Float32Array): boolean {
    const { points, data } = this;
    const halves = Array.from({ length: data.rungs.length / 4 }, (_, rung) => this.half(rest, allowed, rung));
    if (halves.every((half) => half === undefined)) return false;
    for (let place = 0; place < data.rows.length; place++) {
      const line = data.pulls[4 * place] as number;
      if (line < 0) continue;
      const along = Math.min(Math.max((data.pulls[4 * place + 2] as number) * RUNGS - 0.5, 0), RUNGS - 1);
      const first = Math.min(Math.trunc(along), RUNGS - 2);
      for (const [rung, share] of [[first, 1 - (along - first)], [first + 1, along - first]] as const) // biome-ignore format: two rungs
        add(
          points,
          place,
          times(halves[line * RUNGS + rung] ?? [0, 0, 0], share * (data.pulls[4 * place + 1] as number)),
        );
    }
    return true;
  }

  /** Half of the way that a rung lacks; undefined where it lacks nothing. */
  private half(rest: Rested, allowed: Float32Array, rung: number): Vector | undefined {
    const { points, data } = this;
    const still = this.onRung(rest.points, rung);
    const upward = (data.upward[Math.floor(rung / RUNGS)] as number) > 0.5;
    const along: Vector = upward ? [0, 1, 0] : times(still, 1 / Math.max(Math.hypot(...still), 1e-9));
    const least = Math.min(dot(along, still), 0) - (allowed[this.goals.length + rung] as number);
    const lack = least - dot(along, this.onRung(points, rung));
    return lack > 0 ? times(along, 0.5 * lack) : undefined;
  }

  private onRung(points: Float64Array, rung: number): Vector {
    const { rungs, rungWeights } = this.data;
    const sum = new Float64Array(3);
    for (let k = 4 * rung; k < 4 * rung + 4; k++)
      add(sum, 0, times(at(points, rungs[k] as number), rungWeights[k] as number));
    return at(sum, 0);
  }

  /** Pushes lids out of the eyeballs as far as they lie deeper than at rest and than allowed; whether any did. */
  private leaveEyeballs(rest: Rested, allowed: Float32Array, sockets: Sockets): boolean {
    const { points, data, lids } = this;
    let some = false;
    for (const place of lids) {
      const eye = (data.spans[4 * place] as number) - 1;
      const deep =
        this.depth(at(points, place), eye, sockets, at(sockets.sights, eye)) -
        (allowed[data.spans[4 * place + 1] as number] as number);
      if (deep <= 0) continue;
      const push = deep - Math.max(this.depth(at(rest.points, place), eye, sockets, [0, 0, 1]), 0);
      if (push <= 0) continue;
      some = true;
      const outward = minus(at(points, place), at(sockets.centres, eye));
      add(points, place, times(outward, push / Math.max(Math.hypot(...outward), 1e-9)));
    }
    return some;
  }

  /** How deep a point lies in an eyeball that looks along `sight`, metres. */
  private depth(point: Vector, eye: number, { centres, radii }: Sockets, sight: Vector): number {
    const { bulge, cornea } = this.data.document;
    const outward = minus(point, at(centres, eye));
    const far = Math.max(Math.sqrt(dot(outward, outward)), 1e-9);
    const end = Math.cos(cornea);
    const up = Math.max((dot(outward, sight) / far - end) / (1 - end), 0);
    return (radii[eye] as number) * (1 + bulge * up * up * (3 - 2 * up)) - far;
  }

  /** What each triangle is to keep of its area. */
  private aim(rest: Rested, allowed: Float32Array): void {
    const { least_area, floor, margin, farthest } = this.data.document;
    for (let t = 0; t < this.goals.length; t++) {
      const keeps = Math.max(least_area - (allowed[t] as number), floor);
      const lack = Math.max(keeps - this.areaShare(this.points, rest, t), 0);
      this.goals[t] = keeps + Math.min(margin * lack, farthest);
    }
  }

  /** Repairs folds by so many rounds at most (`omote.geometry.orientation`); whether any place moved. */
  private repairFolds(rest: Rested, rounds: number): boolean {
    const { goals, wanted, step } = this;
    step.fill(0);
    let moved: number[] = [];
    for (let round = 0; round < rounds; round++) {
      const wanting: number[] = [];
      if (round === 0) for (let t = 0; t < goals.length; t++) this.pushApart(rest, t, wanting);
      else this.pushBeside(rest, moved, wanting);
      for (const place of moved) if ((wanted[place] as number) === 0) step.fill(0, 3 * place, 3 * place + 3);
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
    const { points, data, goals, push, wanted } = this;
    const lack = (goals[t] as number) - this.areaShare(points, rest, t);
    if (lack <= 0) return;
    const { full, least_slope } = data.document;
    const size = rest.sizes[t] as number;
    const normal = times(at(rest.normals, t), 1 / size);
    const [b, c] = this.edges(points, t);
    const [atJ, atK] = [cross(c, normal), cross(normal, b)];
    const atI = minus(times(atJ, -1), atK);
    const slope = dot(atI, atI) + dot(atJ, atJ) + dot(atK, atK);
    const weight = Math.min(lack / full, 1);
    const far = (weight * lack) / Math.max(slope, least_slope / Math.sqrt(size));
    [atI, atJ, atK].forEach((way, corner) => {
      const place = data.triangles[4 * t + corner] as number;
      if ((wanted[place] as number) === 0) wanting.push(place);
      wanted[place] = (wanted[place] as number) + weight;
      add(push, place, times(way, far));
    });
  }

  /** Moves a place by the mean of what is wanted there and a share of its last step. */
  private advance(place: number): void {
    const { points, push, wanted, step } = this;
    const { over_relaxation, momentum } = this.data.document;
    const weight = wanted[place] as number;
    step.set(times(at(step, place), momentum * Math.min(weight, 1)), 3 * place);
    add(step, place, times(at(push, place), over_relaxation / weight));
    add(points, place, at(step, place));
    push.fill(0, 3 * place, 3 * place + 3);
    wanted[place] = 0;
  }

  /** All positions again: what has been corrected, and what hangs on it by as much of its move as it takes. */
  private spread(positions: Float64Array): void {
    const { points, before, data } = this;
    if (points.every((value, n) => value === before[n])) return;
    data.rows.forEach((row, place) => {
      positions.set(at(points, place), 3 * row);
    });
    data.followers.forEach((row, follower) => {
      for (let n = 2 * data.width * follower; n < 2 * data.width * (follower + 1); n += 2) {
        const place = data.anchors[n] as number;
        add(positions, row, times(minus(at(points, place), at(before, place)), data.anchors[n + 1] as number));
      }
    });
  }
}
