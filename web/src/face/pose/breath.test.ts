import { describe, expect, it } from "vitest";
import { Breath } from "./breath";
import { restPose } from "./pose";

const rest = restPose("kaori");

describe("the breath", () => {
  it("leaves a living show alone", () => {
    expect(new Breath().on(rest, false, 1 / 60)).toBe(rest);
  });

  it("rises and falls without a jump and stays small", () => {
    const breath = new Breath();
    let before = 0;
    let moved = 0;
    for (let frame = 0; frame < 1200; frame++) {
      const [, pitch] = breath.on(rest, frame < 600, 1 / 60).head;
      expect(Math.abs(pitch - before)).toBeLessThan(0.0005);
      moved = Math.max(moved, Math.abs(pitch));
      before = pitch;
    }
    expect(moved).toBeGreaterThan(0.005);
    expect(moved).toBeLessThan(0.02);
    expect(before).toBe(0);
  });
});
