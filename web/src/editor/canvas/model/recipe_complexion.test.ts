import { expect, it } from "vitest";
import type { Recipe } from "../../../link/editing_messages";
import type { Manifest } from "../../../link/messages";
import { complexionOfRecipe } from "./recipe_complexion";

const manifest = { expressions: [{ source: "cry", complexion: [0.5, 1, 0.2, 1, 0.1, 1, 0.4] }] } as unknown as Manifest;
const recipe = (region: string | null, muted = false): Recipe =>
  ({ layers: [{ source: "cry", label: "Cry", weight: 0.5, region, muted }] }) as unknown as Recipe;

it("adds up what layers bring and what the hand sets", () => {
  expect(complexionOfRecipe(recipe(null), [0.1, 0, 0, 0, 0, 0, 0], manifest)).toEqual([
    0.35, 0.5, 0.1, 0.5, 0.05, 0.5, 0.2,
  ]);
});

it("takes of a layer on one region what belongs to that, and nothing of a muted one", () => {
  expect(complexionOfRecipe(recipe("eyes"), [], manifest)).toEqual([0, 0, 0, 0.5, 0, 0.5, 0]);
  expect(complexionOfRecipe(recipe("mouth"), [], manifest)).toEqual([0, 0, 0, 0, 0, 0, 0]);
  expect(complexionOfRecipe(recipe(null, true), [], manifest)).toEqual([0, 0, 0, 0, 0, 0, 0]);
});

it("is as at rest without a recipe", () => {
  expect(complexionOfRecipe(null, [1, 1, 1, 1, 1, 1, 1], manifest)).toEqual([0, 0, 0, 0, 0, 0, 0]);
});
