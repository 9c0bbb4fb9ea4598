/** Poses and bodies as an operator calls them on the characters that are played here. */

import { FACES_OWN } from "../../link/constants";
import type { CharacterState, PoseDocument } from "../../link/messages";
import { STAND } from "../store/axis";
import type { ConsoleStore } from "../store/console_store";

/** The poses of the show's cast, but the stand at the front of them. */
export function posesFound(store: ConsoleStore, search: string): readonly PoseDocument[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  const found = store.poses.filter(({ name, label }) =>
    words.every((word) => `${name} ${label}`.toLowerCase().includes(word)),
  );
  return [...found].sort((one, other) => Number(other.name === STAND) - Number(one.name === STAND));
}

/** The names of the bodies that can be worn, "own" those of the faces on air first. */
export const bodiesOf = (store: ConsoleStore): readonly string[] => [
  FACES_OWN,
  ...(store.manifest?.figures?.bodies ?? []).map(({ name }) => name),
];

/** Calls a body in the seconds of a face. */
export function callBody(store: ConsoleStore, name: string): void {
  const { seconds, easing } = store.timing.face;
  for (const character of store.played.targets) store.ask({ type: "call_body", character, name, seconds, easing });
}

/** How much of a pose a character does: in the whole, or most where a region alone does it. */
export function poseWeight(air: CharacterState | null, name: string): number {
  const figure = air?.figure;
  if (!figure) return name === STAND && air !== null ? 1 : 0;
  return Math.max(figure.poses[name] ?? 0, ...Object.values(figure.regions).map((mix) => mix?.[name] ?? 0));
}

/** The poses that are called now. */
export function posesComing(air: CharacterState | null): ReadonlySet<string> {
  const figure = air?.figure;
  const calls = figure ? [figure.pose_call, ...Object.values(figure.region_calls)] : [];
  return new Set(calls.flatMap((call) => (call ? [call.target] : [])));
}

/** The body that is called, else the one that weighs most. */
export function bodyOf(air: CharacterState | null): string {
  const figure = air?.figure;
  if (!figure) return FACES_OWN;
  const [heaviest] = Object.entries(figure.bodies).sort(([, weight], [, other]) => other - weight);
  return figure.body_call?.target ?? heaviest?.[0] ?? FACES_OWN;
}
