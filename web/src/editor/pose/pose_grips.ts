/** What a hand takes hold of on a figure, and how the recipe follows it: inverse kinematics in the recipe's own words. */

import { minus, type Vector } from "../../face/figure/rotations";
import type { PoseRecipe } from "../../link/editing_messages";
import { readWord, type Word, wordAt, writeWord } from "./pose_words";

/** A grip: the bone at whose beginning it lies, how far from there along the bone's own axes (metres), what it moves. */
export interface Grip {
  readonly name: string;
  readonly label: string;
  readonly bone: string;
  readonly offset: Vector;
  readonly words: readonly Word[];
}

/** Above the crown, so that nothing lies over the face. */
const OVER_HEAD: Vector = [0, 0.27, 0];

const sided = (side: "left" | "right"): readonly Grip[] => {
  const [end, leg] = side === "left" ? ([".L", "left_leg"] as const) : ([".R", "right_leg"] as const);
  const arm = ["raised", "spread", "twist", "elbow"].map((word) => wordAt(side, word));
  const grip = (name: string, bone: string, words: readonly Word[]): Grip => ({
    name: `${side} ${name}`,
    label: `${side === "left" ? "Left" : "Right"} ${name}`,
    bone: bone + end,
    offset: [0, 0, 0],
    words,
  });
  return [
    grip("hand", "wrist", arm),
    grip("elbow", "lowerarm01", arm.slice(0, 2)),
    grip(
      "foot",
      "foot",
      [0, 1, 2].map((axis) => wordAt(leg, "at", axis)),
    ),
  ];
};

export const GRIPS: readonly Grip[] = [
  {
    name: "head",
    label: "Head",
    bone: "head",
    offset: OVER_HEAD,
    words: [wordAt("head", 0), wordAt("head", 2), wordAt("trunk", 0), wordAt("trunk", 2)],
  },
  {
    name: "hips",
    label: "Hips",
    bone: "root",
    offset: [0, 0, 0],
    words: [0, 1, 2].map((axis) => wordAt("hips", axis)),
  },
  ...sided("left"),
  ...sided("right"),
];

const ROUNDS = 6;
/** Steps of a word by which its effect is measured, and in which its way is counted: an arm's sixty degrees are as far as
 * half a leg. */
const UNITS = { degrees: 60, legs: 0.5, share: 1 } as const;
const STEP = 1e-3;
/** Metres: a grip that cannot be reached is left before joints turn for nothing. */
const DAMPING = 0.04;

/**
 * The recipe with which a grip comes to `target`, or as near as its joints go; `placeIn`: where the grip lies in a recipe.
 *
 * Damped least squares over the words of the grip, so that joints keep to their limits and to where they were (C. W.
 * Wampler, Manipulator inverse kinematic solutions based on vector formulations and damped least-squares methods, 1986).
 */
export function reach(
  recipe: PoseRecipe,
  { words }: Grip,
  target: Vector,
  placeIn: (recipe: PoseRecipe) => Vector,
): PoseRecipe {
  let now = recipe;
  for (let round = 0; round < ROUNDS; round++) {
    const at = placeIn(now);
    const miss = minus(target, at);
    const slopes = words.map((word): Vector => {
      const by = UNITS[word.unit] * STEP;
      const value = readWord(now, word);
      const step = value + by > word.high ? -by : by;
      const moved = minus(placeIn(writeWord(now, word, value + step)), at);
      return moved.map((part) => (part / step) * UNITS[word.unit]) as unknown as Vector;
    });
    const pull = solveDamped(slopes, miss);
    for (const [number, word] of words.entries()) {
      const slope = slopes[number] as Vector;
      const by = slope[0] * pull[0] + slope[1] * pull[1] + slope[2] * pull[2];
      now = writeWord(now, word, readWord(now, word) + by * UNITS[word.unit]);
    }
  }
  return now;
}

/** x of (sum of s s' + damping) x = miss, by Cramer's rule. */
function solveDamped(slopes: readonly Vector[], miss: Vector): Vector {
  const entry = (row: 0 | 1 | 2, column: 0 | 1 | 2): number =>
    slopes.reduce((sum, slope) => sum + slope[row] * slope[column], row === column ? DAMPING ** 2 : 0);
  const columns = ([0, 1, 2] as const).map(
    (column) => [entry(0, column), entry(1, column), entry(2, column)] as Vector,
  );
  const [a, b, c] = columns as [Vector, Vector, Vector];
  const whole = volume(a, b, c);
  return [volume(miss, b, c) / whole, volume(a, miss, c) / whole, volume(a, b, miss) / whole];
}

const volume = (a: Vector, b: Vector, c: Vector): number =>
  a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
