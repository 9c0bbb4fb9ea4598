/** The tiles of a palette under their headings, and those that a search finds. */

import type { ExpressionDocument, FaceDocument } from "../../link/messages";
import { REGIONS, regionOf } from "../store/channels";
import type { PaletteKind } from "../store/console_layout";

export type Tile = FaceDocument | ExpressionDocument;
/** A heading, empty where there is none, and what stands under it. */
export type TileGroup = readonly [heading: string, tiles: readonly Tile[]];

/** The crew's own, not the built-in cast's. */
export const isOwn = ({ source }: Tile): boolean => source.startsWith("#");

/** Those in whose names, labels, tags, kinds or regions all words occur. */
export function foundIn(all: readonly Tile[], search: string): readonly Tile[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  return all.filter((one) => words.every((word) => textOf(one).includes(word)));
}

/** The faces, or the crew's own alone. These come last, so that all others keep their hot keys when one is kept. */
export function faceGroups(faces: readonly FaceDocument[], ownAlone: boolean): readonly TileGroup[] {
  return ownAlone ? [["", ownOf(faces)]] : withOwn(faces.filter(isBuiltIn), ownOf(faces));
}

/** The expressions of a kind; units stand under their regions. */
export function expressionGroups(expressions: readonly ExpressionDocument[], kind: PaletteKind): readonly TileGroup[] {
  const own = ownOf(expressions);
  if (kind === "own") return [["", own]];
  const inside = expressions.filter((one) => isBuiltIn(one) && isIn(one, kind));
  if (kind === "performed") return withOwn(inside, own);
  const regions = REGIONS.map((region) => [region, inside.filter((one) => regionOf(one) === region)] as const);
  return regions.filter(([, units]) => units.length > 0);
}

const isBuiltIn = (one: Tile): boolean => !isOwn(one);

const isIn = (one: ExpressionDocument, kind: PaletteKind): boolean =>
  one.kind === kind || (kind === "performed" && (one.kind === "neutral" || one.kind === "omote"));

const ownOf = (all: readonly Tile[]): Tile[] => all.filter(isOwn).sort((a, b) => a.place - b.place);

const withOwn = (others: readonly Tile[], own: readonly Tile[]): readonly TileGroup[] =>
  own.length === 0
    ? [["", others]]
    : [
        ["", others],
        ["Own", own],
      ];

const textOf = (one: Tile): string =>
  [one.name, one.label, ...one.tags, isOwn(one) ? "own" : "", "kind" in one ? `${one.kind} ${regionOf(one)}` : ""]
    .join(" ")
    .toLowerCase();
