/** Legs that reach their feet (two-bone inverse kinematics), as `perform.figures.legs` has it. */

import {
  dot,
  length,
  minus,
  plus,
  product,
  type Rotation,
  scaled,
  shortestTurn,
  turnedBy,
  unit,
  type Vector,
} from "./rotations";

/** Of its length, how far a leg reaches at most: a knee that is quite straight would not know which way to bend. */
const STRAIGHTEST = 0.9995;

/**
 * The rotations of thigh and shin, each from where it is, that bring an ankle to its target or as near as the leg comes.
 * `hip`, `knee`, `ankle`: where they are, metres; `ahead`: where the knee points.
 */
export function reachFoot(
  hip: Vector,
  knee: Vector,
  ankle: Vector,
  target: Vector,
  ahead: Vector,
): [thigh: Rotation, shin: Rotation] {
  const thigh = length(minus(knee, hip));
  const shin = length(minus(ankle, knee));
  const way = minus(target, hip);
  const wanted = length(way);
  const reach = Math.min(Math.max(wanted, Math.abs(thigh - shin) + 1e-4), STRAIGHTEST * (thigh + shin));
  const along: Vector = wanted > 1e-6 ? scaled(way, 1 / wanted) : [0, -1, 0];
  const beside = minus(ahead, scaled(along, dot(ahead, along)));
  const aside = length(beside) > 1e-6 ? unit(beside) : anyAside(along);
  const cosine = (thigh * thigh + reach * reach - shin * shin) / (2 * thigh * reach);
  const bend = Math.acos(Math.min(1, Math.max(-1, cosine)));
  const bent = plus(hip, scaled(plus(scaled(along, Math.cos(bend)), scaled(aside, Math.sin(bend))), thigh));
  const end = plus(hip, scaled(along, reach));
  const first = shortestTurn(scaled(minus(knee, hip), 1 / thigh), scaled(minus(bent, hip), 1 / thigh));
  const turned = turnedBy(first, scaled(minus(ankle, knee), 1 / shin));
  return [first, product(shortestTurn(turned, scaled(minus(end, bent), 1 / shin)), first)];
}

/** A direction that stands on another: forward, where that is possible. */
function anyAside(along: Vector): Vector {
  const ahead: Vector = Math.abs(along[2]) < 0.9 ? [0, 0, 1] : [0, 1, 0];
  return unit(minus(ahead, scaled(along, dot(ahead, along))));
}
