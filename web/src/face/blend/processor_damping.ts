/** Damps sums on the processor, patch by patch, where they turn triangles far over (`omote.perform.blending.correctives`). */

import type { CorrectivesData } from "../anatomy/correctives_data";
import { areaLeft, type Rested } from "./rest_triangles";

/** Damps one sum after another; what it needs for that is allocated once. */
export class ProcessorDamping {
  private readonly keeps: Float64Array;
  private readonly lost: Float64Array;
  private readonly half: Float64Array;

  constructor(private readonly data: CorrectivesData) {
    this.keeps = new Float64Array(data.triangles.length / 4);
    this.lost = new Float64Array(data.patches.length / 2);
    this.half = new Float64Array(3 * data.rows.length);
  }

  /** Brings places (m, 3) back towards rest, in place, by what their patches lose; whether any moved. */
  damp(points: Float64Array, rest: Rested, allowed: Float32Array): boolean {
    const { data } = this;
    if (!this.measureShares(points, rest, allowed)) return false;
    this.measurePatches();
    for (let place = 0; place < data.rows.length; place++) {
      const lost = this.lostAt(place);
      for (let at = 3 * place; at < 3 * place + 3; at++)
        points[at] = (points[at] as number) + lost * ((rest.points[at] as number) - (points[at] as number));
    }
    return true;
  }

  /** The share of the sum that each triangle may keep; whether any is less than all. */
  private measureShares(points: Float64Array, rest: Rested, allowed: Float32Array): boolean {
    const { keeps, data, half } = this;
    const { upright, deep } = data.document;
    let some = false;
    for (let t = 0; t < keeps.length; t++) {
      const goal = upright - (allowed[t] as number) - deep;
      const whole = areaLeft(points, data.triangles, rest, t);
      keeps[t] = 1;
      if (whole >= goal) continue;
      if (!some)
        for (let n = 0; n < half.length; n++) half[n] = 0.5 * ((rest.points[n] as number) + (points[n] as number));
      some = true;
      keeps[t] = this.shareAt(goal, whole, areaLeft(half, data.triangles, rest, t));
    }
    return some;
  }

  /** At which share of a move a triangle's area, 1 at none of it, is at its goal: the root of a quadratic. */
  private shareAt(goal: number, whole: number, half: number): number {
    const square = 2 * (whole - 1) - 4 * (half - 1);
    const slope = whole - 1 - square;
    const root = Math.sqrt(Math.max(slope * slope - 4 * square * (1 - goal), 0));
    return Math.max((2 * (1 - goal)) / Math.max(root - slope, 1e-12), this.data.document.kept);
  }

  /** What each patch loses: as much as the worst of its triangles. */
  private measurePatches(): void {
    const { lost, keeps, data } = this;
    for (let patch = 0; patch < lost.length; patch++) {
      let kept = 1;
      for (let n = data.patches[2 * patch] as number; n < (data.patches[2 * patch + 1] as number); n++)
        kept = Math.min(kept, keeps[data.heard[2 * n] as number] as number);
      lost[patch] = 1 - kept;
    }
  }

  private lostAt(place: number): number {
    const { members, patchesEach } = this.data;
    let sum = 0;
    for (let n = patchesEach * place; n < patchesEach * (place + 1); n++)
      sum += (members[2 * n + 1] as number) * (this.lost[members[2 * n] as number] as number);
    return sum;
  }
}
