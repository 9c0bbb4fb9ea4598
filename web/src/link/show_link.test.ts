import { describe, expect, it } from "vitest";
import { Backoff } from "./reconnecting_socket";
import { Newest } from "./show_link";

describe("the newest state", () => {
  it("wins: a lower (epoch, number) is ignored and counted", () => {
    const newest = new Newest();
    const accepts = (epoch: number, number: number) => newest.accept({ epoch, number });
    expect([
      accepts(3, 7),
      accepts(3, 7),
      accepts(3, 6),
      accepts(3, 9),
      accepts(2, 99),
      accepts(4, 0),
      accepts(3, 10),
    ]).toEqual([true, false, false, true, false, true, false]);
    expect(newest.ignored).toBe(4);
  });
});

describe("the backoff", () => {
  it("begins at 50 ms, doubles to half a second and stays there, jittered by half", () => {
    for (const random of [0, 0.5, 1]) {
      const backoff = new Backoff(undefined, undefined, () => random);
      const waits = Array.from({ length: 100 }, () => backoff.next() / (0.5 + random));
      expect(waits.slice(0, 5)).toEqual([0.05, 0.1, 0.2, 0.4, 0.5].map((wait) => expect.closeTo(wait, 9)));
      expect(Math.max(...waits)).toBeCloseTo(0.5, 9);
      backoff.reset();
      expect(backoff.next() / (0.5 + random)).toBeCloseTo(0.05, 9);
    }
  });
});
