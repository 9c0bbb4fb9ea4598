/** The blood, tears and sweat that a recipe adds up to. */

import { COMPLEXION, COMPLEXION_OF_REGION } from "../../../link/constants";
import type { Recipe } from "../../../link/editing_messages";
import type { Manifest } from "../../../link/messages";

const PARTS = Object.keys(COMPLEXION);
const OF_REGION: Readonly<Record<string, readonly string[]>> = COMPLEXION_OF_REGION;

/** What layers bring, with what the hand sets now (seven numbers), as far as the cast's documents tell. */
export function complexionOfRecipe(
  recipe: Recipe | null,
  hand: readonly number[],
  manifest: Pick<Manifest, "expressions">,
): readonly number[] {
  const layers = recipe?.layers.filter(({ muted }) => !muted) ?? [];
  const brought = layers.map(({ source, weight, region }) => {
    const own = manifest.expressions.find((candidate) => candidate.source === source)?.complexion ?? [];
    const parts = region === null ? PARTS : (OF_REGION[region] ?? []);
    return PARTS.map((part, at) => (parts.includes(part) ? weight * (own[at] ?? 0) : 0));
  });
  return PARTS.map((_, at) => [recipe === null ? [] : hand, ...brought].reduce((sum, own) => sum + (own[at] ?? 0), 0));
}
