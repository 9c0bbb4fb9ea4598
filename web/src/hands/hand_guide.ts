/**
 * The guided minute of a hand: what is to be done at each moment, axis by axis. The moves stand in `guide_moves.json`,
 * which the benchmark of rendered hands performs too.
 */

import moves from "./guide_moves.json";

/** The axes of a hand: the opening of the mouth that thumb and fingers make (0..1), two curls (-1 lifted..1 bent) of the index with the middle finger and of the little with the ring finger, three turns of the wrist (-1..1). */
export const HAND_AXES = ["opening", "index", "little", "yaw", "pitch", "roll"] as const;
export type HandAxis = (typeof HAND_AXES)[number];
/** What a hand does, by axis. */
export type HandAxes = Record<HandAxis, number>;

/** A part of the minute: what is asked, and when it ends. */
export interface GuideSection {
  name: string;
  advice: string;
  until: number;
}

const ADVICE: Record<string, string> = {
  rest: "Hand in profile, thumb against fingers, still",
  open: "Open and shut your hand with the drawn one",
  chatter: "Faster: chatter with it",
  first: "Lift and bend the index and the middle finger, while the hand slowly opens and turns",
  last: "Lift and bend the little and the ring finger, while the hand slowly opens and turns",
  turn: "Turn the hand to the side and back, at the wrist; the fingers go on",
  nod: "Nod with the hand, up and down; the fingers go on",
  tilt: "Tilt the hand, as a head to its shoulder; the fingers go on",
  all: "All at once, as well as you can",
};

/** The parts of the minute, in their order; times in seconds. */
export const GUIDE_SECTIONS: readonly GuideSection[] = moves.sections.map(({ name, until }) => ({
  name,
  until,
  advice: ADVICE[name] ?? name,
}));
/** Seconds of the whole. */
export const GUIDE_SECONDS = GUIDE_SECTIONS.at(-1)?.until ?? 0;
/** Seconds at its beginning in which the hand rests. */
export const REST_SECONDS = GUIDE_SECTIONS[0]?.until ?? 0;

/** What the drawn hand does at a time of the minute, seconds: from knot to knot without a jump of speed. */
export function guideTargets(time: number): HandAxes {
  const targets = HAND_AXES.map((axis) => [axis, between(moves.moves[axis], time)] as const);
  return Object.fromEntries(targets) as HandAxes;
}

/** The part of the minute at a time, seconds. */
export const guideSection = (time: number): GuideSection =>
  GUIDE_SECTIONS.find(({ until }) => time < until) ?? (GUIDE_SECTIONS.at(-1) as GuideSection);

function between(knots: number[][], time: number): number {
  const next = knots.findIndex(([at = 0]) => time < at);
  const [before, after] = [knots[next - 1], knots[next]];
  if (next < 0) return knots.at(-1)?.[1] ?? 0;
  if (before === undefined || after === undefined) return after?.[1] ?? 0;
  const [[from = 0, low = 0], [to = 0, high = 0]] = [before, after];
  const share = (time - from) / (to - from);
  return low + share * share * (3 - 2 * share) * (high - low);
}
