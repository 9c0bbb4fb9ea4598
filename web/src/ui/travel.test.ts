import { describe, expect, it } from "vitest";
import { CHANNEL, fractionOf, HEAD_YAW, sprung, stepped, travelOf, valueAt, weightAt, within } from "./travel";

const travels = Array.from({ length: 201 }, (_, index) => CHANNEL.low + index * 0.01);

describe("the travel of a channel's fader", () => {
  it("reaches both ends of the range and rests on 0 and on 1", () => {
    expect(weightAt(CHANNEL.low)).toBeCloseTo(CHANNEL.low, 12);
    expect(weightAt(CHANNEL.high)).toBeCloseTo(CHANNEL.high, 12);
    for (const near of [-0.03, 0, 0.03]) {
      expect(weightAt(near)).toBe(0);
      expect(weightAt(1 + near)).toBe(1);
    }
  });

  it("never falls and never jumps", () => {
    for (let index = 1; index < travels.length; index++) {
      const step = weightAt(travels[index] as number) - weightAt(travels[index - 1] as number);
      expect(step).toBeGreaterThanOrEqual(0);
      expect(step).toBeLessThan(0.012);
    }
  });

  it("gives every weight back from its travel", () => {
    for (const weight of travels) expect(weightAt(travelOf(weight))).toBeCloseTo(weight, 12);
  });
});

describe("ranges", () => {
  it("are walked both ways", () => {
    for (const value of [-0.8, -0.3, 0, 0.8])
      expect(valueAt(fractionOf(value, HEAD_YAW), HEAD_YAW)).toBeCloseTo(value, 12);
    expect(fractionOf(0, CHANNEL)).toBe(0.25);
    expect(fractionOf(1, CHANNEL)).toBe(0.75);
  });

  it("hold a hand inside", () => {
    expect(within(9, CHANNEL)).toBe(1.5);
    expect(within(-9, CHANNEL)).toBe(-0.5);
    expect(within(0.2, CHANNEL)).toBe(0.2);
  });
});

describe("a step", () => {
  it("rests on a stop that it would cross, then goes on", () => {
    expect(stepped(0.98, 0.05, CHANNEL, [0, 1])).toBe(1);
    expect(stepped(1, 0.05, CHANNEL, [0, 1])).toBe(1.05);
    expect(stepped(0.02, -0.05, CHANNEL, [0, 1])).toBe(0);
    expect(stepped(0, -0.05, CHANNEL, [0, 1])).toBe(-0.05);
  });

  it("stays in its range and is never minus zero", () => {
    expect(stepped(1.48, 0.05, CHANNEL)).toBe(1.5);
    expect(Object.is(stepped(0.05, -0.05, CHANNEL), 0)).toBe(true);
  });
});

describe("a spring", () => {
  it("comes closer with time, from either side, and arrives at exactly nothing", () => {
    expect(sprung(0.5, 16)).toBeLessThan(0.5);
    expect(sprung(-0.5, 16)).toBeCloseTo(-sprung(0.5, 16), 12);
    expect(sprung(0.5, 10_000)).toBe(0);
    expect(sprung(sprung(0.5, 16), 16)).toBeCloseTo(sprung(0.5, 32), 12);
  });
});
