/** The targets of a macro: what they can be, how people read them, and what a hand changes of them. */

import { MOST_KNOTS, NEAREST_KNOTS } from "../../link/constants";
import type { ExpressionDocument, HalfBelow, MacroMapping, MacroTarget, PadState } from "../../link/messages";
import {
  CHANNEL,
  GAZE_PITCH,
  GAZE_YAW,
  HEAD_PITCH,
  HEAD_ROLL,
  HEAD_YAW,
  type Range,
  valueAt,
  within,
} from "../../ui/travel";
import { curveAt, type Knot, type Knots, STRAIGHT } from "./monotone_curve";

/** The half of a target: `above` the middle of its macro, or below it. */
export type Half = "above" | "below";

const ANGLES: Readonly<Record<string, readonly [label: string, range: Range]>> = {
  "head/yaw": ["Head turn", HEAD_YAW],
  "head/pitch": ["Head nod", HEAD_PITCH],
  "head/roll": ["Head tilt", HEAD_ROLL],
  "gaze/yaw": ["Eyes across", GAZE_YAW],
  "gaze/pitch": ["Eyes up and down", GAZE_PITCH],
};
const DEGREES = 180 / Math.PI;
const PAD = "pad/";
const AXES = ["x", "y", "z"] as const;
const PLACE: Range = { low: -1, high: 1 };

/** What a target takes, in its unit: weights, radians, places of a pad. */
export const rangeOf = (to: string): Range => ANGLES[to]?.[1] ?? (to.startsWith(PAD) ? PLACE : CHANNEL);

/** How many of what people read one of a target's unit is: degrees of a radian, per cent of a weight. */
export const scaleOf = (to: string): number => (to in ANGLES ? DEGREES : 100);
export const unitOf = (to: string): string => (to in ANGLES ? "°" : to.startsWith(PAD) ? "" : "%");

/** A value of a target as people read it. */
export const reading = (to: string, value: number): string => `${Math.round(value * scaleOf(to))}${unitOf(to)}`;

/** What people call a target. */
export function targetLabel(to: string, label: (channel: string) => string): string {
  const angle = ANGLES[to]?.[0];
  if (angle !== undefined) return angle;
  const name = to.slice(to.indexOf("/") + 1);
  return to.startsWith(PAD) ? `Pad ${name.replace(/\/(\w)$/, ", $1")}` : label(name);
}

/** All that a macro can play, with what people call it: head and gaze, points of pads, channels. */
export function targetChoices(
  expressions: readonly ExpressionDocument[],
  pads: readonly Pick<PadState, "name" | "dimensions">[],
): (readonly [to: string, label: string])[] {
  const axes = pads.flatMap(({ name, dimensions }) => AXES.slice(0, dimensions).map((axis) => `${PAD}${name}/${axis}`));
  const channels = expressions.filter(({ kind }) => kind !== "neutral");
  return [
    ...[...Object.keys(ANGLES), ...axes].map((to) => [to, targetLabel(to, String)] as const),
    ...channels.map(({ name, label }) => [`channel/${name}`, label] as const),
  ];
}

/** A target that nobody has shaped: a channel up to its whole, an angle and a pad to half of their way and back. */
export function newTarget(to: string): MacroTarget {
  const goesBack = rangeOf(to) !== CHANNEL;
  const high = goesBack ? rangeOf(to).high / 2 : 1;
  const below = goesBack ? { high: -high, curve: [...straight()] } : null;
  return { to, low: 0, high, curve: [...straight()], below, rise: 0, fall: 0 };
}

const straight = (): [number, number][] => STRAIGHT.map(([at, gives]) => [at, gives]);

export const isTwoWay = ({ targets }: Pick<MacroMapping, "targets">): boolean =>
  targets.some(({ below }) => below !== null);

/** The range of a macro's fader. */
export const macroRange = (mapping: Pick<MacroMapping, "targets">): Range =>
  isTwoWay(mapping) ? { low: -1, high: 1 } : { low: 0, high: 1 };

