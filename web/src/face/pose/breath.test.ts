import { describe, expect, it } from "vitest";
import { Breath } from "./breath";
import { restPose } from "./pose";
import { alone, FRONT } from "./scene_pose";

const rest = alone(restPose("kaori"), "one");
const two = { ...rest, characters: { ...rest.characters, two: { ...restPose("old"), place: FRONT, presence: 1 } } };

describe("the breath", () => {
  it("leaves a living show alone", () => {
    expect(new Breath().on(rest, false, 1 / 60)).toBe(rest);
  });

  it("rises and falls without a jump and stays small, each head in its own time", () => {
    const breath = new Breath();
    let before = [0, 0];
    let [moved, apart] = [0, 0];
    for (let frame = 0; frame < 1200; frame++) {
      const { characters } = breath.on(two, frame < 600, 1 / 60);
      const pitches = ["one", "two"].map((name) => characters[name]?.head[1] as number);
      pitches.forEach((pitch, at) => {
        expect(Math.abs(pitch - (before[at] as number))).toBeLessThan(0.0005);
      });
      moved = Math.max(moved, ...pitches.map(Math.abs));
      apart = Math.max(apart, Math.abs((pitches[0] as number) - (pitches[1] as number)));
      before = pitches;
    }
    expect(moved).toBeGreaterThan(0.005);
    expect(apart).toBeGreaterThan(0.005);
    expect(moved).toBeLessThan(0.02);
    expect(before).toEqual([0, 0]);
  });
});
