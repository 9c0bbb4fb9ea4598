import { describe, expect, it } from "vitest";
import { HairSwing } from "./hair_swing";

const FRAME = 1 / 60;

/** The yaw of the hair against the head while it turns half a radian in a fifth of a second, and for two seconds after. */
function turned(frame = FRAME): number[] {
  const swing = new HairSwing();
  swing.follow([0, 0, 0], 0, true);
  return Array.from({ length: Math.round(2.2 / frame) }, (_, at) => {
    swing.follow([Math.min(0.5, 2.5 * (at + 1) * frame), 0, 0], frame, false);
    return swing.offset.y;
  });
}

describe("hair", () => {
  it("lags behind a head that turns, swings past it and comes to rest", () => {
    const way = turned();
    expect(Math.min(...way)).toBeLessThan(-0.05);
    expect(Math.max(...way)).toBeGreaterThan(0.003);
    expect(Math.max(...way.map(Math.abs))).toBeLessThanOrEqual(0.2 + 1e-9);
    expect(way.at(-1)).toBe(0);
  });

  it("comes to rest over frames of any length", () => {
    for (const frame of [1 / 240, 1 / 30, 0.1]) expect(Math.abs(turned(frame).at(-1) as number)).toBeLessThan(0.01);
  });

  it("hangs still on a head that is put elsewhere, or does not move", () => {
    const swing = new HairSwing();
    swing.follow([1, 0.2, 0.1], FRAME, false);
    expect(swing.still).toBe(true);
    swing.follow([0, 0, 0], FRAME, true);
    expect([swing.still, swing.offset.length()]).toEqual([true, 0]);
  });
});
