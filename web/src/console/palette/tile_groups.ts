/** The tiles of a palette under their headings, and those that a search finds. */

import type { ExpressionDocument, FaceDocument } from "../../link/messages";
import type { PaletteKind } from "../store/arrangement";
import { REGIONS, regionOf } from "../store/channels";

export type PaletteTile = FaceDocument | ExpressionDocument;
/** A heading, empty where there is none, and what stands under it. */
export type TileGroup = readonly [heading: string, tiles: readonly PaletteTile[]];

/** The crew's own, not the built-in cast's. */
export const isOwn = ({ source }: PaletteTile): boolean => source.startsWith("#");

/** Those in whose names, labels, tags, kinds or regions all words occur. */
export function foundIn(all: readonly PaletteTile[], search: string): readonly PaletteTile[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  return all.filter((tile) => words.every((word) => textOf(tile).includes(word)));
}

/** The faces, or the crew's own alone. These come last, so that all others keep their hot keys when one is kept. */
export function faceGroups(faces: readonly FaceDocument[], ownAlone: boolean): readonly TileGroup[] {
  return ownAlone ? [["", ownOf(faces)]] : withOwn(faces.filter(isBuiltIn), ownOf(faces));
}

/** The expressions of a kind; units stand under their regions. */
export function expressionGroups(expressions: readonly ExpressionDocument[], kind: PaletteKind): readonly TileGroup[] {
  const own = ownOf(expressions);
  if (kind === "own") return [["", own]];
  const inside = expressions.filter((expression) => isBuiltIn(expression) && isIn(expression, kind));
  if (kind === "performed") return withOwn(inside, own);
  const regions = REGIONS.map(
    (region) => [region, inside.filter((expression) => regionOf(expression) === region)] as const,
  );
  return regions.filter(([, units]) => units.length > 0);
}

const isBuiltIn = (tile: PaletteTile): boolean => !isOwn(tile);

const isIn = (expression: ExpressionDocument, kind: PaletteKind): boolean =>
  expression.kind === kind || (kind === "performed" && (expression.kind === "neutral" || expression.kind === "omote"));

const ownOf = (all: readonly PaletteTile[]): PaletteTile[] => all.filter(isOwn).sort((a, b) => a.place - b.place);

const withOwn = (others: readonly PaletteTile[], own: readonly PaletteTile[]): readonly TileGroup[] =>
  own.length === 0
    ? [["", others]]
    : [
        ["", others],
        ["Own", own],
      ];

const textOf = (tile: PaletteTile): string =>
  [
    tile.name,
    tile.label,
    ...tile.tags,
    isOwn(tile) ? "own" : "",
    "kind" in tile ? `${tile.kind} ${regionOf(tile)}` : "",
  ]
    .join(" ")
    .toLowerCase();
