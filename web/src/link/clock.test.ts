import { describe, expect, it } from "vitest";
import { ServerClock } from "./clock";

describe("the server's clock", () => {
  it("is unknown before anything was heard", () => {
    expect(new ServerClock().at(5)).toBeUndefined();
  });

  it("trusts the ping with the shortest round trip", () => {
    const clock = new ServerClock();
    clock.measure(10, 110.4, 10.5); // late on the way back
    clock.measure(11, 111.001, 11.002);
    clock.measure(12, 112.2, 12.25);
    expect(clock.at(20)).toBeCloseTo(120, 9);
  });

  it("is right to half a round trip however the way is split", () => {
    for (const there of [0, 0.001, 0.01, 0.02]) {
      const clock = new ServerClock();
      clock.measure(1, 1 + there + 50, 1.02);
      expect(Math.abs((clock.at(2) as number) - 52)).toBeLessThanOrEqual(0.01 + 1e-12);
    }
  });

  it("takes the freshest state until the first pong, and forgets at a restart", () => {
    const clock = new ServerClock();
    clock.arrived(100, 1.05);
    clock.arrived(101, 2.01);
    clock.arrived(102, 3.2);
    expect(clock.at(10)).toBeCloseTo(108.99, 9);
    clock.reset();
    expect(clock.at(10)).toBeUndefined();
  });

  it("passes over what is not a number", () => {
    const clock = new ServerClock();
    clock.measure(1, Number.NaN, 2);
    clock.measure(3, 5, 2);
    expect(clock.at(1)).toBeUndefined();
  });
});
