/** What cues name that is not in the show now: it may come later, so it is marked and not refused. */

import { ALL, PLAY_REGIONS } from "../../link/constants";
import { heldBy } from "../../link/framings";
import type { Cue } from "../../link/messages";
import { clipCallOf } from "./clip_goal";
import { type Goal, kindOf } from "./goal_text";
import { padPointOf } from "./pad_goal";

/** The names that there are, by what they are of. */
export type KnownNames = Readonly<
  Record<"face" | "expression" | "light" | "clip" | "character" | "gaze point" | "pad", ReadonlySet<string>>
>;

/** What a move names that there is not, in words: `no face dgo`. */
export function missingInMove(part: string, goal: Goal, known: KnownNames): string[] {
  const names = Object.keys(goal);
  const owner = part.slice(0, part.lastIndexOf("/"));
  const kind = kindOf(part);
  const lacks = (of: keyof KnownNames, name: string): string[] => (known[of].has(name) ? [] : [`no ${of} ${name}`]);
  const whose = owner === ALL ? [] : lacks("character", owner);
  const point = padPointOf(goal);
  if (point !== null) return [...whose, ...lacks("pad", point.pad)];
  if (kind === "face" || kind === "light") return [...whose, ...names.flatMap((name) => lacks(kind, name))];
  if (kind === "expression" || (PLAY_REGIONS as readonly string[]).includes(kind))
    return [...whose, ...names.flatMap((name) => lacks("expression", name))];
  const call = kind === "clip" ? clipCallOf(goal) : null;
  if (call !== null) return [...whose, ...lacks("clip", call.clip)];
  if (kind === "framing")
    return names.flatMap((name) =>
      heldBy(name)
        .split("+")
        .flatMap((one) => (one === ALL ? [] : lacks("character", one))),
    );
  const [looked = "", at] = /^(?:character|gaze_point) (.+)$/.exec(names[0] ?? "") ?? [];
  if (kind !== "look" || at === undefined) return whose;
  return [...whose, ...lacks(looked.startsWith("character") ? "character" : "gaze point", at)];
}

/** What a cue names that there is not, each once. */
export function missingInCue({ moves, actions }: Pick<Cue, "moves" | "actions">, known: KnownNames): string[] {
  const moved = Object.entries(moves).flatMap(([part, { goal }]) => missingInMove(part, goal, known));
  const said = actions.flatMap(({ does, to }) =>
    does !== "say" || to === ALL || known.character.has(to) ? [] : [`no character ${to}`],
  );
  return [...new Set([...moved, ...said])];
}
