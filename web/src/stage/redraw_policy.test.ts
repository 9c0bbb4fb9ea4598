import { describe, expect, it } from "vitest";
import { RedrawPolicy } from "./redraw_policy";

/** Which of the frames that show these texts are drawn. */
const drawn = (policy: RedrawPolicy, keys: readonly string[], settled = true): boolean[] =>
  keys.map((key) => policy.needed(key, settled));

const rested = (): RedrawPolicy => {
  const policy = new RedrawPolicy();
  drawn(policy, Array(10).fill("a"));
  return policy;
};

describe("which frames are drawn", () => {
  it("draws every frame that shows something else", () => {
    const keys = Array.from({ length: 50 }, (_, n) => String(n));
    expect(drawn(new RedrawPolicy(), keys)).not.toContain(false);
    expect(rested().needed("b", true)).toBe(true);
  });

  it("draws every frame while something comes or fades", () => {
    expect(drawn(new RedrawPolicy(), Array(50).fill("a"), false)).not.toContain(false);
  });

  it("draws what stands still a few times, then twice a second", () => {
    const policy = new RedrawPolicy();
    const frames = drawn(policy, Array(60 * 10).fill("a"));
    expect(frames.slice(0, 3)).toEqual([true, true, true]);
    expect(policy.still).toBe(true);
    const late = frames.slice(60);
    expect(late.filter(Boolean).length).toBe(late.length / 30);
    for (let at = 0; at + 30 <= late.length; at++) expect(late.slice(at, at + 30)).toContain(true);
  });

  it("draws again at once in another size", () => {
    const policy = rested();
    expect(policy.needed("a", true)).toBe(false);
    policy.forget();
    expect(policy.still).toBe(false);
    expect(policy.needed("a", true)).toBe(true);
  });
});
