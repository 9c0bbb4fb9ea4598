/** The bilinear mix of faces and expressions as one list of weighted terms. */

import { PLAY_REGIONS } from "../../link/constants";
import type { Pose } from "./pose";

type PlayRegion = (typeof PLAY_REGIONS)[number];

/** A weight for each region in which an expression can be called alone, in the order of `PLAY_REGIONS`. */
export type RegionWeights = readonly number[];

/**
 * One summand of the mix: a face itself (`expression` undefined) or what an expression adds to it. `regions`: its weights
 * where regions differ; `weight` is then the greatest of them. `most`: what its allowances count at most, the size of its
 * face's share: beyond a weight of 1 an expression is allowed nothing more.
 */
export interface Term {
  face: string;
  expression: string | undefined;
  weight: number;
  most: number;
  regions?: RegionWeights;
}

/** How much of a term may show, 0..1; what a stage has not loaded yet is held back. */
export type Share = (face: string, expression: string | undefined) => number;

/** Weights of all expressions and channels on air in a region, or where none goes its own way: `t + c`, the channels with
 * what is added to them. */
export function expressionWeights(pose: Pose, region?: PlayRegion): Record<string, number> {
  const own = region === undefined ? undefined : pose.regions[region];
  const sum: Record<string, number> = { ...(own ?? pose.expressions) };
  for (const name in pose.channels) sum[name] = (sum[name] ?? 0) + (pose.channels[name] as number);
  for (const name in pose.added) sum[name] = (sum[name] ?? 0) + (pose.added[name] as number);
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

/** Names of all expressions and channels on air, anywhere on the face. */
export function expressionNames(pose: Pose): string[] {
  const regional = Object.values(pose.regions).flatMap((mix) => Object.keys(mix));
  return [...new Set([...Object.keys(expressionWeights(pose)), ...regional])];
}

/** What each expression weighs: one number, or one for each region where they differ; without what weighs nothing. */
function weightsWorn(pose: Pose): [string, number | RegionWeights][] {
  const whole = expressionWeights(pose);
  if (Object.keys(pose.regions).length === 0) return Object.entries(whole).filter(([, weight]) => weight !== 0);
  const worn = PLAY_REGIONS.map((region) => (region in pose.regions ? expressionWeights(pose, region) : whole));
  return expressionNames(pose).flatMap((name): [string, number | RegionWeights][] => {
    const weights = worn.map((mix) => mix[name] ?? 0);
    const first = weights[0] as number;
    if (weights.some((weight) => weight !== first)) return [[name, weights]];
    return first === 0 ? [] : [[name, first]];
  });
}

/**
 * The bilinear mix as one flat sum (docs/method.md, "The mix" and "Regions of a call"): with `D_ij = P_ij - M_i`,
 * `P = sum_i s_i (sum_j t_j) M_i + sum_i sum_j s_i (t_j + c_j) D_ij`, where `t_j` may be another in each region.
 */
export function terms(pose: Pose, share: Share): Term[] {
  const expressions = weightsWorn(pose).filter(([name]) => name !== "neutral");
  const total = Object.values(pose.expressions).reduce((sum, weight) => sum + weight, 0);
  const list: Term[] = [];
  for (const [face, weight] of faceWeights(pose, share)) {
    list.push({ face, expression: undefined, weight: weight * total, most: Math.abs(weight) });
    for (const [expression, amount] of expressions) {
      const part = weight * share(face, expression);
      if (part !== 0) list.push(scaled(face, expression, part, amount));
    }
  }
  return list;
}

function scaled(face: string, expression: string, part: number, amount: number | RegionWeights): Term {
  const most = Math.abs(part);
  if (typeof amount === "number") return { face, expression, weight: part * amount, most };
  const regions = amount.map((weight) => part * weight);
  return { face, expression, weight: Math.max(...regions.map(Math.abs)), most, regions };
}
