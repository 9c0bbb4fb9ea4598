/** What limb fields a figure wears, and its limbs' axes, as `perform.figures.limb_mix` and `model.body.limbs` have them. */

import { BREATH, HINGES, LIMBS, TENSED } from "../../link/constants";
import type { FigureSpace } from "../../link/figures";
import { length, minus, scaled, type Vector } from "./rotations";
import { placeOf, type Skeleton } from "./skeleton";

type Weights = Readonly<Record<string, number>>;

/** How much of each limb field a figure wears, of those that weigh something: the larger of what is called and what drives it. */
export function limbWeights(
  fields: FigureSpace["limbFields"],
  called: Weights,
  bends: readonly number[],
  breath: number,
): ReadonlyMap<string, number> {
  const worn = new Map<string, number>();
  for (const [name, { driver }] of fields) {
    const wanted = called[name] ?? 0;
    const driven = drivenBy(driver, bends, breath);
    const weight = Math.abs(driven) > Math.abs(wanted) ? driven : wanted;
    if (weight !== 0) worn.set(name, weight);
  }
  return worn;
}

function drivenBy(driver: string, bends: readonly number[], breath: number): number {
  if (driver === BREATH) return breath;
  const bend = bends[HINGES.findIndex(([, hinge]) => hinge === driver)];
  if (bend === undefined) return 0;
  const [slack, tense] = TENSED;
  return Math.min(1, Math.max(0, (bend - slack) / (tense - slack)));
}

/** Writes the sum of fields, out, round and along for each row on a limb, four numbers a row. */
export function writeLimbFields(
  fields: FigureSpace["limbFields"],
  worn: ReadonlyMap<string, number>,
  into: Float32Array,
): void {
  into.fill(0);
  for (const [name, weight] of worn) {
    const field = fields.get(name);
    field?.places.forEach((place, at) => {
      for (let part = 0; part < 3; part++)
        into[4 * place + part] = (into[4 * place + part] as number) + weight * (field.values[3 * at + part] as number);
    });
  }
}

/** Writes where the axis of each limb begins, from there to where it ends, and about which direction angles grow, as modelled. */
export function writeLimbAxes(skeleton: Skeleton, joints: readonly Vector[], into: Float32Array): void {
  LIMBS.forEach(([begin, end, outward], limb) => {
    const from = joints[placeOf(skeleton, begin)] as Vector;
    const way = minus(joints[placeOf(skeleton, end)] as Vector, from);
    into.set([...from, ...way, ...scaled(way, outward / length(way))], 9 * limb);
  });
}
