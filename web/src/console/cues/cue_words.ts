/** Cues in words and times, as people read them at a desk and from two metres. */

import { ALL } from "../../link/constants";
import type { Cue, CueListStatus } from "../../link/messages";
import { clipCallOf } from "./clip_goal";
import { type Goal, goalWords, kindOf, partsInOrder, STOP } from "./goal_text";

/** Seconds that count down or up: tenths below a minute, then minutes and seconds. */
export function countOf(seconds: number): string {
  const left = Math.max(0, seconds);
  if (left < 59.95) return left.toFixed(1);
  const whole = Math.round(left);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

/** How long something takes already: with its unit below a minute. */
export const agoOf = (seconds: number): string => `${countOf(seconds)}${seconds < 59.95 ? " s" : ""}`;

/** What comes after a cue by itself; "" where nothing does. */
export function goesOnWords({ goes_on, post_wait }: Pick<Cue, "goes_on" | "post_wait">): string {
  if (goes_on === "") return "";
  const wait = post_wait === 0 ? "" : ` + ${post_wait} s`;
  return goes_on === "continue" ? `next with it${wait}` : `next after it${wait}`;
}

/** Whose part it is, and which: `Kaori face`; of the scene the part alone. */
export function partWords(part: string, labels: Readonly<Record<string, string>>): string {
  const owner = part.slice(0, part.lastIndexOf("/"));
  return owner === ALL ? kindOf(part) : `${labels[owner] || owner} ${kindOf(part)}`;
}

/** The same of a part that a cue moves, with the clip that it plays: `Kaori clip monologue`. */
export function movedWords(part: string, goal: Goal | undefined, labels: Readonly<Record<string, string>>): string {
  const words = partWords(part, labels);
  return goal === undefined || kindOf(part) !== "clip" ? words : `${words} ${clipCallOf(goal)?.clip ?? STOP}`;
}

/** What a cue is called; one without a label by the parts that it moves. */
export function titleWords(
  { label, moves, actions }: Pick<Cue, "label" | "moves" | "actions">,
  labels: Readonly<Record<string, string>>,
): string {
  const parts = Object.keys(moves);
  if (label !== "") return label;
  const more = parts.length > 3 ? ` and ${parts.length - 3} more` : "";
  const named = parts.slice(0, 3).map((part) => movedWords(part, moves[part]?.goal, labels));
  if (parts.length === 0 && actions.length > 0) return movesWords({ moves, actions: actions.slice(0, 1) }, labels);
  return parts.length === 0 ? "moves nothing" : `${named.join(", ")}${more}`;
}

const late = (delay: number): string => (delay === 0 ? "" : ` after ${delay} s`);

/** All that a cue moves and does in a line, for a running order. */
export function movesWords(
  { moves, actions }: Pick<Cue, "moves" | "actions">,
  labels: Readonly<Record<string, string>>,
): string {
  const moved = partsInOrder(Object.keys(moves), Object.keys(labels)).map((part) => {
    const { goal = {}, seconds = 0, delay = 0 } = moves[part] ?? {};
    return `${partWords(part, labels)} → ${goalWords(part, goal)} (${seconds} s${late(delay)})`;
  });
  const done = actions.map(({ does, to, what, delay, sound }) =>
    does === "say"
      ? `${labels[to] || to}: ${what === "" ? `sound ${sound}` : `“${what}”`}${late(delay)}`
      : `${does} ${to} ${what}${late(delay)}`,
  );
  return [...moved, ...done].join("; ");
}

/** Seconds until the cue that was called last has ended: its moves on their way, and those that wait yet. */
export function timeLeft({ current, moving, waits }: CueListStatus, cue: Cue | null): number {
  const own = ({ number }: { number: string }): boolean => number === current?.number;
  const arrive = moving.filter(own).map(({ seconds }) => seconds);
  const called = waits.filter(own).map(({ part, seconds }) => seconds + (cue?.moves[part]?.seconds ?? 0));
  return Math.max(0, ...arrive, ...called);
}
