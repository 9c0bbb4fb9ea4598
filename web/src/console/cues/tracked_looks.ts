/** What the cues of a list leave standing, as `perform/cues/tracking.py` has it, and the picture of that. */

import { ALL, PLAY_REGIONS } from "../../link/constants";
import type { Cue, PadState } from "../../link/messages";
import type { ThumbnailSubject } from "../../ui/thumbnails";
import { softBands } from "../pads/blend_space";
import { type Goal, kindOf } from "./goal_text";
import { padPointOf } from "./pad_goal";

export type Tracked = Readonly<Record<string, Goal>>;

const ownerOf = (part: string): string => part.slice(0, Math.max(0, part.lastIndexOf("/")));

/** What stands once a cue has been called: an expression of the whole face takes its regions with it. */
export function trackedAfter(tracked: Tracked, { moves }: Pick<Cue, "moves">): Tracked {
  const taken = new Set(
    Object.keys(moves)
      .filter((part) => kindOf(part) === "expression")
      .flatMap((part) => PLAY_REGIONS.map((region) => `${ownerOf(part)}/${region}`)),
  );
  const kept = Object.entries(tracked).filter(([part]) => !taken.has(part));
  return Object.fromEntries([...kept, ...Object.entries(moves).map(([part, { goal }]) => [part, goal])]);
}

/** What stands after each cue of a list; those that are skipped leave nothing to the cues behind them. */
export function trackedLooks(cues: readonly Pick<Cue, "moves" | "skip">[]): Tracked[] {
  let tracked: Tracked = {};
  return cues.map((cue) => {
    const after = trackedAfter(tracked, cue);
    if (!cue.skip) tracked = after;
    return after;
  });
}

/** The character whose picture stands for a cue: of those that it moves the first whose face or expression it moves. */
export function shownCharacter({ moves }: Pick<Cue, "moves">): string | null {
  const parts = Object.keys(moves).filter((part) => ownerOf(part) !== ALL);
  const part = parts.find((each) => kindOf(each) === "face" || kindOf(each) === "expression") ?? parts[0];
  return part === undefined ? null : ownerOf(part);
}

/**
 * The picture of what stands of a character: the face and the expression that show most. `home`: where no cue
 * says; `pads`: those of the show.
 */
export function lookOf(tracked: Tracked, character: string, home: string, pads: readonly PadState[]): ThumbnailSubject {
  const most = (part: string): string | undefined => mostOf(mixOf(tracked[`${character}/${part}`] ?? {}, pads));
  return { face: most("face") ?? home, expression: most("expression") ?? "neutral" };
}

/** Weights by name: of a point of a pad those of its looks there, none where there is no such pad or place. */
function mixOf(goal: Goal, pads: readonly PadState[]): Goal {
  const point = padPointOf(goal);
  if (point === null) return goal;
  const pad = pads.find(({ name }) => name === point.pad);
  if (pad === undefined || pad.dimensions !== point.place.length) return {};
  const shown = softBands(
    pad.looks.map(({ place }) => place),
    point.place,
  );
  const mix: Record<string, number> = {};
  for (const [at, look] of pad.looks.entries())
    for (const [name, weight] of Object.entries(look.mix))
      mix[name] = (mix[name] ?? 0) + weight * (shown[at] as number);
  return mix;
}

const mostOf = (goal: Goal): string | undefined =>
  Object.entries(goal).toSorted(([, one], [, other]) => other - one)[0]?.[0];