/** What a target gives where its macro is at -1..1. */
export function targetAt(target: MacroTarget, macro: number): number {
  const { low, high, curve, below } = target;
  if (macro >= 0) return valueAt(curveAt(curve, macro), { low, high });
  return below === null ? low : valueAt(curveAt(below.curve, -macro), { low, high: below.high });
}

/** The values between which the curves of a target are drawn: those of its ends. */
export function drawnRange({ to, low, high, below }: MacroTarget): Range {
  const ends = [low, high, ...(below === null ? [] : [below.high])];
  const [least, most] = [Math.min(...ends), Math.max(...ends)];
  return most > least ? { low: least, high: most } : { low: least, high: least + 1 / scaleOf(to) };
}

/** The half of a target: the value at its end, and its curve. */
export function halfOf(target: MacroTarget, half: Half): HalfBelow | null {
  return half === "above" ? { high: target.high, curve: target.curve } : target.below;
}

/** A target with another curve of one half. */
export function withKnots(target: MacroTarget, half: Half, knots: Knots): MacroTarget {
  const curve = knots.map(([at, gives]): [number, number] => [at, gives]);
  if (half === "above") return { ...target, curve };
  return target.below === null ? target : { ...target, below: { ...target.below, curve } };
}

/** Knots with one of them moved: it stays between its neighbours; the first stays, the last stays at the end. */
export function movedKnot(knots: Knots, place: number, [at, gives]: Knot): Knots {
  const [before, after] = [knots[place - 1], knots[place + 1]];
  if (before === undefined) return knots;
  const between = { low: before[0] + NEAREST_KNOTS, high: (after?.[0] ?? 1) - NEAREST_KNOTS };
  const moved: Knot = [after === undefined ? 1 : rounded(within(at, between)), rounded(within(gives, UNIT))];
  return knots.map((knot, each) => (each === place ? moved : knot));
}

const UNIT: Range = { low: 0, high: 1 };
const rounded = (number: number): number => Math.round(number * 1e4) / 1e4;

/** Knots with one more, at a place or in the middle of the widest gap, on the curve; the same where there is no room. */
export function withKnotAt(knots: Knots, at: number = widestGap(knots)): Knots {
  if (knots.length >= MOST_KNOTS) return knots;
  const near = knots.some(([other]) => Math.abs(other - at) < NEAREST_KNOTS);
  if (near) return knots;
  const knot: Knot = [rounded(at), rounded(curveAt(knots, at))];
  return [...knots, knot].sort(([one], [other]) => one - other);
}

function widestGap(knots: Knots): number {
  const gaps = knots.slice(1).map(([end], at) => [end - (knots[at] as Knot)[0], end] as const);
  const [width, end] = gaps.reduce((widest, gap) => (gap[0] > widest[0] ? gap : widest));
  return end - width / 2;
}

/** Knots without one of them; both ends stay. */
export const withoutKnot = (knots: Knots, place: number): Knots =>
  place <= 0 || place >= knots.length - 1 ? knots : knots.filter((_, each) => each !== place);

/**
 * A target the other way round: what it gave at one end of the macro it gives at the other; one without a half below
 * zero begins where it ended.
 */
export function mirrored(target: MacroTarget): MacroTarget {
  const { below, low, high, curve } = target;
  if (below !== null) return { ...target, high: below.high, curve: below.curve, below: { high, curve } };
  return { ...target, low: high, high: low };
}

/** A name that no macro has yet: with a number after it where there is one of it. */
export function freeName(name: string, taken: readonly string[], longest: number): string {
  for (let count = 2; ; count += 1) {
    const tried = `${name.slice(0, longest - 1 - String(count).length)}-${count}`;
    if (!taken.includes(tried)) return tried;
  }
}

/** What is wrong with the name of a macro, "" where nothing is. */
export function wrongName(name: string, taken: readonly string[]): string {
  if (name === "") return "Type a name for the macro.";
  const letter = /[/*?[\]{}# ,]/.exec(name)?.[0];
  if (letter !== undefined)
    return `Leave out ${letter === " " ? "the space" : letter}: OSC addresses are made of the name.`;
  return taken.includes(name) ? `There is a macro ${name} already: type another name.` : "";
}
