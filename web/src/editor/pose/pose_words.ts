/** The numbers of a pose's recipe: what people call them, how far joints go, and how they are read and written. */

import type { PoseRecipe } from "../../link/editing_messages";

/** One number of a recipe. `path`: where it stands; `low`, `high`: how far a joint goes, degrees, leg lengths or shares. */
export interface Word {
  readonly label: string;
  readonly path: readonly (string | number)[];
  readonly low: number;
  readonly high: number;
  readonly unit: "degrees" | "legs" | "share";
}

const degrees = (label: string, low: number, high: number, ...path: Word["path"]): Word => ({
  label,
  path,
  low,
  high,
  unit: "degrees",
});
const legs = (label: string, low: number, high: number, ...path: Word["path"]): Word => ({
  label,
  path,
  low,
  high,
  unit: "legs",
});

const armWords = (side: "left" | "right"): readonly Word[] => [
  degrees("Raised", -60, 180, side, "raised"),
  degrees("Spread", -40, 180, side, "spread"),
  degrees("Twist inward", -90, 100, side, "twist"),
  degrees("Elbow", 0, 150, side, "elbow"),
  degrees("Forearm", -90, 120, side, "forearm"),
  degrees("Wrist to palm", -80, 80, side, "wrist", 0),
  degrees("Wrist to thumb", -35, 25, side, "wrist", 1),
  degrees("Shrug", -10, 35, side, "shrug"),
  degrees("Reach", -25, 35, side, "reach"),
  ...["Thumb", "Index", "Middle", "Ring", "Little"].map(
    (label, at): Word => ({ label, path: [side, "curls", at], low: -0.2, high: 1, unit: "share" }),
  ),
  { label: "Fingers apart", path: [side, "fan"], low: -0.5, high: 1, unit: "share" },
];

const legWords = (leg: "left_leg" | "right_leg"): readonly Word[] => [
  legs("Foot outward", -1, 1.2, leg, "at", 0),
  legs("Foot up", -0.2, 1.2, leg, "at", 1),
  legs("Foot ahead", -1, 1.2, leg, "at", 2),
  degrees("Toes up", -60, 45, leg, "foot", 0),
  degrees("Points outward", -60, 90, leg, "foot", 1),
  degrees("Inner edge up", -40, 40, leg, "foot", 2),
  degrees("Knee outward", -60, 90, leg, "knee"),
  degrees("Toes bend", -40, 60, leg, "toes"),
];

/** All words under what they are of, in the order in which people read a figure. */
export const WORDS: readonly (readonly [string, readonly Word[]])[] = [
  [
    "Head",
    [
      degrees("Forward", -50, 50, "head", 0),
      degrees("Turn left", -80, 80, "head", 1),
      degrees("Lean left", -45, 45, "head", 2),
    ],
  ],
  [
    "Trunk",
    [
      degrees("Forward", -35, 95, "trunk", 0),
      degrees("Turn left", -70, 70, "trunk", 1),
      degrees("Lean left", -45, 45, "trunk", 2),
    ],
  ],
  ["Left arm", armWords("left")],
  ["Right arm", armWords("right")],
  [
    "Hips",
    [
      legs("To the left", -1, 1, "hips", 0),
      legs("Up", -1, 0.3, "hips", 1),
      legs("Ahead", -1, 1, "hips", 2),
      degrees("Forward", -60, 90, "turn", 0),
      degrees("Turn left", -180, 180, "turn", 1),
      degrees("Lean left", -60, 60, "turn", 2),
    ],
  ],
  ["Left leg", legWords("left_leg")],
  ["Right leg", legWords("right_leg")],
];

/** The word that stands at a place. */
export function wordAt(...path: Word["path"]): Word {
  const found = WORDS.flatMap(([, words]) => words).find((word) => word.path.join() === path.join());
  if (found === undefined) throw new Error(`A pose has no "${path.join(".")}".`);
  return found;
}

type Branch = Record<string | number, unknown>;

/** What a recipe has there. */
export const readWord = (recipe: PoseRecipe, { path }: Word): number =>
  path.reduce<unknown>((branch, key) => (branch as Branch)[key], recipe) as number;

/** A recipe with another number there, as far as the joint goes. */
export function writeWord(recipe: PoseRecipe, { path, low, high }: Word, value: number): PoseRecipe {
  const put = (branch: unknown, [key, ...rest]: Word["path"]): unknown => {
    const copy = (Array.isArray(branch) ? [...branch] : { ...(branch as Branch) }) as Branch;
    copy[key as string] = rest.length === 0 ? Math.min(high, Math.max(low, value)) : put(copy[key as string], rest);
    return copy;
  };
  return put(recipe, path) as PoseRecipe;
}

const OTHER: Readonly<Record<string, keyof PoseRecipe>> = {
  left: "right",
  right: "left",
  left_leg: "right_leg",
  right_leg: "left_leg",
};

/** A recipe whose other side does what the side of `part` does; as it is where `part` has none. */
export function alike(recipe: PoseRecipe, part: string | number | undefined): PoseRecipe {
  const other = OTHER[part ?? ""];
  return other === undefined ? recipe : { ...recipe, [other]: recipe[part as keyof PoseRecipe] };
}

/** The mirror image of a recipe. */
export function mirrored(recipe: PoseRecipe): PoseRecipe {
  const across = ([forward, left, lean]: PoseRecipe["turn"]): PoseRecipe["turn"] => [forward, 0 - left, 0 - lean];
  const [left, up, ahead] = recipe.hips;
  return {
    ...recipe,
    hips: [0 - left, up, ahead],
    turn: across(recipe.turn),
    trunk: across(recipe.trunk),
    head: across(recipe.head),
    left: recipe.right,
    right: recipe.left,
    left_leg: recipe.right_leg,
    right_leg: recipe.left_leg,
  };
}
