import { describe, expect, it } from "vitest";
import { ECHO, HeldValues } from "./held_values";

const LATER = 1e9;

it("shows the server's value while nobody touches", () => {
  expect(new HeldValues<number>().read("jaw", 0.3, 0)).toBe(0.3);
});

it("shows the hand's value as long as the hand is on it, whatever the server says", () => {
  const holds = new HeldValues<number>();
  holds.grip("jaw", 0.7);
  expect(holds.read("jaw", 0.1, LATER)).toBe(0.7);
  expect(holds.gripped("jaw")).toBe(true);
  expect(holds.read("smile", 0.1, LATER)).toBe(0.1);
});

it("keeps the hand's value for a moment after it let go, then follows: the last touch wins", () => {
  const holds = new HeldValues<number>();
  holds.grip("jaw", 0.7);
  holds.leave("jaw", 1000);
  expect(holds.gripped("jaw")).toBe(false);
  expect(holds.read("jaw", 0.1, 1000 + ECHO - 1)).toBe(0.7);
  expect(holds.read("jaw", 0.1, 1000 + ECHO)).toBe(0.1);
});

it("does not let go of a grip because a key steps it", () => {
  const holds = new HeldValues<number>();
  holds.grip("jaw", 0.7);
  holds.nudge("jaw", 0.8, 0);
  expect(holds.read("jaw", 0.1, LATER)).toBe(0.8);
});

it("gives a nudged value back a moment after it was sent, however long the page took to send it", () => {
  const holds = new HeldValues<number>();
  holds.nudge("jaw", 0.8, 50);
  expect(holds.read("jaw", 0.1, LATER)).toBe(0.8);
  expect(holds.counts("jaw", LATER)).toBe(true);
  holds.sent(LATER);
  expect(holds.read("jaw", 0.1, LATER + ECHO - 1)).toBe(0.8);
  holds.sent(LATER + ECHO - 1); // what was sent already is not sent again
  expect(holds.read("jaw", 0.1, LATER + ECHO)).toBe(0.1);
  expect(holds.counts("jaw", LATER + ECHO)).toBe(false);
});

describe("steps by keys over a slow link", () => {
  const LAG = 1000;
  /** Twenty steps, a third of a second apart; the server's answer to each comes `LAG` later. */
  function steps(holds: HeldValues<number>): number {
    const asked: [number, number][] = [];
    for (let step = 0; step < 20; step++) {
      const now = 10_000 + step * 350;
      const said = asked.filter(([time]) => time + LAG <= now).at(-1)?.[1] ?? 0;
      const value = holds.stepFrom("bar", said, now) + 1;
      holds.nudge("bar", value, now);
      holds.sent(now);
      holds.read("bar", said, now);
      asked.push([now, value]);
    }
    return asked.at(-1)?.[1] as number;
  }

  it("are all taken", () => {
    expect(steps(new HeldValues())).toBe(20);
  });

  it("begin anew from what the server says otherwise", () => {
    const holds = new HeldValues<number>();
    holds.nudge("bar", holds.stepFrom("bar", 0, 0) + 1, 0);
    holds.sent(0);
    expect(holds.stepFrom("bar", 7, 2 * ECHO)).toBe(7);
  });

  it("do not begin from what was answered once the server has gone back to what was before", () => {
    const holds = new HeldValues<number>();
    holds.nudge("bar", holds.stepFrom("bar", 0, 0) + 1, 0);
    holds.sent(0);
    holds.read("bar", 1, 400);
    expect(holds.stepFrom("bar", 0, 800)).toBe(0);
  });

  it("do not begin from what was asked long ago and never answered, nor from what a panic ended", () => {
    const holds = new HeldValues<number>();
    holds.nudge("bar", holds.stepFrom("bar", 0, 0) + 1, 0);
    holds.sent(0);
    expect(holds.stepFrom("bar", 0, 5000)).toBe(0);
    holds.nudge("bar", 1, 5000);
    holds.clear();
    expect(holds.stepFrom("bar", 0, 5001)).toBe(0);
  });
});

it("has nothing to hold after all hands are off", () => {
  const holds = new HeldValues<number>();
  holds.grip("jaw", 0.7);
  holds.clear();
  expect(holds.read("jaw", 0.1, 0)).toBe(0.1);
});

it("leaves what was never held alone", () => {
  const holds = new HeldValues<number>();
  holds.leave("jaw", 0);
  expect(holds.read("jaw", 0.1, 0)).toBe(0.1);
});
