/** Handles of a face: what stands where, which move together, and how far a pointer moves them. */

import { decode } from "@msgpack/msgpack";
import { type Fetch, fetchBytes, fetchWithRetry } from "../../link/assets";
import type { FaceRecipe, HandlesAsset } from "../../link/editing_messages";
import type { Vector } from "./control_net";

/** The handles of a face under work; all lists by place. */
export interface Handles {
  /** Rows of the skin that they stand on. */
  readonly rows: readonly number[];
  readonly labels: readonly string[];
  /** The place of each one's mirror image, its own on the midline, -1 for none. */
  readonly mirror: readonly number[];
  /** How far the recipe moves them, (n, 3) metres. */
  readonly moves: Float64Array;
}

/** The handles of the head, from the server. */
export async function loadHandles(read: Fetch = fetchBytes): Promise<HandlesAsset> {
  return decode(await fetchWithRetry("/handles", read)) as HandlesAsset;
}

/** A recipe's handles: the head's own, all at rest, where it has none yet; else those that it names. */
export function handlesOf(asset: HandlesAsset, recipe: Pick<FaceRecipe, "points" | "moves">): Handles {
  const rows = recipe.points.length === 0 ? asset.points : recipe.points;
  const places = rows.map((row) => asset.points.indexOf(row));
  return {
    rows,
    labels: places.map((place, at) => asset.labels[place] ?? `handle ${at + 1}`),
    mirror: places.map((place) => rows.indexOf(asset.points[asset.mirror[place] ?? -1] ?? -1)),
    moves: Float64Array.from(rows.flatMap((_, place) => recipe.moves[place] ?? [0, 0, 0])),
  };
}

/** The recipe with its handles moved; those at rest stay in it, for the others hold on to them. */
export const withMoves = (recipe: FaceRecipe, { rows }: Handles, moves: Float64Array): FaceRecipe => ({
  ...recipe,
  points: [...rows],
  moves: rows.map((_, place): Vector => [0, 1, 2].map((axis) => moves[3 * place + axis]) as Vector),
});

/** The moves (n, 3) after a hand has moved some places by `by`, metres; with `mirrored` their images move likewise. */
export function movedBy(
  before: Float64Array,
  { mirror }: Handles,
  places: readonly number[],
  by: Readonly<Vector>,
  mirrored: boolean,
): Float64Array {
  const after = before.slice();
  const held = new Set(places);
  for (const place of held) {
    const image = mirror[place] ?? -1;
    const stays = mirrored && image === place; // on the midline: nothing to a side
    addTo(after, place, [stays ? 0 : by[0], by[1], by[2]]);
    if (mirrored && image >= 0 && image !== place && !held.has(image)) addTo(after, image, [-by[0], by[1], by[2]]);
  }
  return after;
}

/** What a history says of a move of some handles. */
export function namesOf({ labels }: Handles, places: readonly number[]): string {
  const [first, ...others] = places.map((place) => labels[place] ?? "");
  return others.length === 0 ? `${first}` : `${first} and ${others.length} more`;
}

function addTo(moves: Float64Array, place: number, by: Readonly<Vector>): void {
  for (const axis of [0, 1, 2] as const) moves[3 * place + axis] = (moves[3 * place + axis] as number) + by[axis];
}
