/** The bilinear mix of faces and expressions as one list of weighted terms. */

import type { Pose } from "./pose";

/** One summand of the mix: a face itself (`expression` undefined) or what an expression adds to it. */
export interface Term {
  face: string;
  expression: string | undefined;
  weight: number;
}

/** How much of a term may show, 0..1; what a stage has not loaded yet is held back. */
export type Share = (face: string, expression: string | undefined) => number;

/** Weights of all expressions and channels on air: `t + c`, the channels with what the gaze adds. */
export function expressionWeights(pose: Pose): Record<string, number> {
  const sum: Record<string, number> = { ...pose.expressions };
  for (const name in pose.channels) sum[name] = (sum[name] ?? 0) + (pose.channels[name] as number);
  for (const name in pose.lids) sum[name] = (sum[name] ?? 0) + (pose.lids[name] as number);
  return sum;
}

/** The shares of the faces on air, as far as they are loaded, scaled so that they sum as the pose's do; empty: none is. */
export function faceWeights(pose: Pose, share: Share): Map<string, number> {
  const shown = Object.entries(pose.faces).map(
    ([name, weight]) => [name, weight, weight * share(name, undefined)] as const,
  );
  const wanted = shown.reduce((sum, [, weight]) => sum + weight, 0);
  const loaded = shown.reduce((sum, [, , weight]) => sum + weight, 0);
  if (!(Math.abs(loaded) > 1e-6)) return new Map();
  return new Map(
    shown.filter(([, , weight]) => weight !== 0).map(([name, , weight]) => [name, (weight * wanted) / loaded]),
  );
}

/**
 * The bilinear mix as one flat sum (docs/method.md, "The mix"): with `D_ij = P_ij - M_i`,
 * `P = sum_i s_i (sum_j t_j) M_i + sum_i sum_j s_i (t_j + c_j) D_ij`.
 */
export function terms(pose: Pose, share: Share): Term[] {
  const expressions = Object.entries(expressionWeights(pose)).filter(
    ([name, weight]) => weight !== 0 && name !== "neutral",
  );
  const total = Object.values(pose.expressions).reduce((sum, weight) => sum + weight, 0);
  const list: Term[] = [];
  for (const [face, weight] of faceWeights(pose, share)) {
    list.push({ face, expression: undefined, weight: weight * total });
    for (const [expression, amount] of expressions) {
      const part = weight * amount * share(face, expression);
      if (part !== 0) list.push({ face, expression, weight: part });
    }
  }
  return list;
}
