import { describe, expect, it } from "vitest";
import { decodeSrgb, encodeSrgb, filmed } from "./tone";

describe("the film", () => {
  const light = Array.from({ length: 400 }, (_, n) => n / 40);

  it("shows more light brighter, and none as white as it gets", () => {
    for (const x of light) {
      expect(filmed(x + 0.001)).toBeGreaterThan(filmed(x));
      expect(filmed(x)).toBeLessThan(1.04);
    }
  });

  it("keeps black and middle grey", () => {
    expect(filmed(0)).toBe(0);
    expect(filmed(0.18)).toBeCloseTo(0.18, 3);
  });
});

describe("colours of the display", () => {
  it.each(["#000000", "#00b140", "#0047bb", "#ffffff", "#0a0b0c"])("come back as %s", (hex) => {
    const bytes = encodeSrgb(decodeSrgb(hex)).map((value) => Math.round(value * 255));
    expect(`#${bytes.map((byte) => byte.toString(16).padStart(2, "0")).join("")}`).toBe(hex);
  });
});
