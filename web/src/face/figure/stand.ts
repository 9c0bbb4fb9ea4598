/** The neutral stand: how the bones of a body turn from the pose it was modelled in, as `model.body.stand` has it. */

import {
  cross,
  frameOf,
  IDENTITY,
  inverse,
  minus,
  product,
  type Rotation,
  rotationOf,
  scaled,
  shortestTurn,
  turnedBy,
  twistAbout,
  unit,
  type Vector,
} from "./rotations";
import { placeOf, SIDES, type Side, type Skeleton } from "./skeleton";

const OUT = { L: 1, R: -1 } as const;
/** Degrees outward and forward of hanging straight down. */
const UPPER_ARM = [9, 2] as const;
const FOREARM = [5, 14] as const;
const HAND = [3, 16] as const;
/** Degrees by which the hanging hand's thumb side turns inward from straight ahead. */
const PALM = 12;
/** Degrees by which thigh and shin lean forward and back. */
const KNEE = 3;
/** Degrees of each foot. */
const TOES_OUT = 8;
/** Of the turn of the hand about the forearm, how much each half of it has taken up. */
const TWIST = { lowerarm01: 0.15, lowerarm02: 0.7 };

const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** The rotation of each bone from the modelled pose to the stand; `joints`, `ends`: where bones begin and end, metres. */
export function standTurns(skeleton: Skeleton, joints: readonly Vector[], ends: readonly Vector[]): Rotation[] {
  const turns = Array.from<Rotation>({ length: joints.length }).fill(IDENTITY);
  for (const side of SIDES) {
    hangArm(skeleton, joints, side, turns);
    straightenLeg(skeleton, joints, ends, side, turns);
  }
  return turns;
}

/** A direction by how far it leans outward and forward of straight down. */
const hanging = ([outward, forward]: readonly [number, number], side: Side): Vector =>
  unit([OUT[side] * Math.tan(radians(outward)), -1, Math.tan(radians(forward))]);

function hangArm(skeleton: Skeleton, joints: readonly Vector[], side: Side, turns: Rotation[]): void {
  const at = (name: string): Vector => joints[placeOf(skeleton, `${name}.${side}`)] as Vector;
  const upper = unit(minus(at("lowerarm01"), at("upperarm01")));
  const fore = unit(minus(at("wrist"), at("lowerarm01")));
  const arm = product(frameOf(hanging(UPPER_ARM, side), [-1, 0, 0]), inverse(frameOf(upper, cross(upper, fore))));
  const forearm = product(shortestTurn(turnedBy(arm, fore), hanging(FOREARM, side)), arm);
  const hand = frameOf(unit(minus(at("finger3-1"), at("wrist"))), minus(at("finger2-1"), at("finger5-1")));
  const thumb: Vector = [-OUT[side] * Math.sin(radians(PALM)), 0, Math.cos(radians(PALM))];
  const palm = product(frameOf(hanging(HAND, side), thumb), inverse(hand));
  const along = turnedBy(forearm, fore);
  const twist = twistAbout(product(palm, inverse(forearm)), along);
  const set = (name: string, turn: Rotation): void => {
    turns[placeOf(skeleton, `${name}.${side}`)] = turn;
  };
  set("upperarm01", arm);
  set("upperarm02", arm);
  for (const [name, share] of Object.entries(TWIST))
    set(name, product(rotationOf(scaled(along, share * twist)), forearm));
  set("wrist", palm);
  skeleton.names.forEach((name, place) => {
    if (name.endsWith(side) && /^(metacarpal|finger)/.test(name)) turns[place] = palm;
  });
}

function straightenLeg(
  skeleton: Skeleton,
  joints: readonly Vector[],
  ends: readonly Vector[],
  side: Side,
  turns: Rotation[],
): void {
  const place = (name: string): number => placeOf(skeleton, `${name}.${side}`);
  const [hip, knee, ankle] = ["upperleg01", "lowerleg01", "foot"].map((name) => joints[place(name)]) as [
    Vector,
    Vector,
    Vector,
  ];
  const thigh = shortestTurn(unit(minus(knee, hip)), hanging([0, KNEE], side));
  const bent = turnedBy(thigh, unit(minus(ankle, knee)));
  const shin = product(shortestTurn(bent, hanging([0, -KNEE], side)), thigh);
  const ahead = minus(ends[place("toes")] as Vector, ankle);
  const foot = rotationOf([0, OUT[side] * radians(TOES_OUT) - Math.atan2(ahead[0], ahead[2]), 0]);
  for (const [names, turn] of [
    [["upperleg01", "upperleg02"], thigh],
    [["lowerleg01", "lowerleg02"], shin],
    [["foot", "toes"], foot],
  ] as const)
    for (const name of names) turns[place(name)] = turn;
}
