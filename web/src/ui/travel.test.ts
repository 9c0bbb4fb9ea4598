import { describe, expect, it } from "vitest";
import {
  CHANNEL,
  fractionOf,
  HEAD_YAW,
  LATE,
  Spring,
  sprung,
  stepped,
  travelOf,
  valueAt,
  weightAt,
  within,
} from "./travel";

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

/** A direction on air, and all that was sent of it. */
class Direction {
  readonly sent: number[] = [];
  constructor(public onAir: number) {}
  value = (): number => this.onAir;
  nudge = (value: number): void => {
    this.sent.push(value);
    this.onAir = value;
  };
}

/** Frames of a second and a half, from `start`; gives the time after them. */
function run(spring: Spring, start: number, others: { era: number; theirs: boolean }): number {
  let now = start;
  for (; now < start + 1500; now += 16) spring.move(now, others);
  return now;
}

describe("a control with a spring", () => {
  const alone = { era: 0, theirs: false };
  const panicked = { era: 1, theirs: false };

  it("comes to rest once it is let go, and stays where it is under another hand", () => {
    for (const theirs of [false, true]) {
      const [spring, yaw] = [new Spring(), new Direction(0.5)];
      spring.grip(0);
      spring.release([yaw], 0, { era: 0, theirs });
      run(spring, 0, { era: 0, theirs });
      expect(yaw.onAir).toBe(theirs ? 0.5 : 0);
    }
  });

  it("comes to rest too where moves of the hand came after somebody's panic, held or let go by then", () => {
    for (const letGo of ["before", "after"]) {
      const [spring, yaw] = [new Spring(), new Direction(0.5)];
      spring.grip(0);
      if (letGo === "before") spring.release([yaw], 0, alone);
      yaw.onAir = 0; // panic
      spring.move(16, panicked);
      expect(spring.held(1)).toBe(false);
      yaw.onAir = 0.4; // what was on its way came after it
      const now = letGo === "before" ? 16 : run(spring, 16, panicked);
      if (letGo === "after") {
        expect(yaw.sent).toEqual([]); // the hand has it still
        spring.release([yaw], now, panicked);
      }
      spring.move(now + LATE - 1, panicked);
      expect(yaw.sent).toEqual([]); // the panic settles the face by itself
      run(spring, now + LATE, panicked);
      expect(yaw.onAir).toBe(0);
    }
  });

  it("plays nothing after a panic where nothing came: the next panic is to bring the home face", () => {
    const [spring, yaw] = [new Spring(), new Direction(0.5)];
    spring.grip(0);
    yaw.onAir = 0;
    spring.release([yaw], run(spring, 0, panicked), panicked);
    run(spring, 3000, panicked);
    expect(yaw.sent).toEqual([]);
  });

  it("leaves what somebody else has played since the panic, though that hand is gone by now", () => {
    for (const when of ["before it is let go", "on its way"]) {
      const [spring, yaw] = [new Spring(), new Direction(0.5)];
      spring.grip(0);
      spring.move(0, panicked);
      if (when === "on its way") spring.release([yaw], 16, panicked);
      spring.move(32, { era: 1, theirs: true });
      yaw.onAir = 0.3;
      if (when !== "on its way") spring.release([yaw], 48, panicked);
      run(spring, 64, panicked);
      expect([yaw.onAir, yaw.sent]).toEqual([0.3, []]);
    }
  });

  it("goes on from where it is after a lost link, without a jump", () => {
    const [spring, yaw] = [new Spring(), new Direction(0.5)];
    spring.grip(0);
    spring.release([yaw], 0, alone);
    spring.move(0, alone);
    for (let now = 0; now < 2000; now += 16) spring.wait(now);
    spring.move(2000, alone);
    expect(yaw.onAir).toBeGreaterThan(0.3);
  });
});
