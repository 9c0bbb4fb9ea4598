/** Which pads stand under the thumbs: what happens to the pads of the show puts no other pad in a place. */

import type { PadState } from "../../link/messages";
import { inOrder } from "../pads/pad_commands";

/** `names`: of the pad in each place, also of one that is gone; "" where there has been none. */
export type PadPlaces = Readonly<{
  names: readonly string[];
  /** The pads of the show, and the names that were chosen to stand first, when that was so. */
  pads: readonly PadState[];
  chosen: readonly string[];
}>;
export const NO_PLACES: PadPlaces = { names: ["", ""], pads: [], chosen: [] };

/** The places once the pads of the show are `pads` and those that stand first are `chosen`, of a layout for example. */
export function placesAfter(before: PadPlaces, pads: readonly PadState[], chosen: readonly string[]): PadPlaces {
  if (pads === before.pads && chosen === before.chosen) return before;
  const others = chosen !== before.chosen && JSON.stringify(chosen) !== JSON.stringify(before.chosen);
  const renamed = renames(before.pads, pads);
  const nameNow = (name: string): string => renamed.get(name) ?? name;
  const kept = before.names.map((name) => (others ? "" : nameNow(name)));
  const free = inOrder(pads, chosen).flatMap(({ name }) => (kept.includes(name) ? [] : [name]));
  const names = kept.map((name) => name || (free.shift() ?? ""));
  return { names, pads, chosen: chosen.some((name) => renamed.has(name)) ? chosen.map(nameNow) : chosen };
}

/** Puts a pad in a place; where another place has it, they change places. */
export function withChosen(before: PadPlaces, at: number, name: string): PadPlaces {
  const { pads } = before;
  const was = before.names[at] as string;
  const names = before.names.map((each, place) => (place === at ? name : each === name ? was : each));
  const left = inOrder(pads, before.chosen).filter((pad) => !names.includes(pad.name));
  const others = left.filter((pad) => before.chosen.includes(pad.name)).map((pad) => pad.name);
  return { names, pads, chosen: [...names.filter((each) => each !== ""), ...others] };
}

/** Which pads have another name now: those that are as they were in all else, in the same place of the list. */
function renames(before: readonly PadState[], after: readonly PadState[]): ReadonlyMap<string, string> {
  const none = new Map<string, string>();
  if (before.length !== after.length) return none;
  const [old, now] = [before, after].map((pads) => new Set(pads.map(({ name }) => name)));
  const renamed = new Map<string, string>();
  for (const [at, pad] of before.entries()) {
    const next = after[at] as PadState;
    if (next.name === pad.name) continue;
    const same = JSON.stringify({ ...next, name: "" }) === JSON.stringify({ ...pad, name: "" });
    if (!same || old?.has(next.name) || now?.has(pad.name)) return none;
    renamed.set(pad.name, next.name);
  }
  return renamed;
}
