import { describe, expect, it } from "vitest";
import { JitterBuffer } from "./jitter_buffer";

function settled(lates: (n: number) => number): number {
  const buffer = new JitterBuffer(1 / 60, 0.06);
  let delay = 0;
  for (let n = 0; n < 600; n++) {
    buffer.arrived(lates(n));
    delay = buffer.after(1 / 60);
  }
  return delay;
}

describe("the delay of a stage", () => {
  it("is one state interval and a little when states are punctual", () => {
    expect(settled(() => 0)).toBeCloseTo(1 / 60 + 0.001, 6);
  });

  it("covers nearly all late states, but not the odd one", () => {
    expect(settled((n) => (n % 5 === 0 ? 0.012 : 0.001))).toBeCloseTo(1 / 60 + 0.013, 6);
    expect(settled((n) => (n % 50 === 0 ? 0.2 : 0.001))).toBeCloseTo(1 / 60 + 0.002, 6);
  });

  it("never grows past its limit and glides there", () => {
    const buffer = new JitterBuffer(1 / 60, 0.06);
    let before = buffer.after(0);
    for (let n = 0; n < 600; n++) {
      buffer.arrived(5);
      const delay = buffer.after(1 / 60);
      expect(delay - before).toBeLessThan(0.0005);
      before = delay;
    }
    expect(before).toBeCloseTo(0.06, 9);
  });
});
