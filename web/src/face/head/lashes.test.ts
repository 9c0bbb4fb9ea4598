import { describe, expect, it } from "vitest";
import { EDGE_POINTS } from "../anatomy/openings";
import { ribbons } from "./lashes";

describe("the ribbons of lashes", () => {
  const [upper, lower] = [
    { count: 40, clump: 4, length: 0.008 },
    { count: 20, clump: 3, length: 0.004 },
  ];
  const { strands, bends, triangles } = ribbons(upper, lower);
  const vertices = strands.length / 4;
  const every = (test: (n: number) => boolean) => Array.from({ length: vertices }, (_, n) => n).every(test);

  it("grow on the edges of both eyes, denser on the upper lids", () => {
    const on = [0, 1, 2, 3].map(
      (edge) => bends.filter((first, n) => n % 4 === 0 && first === edge * EDGE_POINTS).length,
    );
    expect(on[0]).toBe(2 * (on[1] as number));
    expect(on.slice(2)).toEqual(on.slice(0, 2));
    expect(every((n) => (bends[4 * n + 3] === 1) === ((bends[4 * n] as number) % (2 * EDGE_POINTS) === 0))).toBe(true);
  });

  it("stay between the corners and are at most as long as asked for", () => {
    expect(every((n) => (strands[4 * n] as number) > 0 && (strands[4 * n] as number) < 1)).toBe(true);
    expect(every((n) => (bends[4 * n + 2] as number) <= (bends[4 * n + 3] === 1 ? 0.008 : 0.004))).toBe(true);
  });

  it("are whole: every vertex is drawn, and the same every time", () => {
    expect(new Set(triangles).size).toBe(vertices);
    expect(Math.max(...triangles)).toBe(vertices - 1);
    expect(ribbons(upper, lower)).toEqual({ strands, bends, triangles });
  });
});
