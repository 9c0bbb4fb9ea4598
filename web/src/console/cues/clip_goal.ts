/** How a cue plays a clip, as `perform/scene/clip_goals.py` has it: its name, and numbers whose names begin with a colon. */

import { LAYER_PARTS } from "../../link/constants";

export type ClipPart = (typeof LAYER_PARTS)[number];
export type ClipCall = Readonly<{
  clip: string;
  /** Seconds from its start. */
  start: number;
  /** Null: as the clip says. */
  speed: number | null;
  loop: boolean | null;
  /** How much of it shows; of what is not named nothing; null: all of it. */
  weights: Partial<Record<ClipPart, number>> | null;
}>;

/** How a goal plays a clip; null where it stops them. */
export function clipCallOf(goal: Readonly<Record<string, number>>): ClipCall | null {
  const names = Object.keys(goal);
  const clip = names.length === 1 ? names[0] : names.find((name) => !name.startsWith(":"));
  if (clip === undefined) return null;
  const number = (name: string): number | null => (names.length === 1 ? null : (goal[`:${name}`] ?? null));
  const loop = number("loop");
  const weights = LAYER_PARTS.flatMap((part) => {
    const weight = number(part);
    return weight === null ? [] : [[part, weight] as const];
  });
  return {
    clip,
    start: number("start") ?? 0,
    speed: number("speed"),
    loop: loop === null ? null : loop === 1,
    weights: weights.length === 0 ? null : Object.fromEntries(weights),
  };
}

/** The goal that plays a clip so; what all clips do is left out. */
export function goalOfClip({ clip, start, speed, loop, weights }: ClipCall): Record<string, number> {
  const parts = Object.entries(weights ?? {});
  const whole = parts.length === LAYER_PARTS.length && parts.every(([, weight]) => weight === 1);
  return {
    [clip]: 1,
    ...(start === 0 ? {} : { ":start": start }),
    ...(speed === null ? {} : { ":speed": speed }),
    ...(loop === null ? {} : { ":loop": loop ? 1 : 0 }),
    ...(whole ? {} : Object.fromEntries(parts.map(([part, weight]) => [`:${part}`, weight]))),
  };
}

/** A clip and how it plays, as people read it. */
export function clipWords({ clip, start, speed, loop, weights }: ClipCall): string {
  const parts = Object.entries(weights ?? {}).map(([part, weight]) => (weight === 1 ? part : `${part} ${weight}`));
  return [
    start === 0 ? clip : `${clip} from ${start} s`,
    ...(speed === null ? [] : [`speed ${speed}`]),
    ...(loop === null ? [] : [loop ? "again and again" : "once"]),
    ...(parts.length === 0 ? [] : [parts.join(" ")]),
  ].join(", ");
}

/** The call with a part in it, or without; null where nothing of the clip would play. A part that comes back shows all. */
export function withPart(call: ClipCall, part: ClipPart, on: boolean): ClipCall | null {
  const all = Object.fromEntries(LAYER_PARTS.map((each) => [each, 1]));
  const before = call.weights ?? all;
  const kept = LAYER_PARTS.filter((each) => (each === part ? on : each in before));
  if (kept.length === 0) return null;
  return { ...call, weights: Object.fromEntries(kept.map((each) => [each, before[each] ?? 1])) };
}
