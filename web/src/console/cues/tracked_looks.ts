/** What the cues of a list leave standing, as `perform/cues/tracking.py` has it, and the picture of that. */

import { ALL, PLAY_REGIONS } from "../../link/constants";
import type { Cue } from "../../link/messages";
import type { ThumbnailSubject } from "../../ui/thumbnails";
import { type Goal, kindOf } from "./goal_text";

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

/** The picture of what stands of a character: the face and the expression that show most. `home`: where no cue says. */
export function lookOf(tracked: Tracked, character: string, home: string): ThumbnailSubject {
  return {
    face: mostOf(tracked[`${character}/face`]) ?? home,
    expression: mostOf(tracked[`${character}/expression`]) ?? "neutral",
  };
}

const mostOf = (goal: Goal | undefined): string | undefined =>
  Object.entries(goal ?? {}).toSorted(([, one], [, other]) => other - one)[0]?.[0];
