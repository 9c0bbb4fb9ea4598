import { describe, expect, it } from "vitest";
import type { Vector } from "../../face/figure/rotations";
import type { PoseRecipe } from "../../link/editing_messages";
import { GRIPS, type Grip, reach } from "./pose_grips";
import { alike, mirrored, readWord, WORDS, writeWord } from "./pose_words";

const arm = (): PoseRecipe["left"] => ({
  raised: 0,
  spread: 0,
  twist: 0,
  elbow: 0,
  forearm: 0,
  wrist: [0, 0],
  shrug: 0,
  reach: 0,
  curls: [0, 0, 0, 0, 0],
  fan: 0,
});
const leg = (): PoseRecipe["left_leg"] => ({ at: [0, 0, 0], foot: [0, 0, 0], knee: 0, toes: 0 });
const STAND: PoseRecipe = {
  kind: "pose",
  hips: [0, 0, 0],
  turn: [0, 0, 0],
  trunk: [0, 0, 0],
  head: [0, 0, 0],
  left: arm(),
  right: arm(),
  left_leg: leg(),
  right_leg: leg(),
};
const gripOf = (name: string): Grip => GRIPS.find((grip) => grip.name === name) as Grip;
const ALL_WORDS = WORDS.flatMap(([, words]) => words);

/** An arm of two bones of 0.3 m in a plane, raised ahead and bent at the elbow; spread moves it aside. */
const hand = ({ left }: PoseRecipe): Vector => {
  const [up, bent] = [left.raised, left.raised + left.elbow].map((angle) => (angle * Math.PI) / 180) as [
    number,
    number,
  ];
  return [left.spread / 100, -0.3 * (Math.cos(up) + Math.cos(bent)), 0.3 * (Math.sin(up) + Math.sin(bent))];
};

describe("words of a pose", () => {
  it("are written where they are read, within the joint's limits, and nowhere else", () => {
    for (const word of ALL_WORDS) {
      const changed = writeWord(STAND, word, word.high + 1);
      expect(readWord(changed, word)).toBe(word.high);
      expect(writeWord(changed, word, readWord(STAND, word))).toEqual(STAND);
    }
  });

  it("mirrored twice are the same, and sides alike are their own mirror image", () => {
    const some = ALL_WORDS.reduce((recipe, word, at) => writeWord(recipe, word, word.low + at * 0.01), STAND);
    expect(mirrored(mirrored(some))).toEqual(some);
    const both = alike(writeWord(STAND, ALL_WORDS.find(({ path }) => path[0] === "left") as never, 40), "left");
    expect(mirrored(both)).toEqual(both);
  });
});

describe("a grip", () => {
  it("comes to where a joint can bring it", () => {
    const grip = gripOf("left hand");
    const wanted = { ...STAND, left: { ...arm(), raised: 60, elbow: 50, spread: 12 } };
    const target = hand(wanted);
    const begun = { ...STAND, left: { ...arm(), raised: 30, elbow: 30 } };
    const reached = [0, 1, 2, 3].reduce((recipe) => reach(recipe, grip, target, hand), begun);
    expect(Math.hypot(...hand(reached).map((part, axis) => part - (target[axis] as number)))).toBeLessThan(0.002);
  });

  it("that is pulled too far turns no joint beyond its limits, and no joint of others", () => {
    const grip = gripOf("left hand");
    const reached = reach(STAND, grip, [5, 5, 5], hand);
    for (const word of grip.words) {
      expect(readWord(reached, word)).toBeGreaterThanOrEqual(word.low);
      expect(readWord(reached, word)).toBeLessThanOrEqual(word.high);
    }
    expect({ ...reached, left: STAND.left }).toEqual(STAND);
  });
});
