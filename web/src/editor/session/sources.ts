/** What layers and new things can be made from: own items that were saved, then the built-in cast. */

import { KEY } from "../../link/assets";
import { IDLE_POSES } from "../../link/constants";
import type { DraftStore } from "./draft_store";
import type { Kind } from "./item_commands";
import { ordered } from "./item_commands";

export interface ListedSource {
  readonly source: string;
  readonly label: string;
  readonly group: string;
}

/** The group of what people made. */
export const OWN = "Own";

const GROUPS: Readonly<Record<string, string>> = {
  performed: "Performed",
  arkit: "ARKit",
  makehuman: "MakeHuman",
  omote: "Omote",
};

export function sourcesOf(store: DraftStore, kind: Kind): ListedSource[] {
  const own = ordered(store.items, kind)
    .filter(({ deleted, content }) => !deleted && content !== "")
    .map(({ content, label }) => ({ source: content, label, group: OWN }));
  return [...own, ...BUILT_IN[kind](store)];
}

const facesOf = (store: DraftStore): ListedSource[] =>
  (store.manifest?.faces ?? [])
    .filter(({ source }) => !source.startsWith("#"))
    .map(({ source, label }) => ({ source, label, group: "Faces" }));

const expressionsOf = (store: DraftStore): ListedSource[] =>
  (store.manifest?.expressions ?? [])
    .filter(({ kind }) => kind !== "neutral" && kind !== "own")
    .map(({ source, label, kind }) => ({ source, label, group: GROUPS[kind] ?? kind }));

const posesOf = (store: DraftStore): ListedSource[] => {
  const own = new Set<string>([...IDLE_POSES, ...store.items.map(({ name }) => name)]); // or what figures do by themselves
  return (store.manifest?.figures?.poses ?? [])
    .filter(({ name }) => !own.has(name))
    .map(({ name, label }) => ({ source: name, label, group: "Poses" }));
};

const BUILT_IN: Readonly<Record<Kind, (store: DraftStore) => ListedSource[]>> = {
  face: facesOf,
  expression: expressionsOf,
  pose: posesOf,
};

/** What people read of a source, of one that was deleted too; a content that nobody has is what came in from a file. */
export function labelOf(sources: readonly ListedSource[], source: string, items: DraftStore["items"] = []): string {
  const label = sources.find((listed) => listed.source === source)?.label;
  const gone = items.find(({ deleted, content }) => deleted && content === source);
  if (label === undefined && gone !== undefined) return `${gone.label} (deleted)`;
  return label ?? (source.startsWith(KEY) ? "What came in" : source);
}

/** Sources under their groups, in order. */
export function grouped(sources: readonly ListedSource[]): [string, ListedSource[]][] {
  const groups = new Map<string, ListedSource[]>();
  for (const source of sources) groups.set(source.group, [...(groups.get(source.group) ?? []), source]);
  return [...groups];
}
