import { describe, expect, it } from "vitest";
import { openness } from "./occlusion";
import { fans } from "./topology";

/** A horizontal square of 9 x 9 points at a height, facing up. */
function plate(height: number, size: number): { positions: number[]; triangles: number[] } {
  const positions: number[] = [];
  const triangles: number[] = [];
  for (let z = 0; z < 9; z++)
    for (let x = 0; x < 9; x++) {
      const at = positions.length / 3;
      positions.push((x / 4 - 1) * size, height, (z / 4 - 1) * size);
      if (x < 8 && z < 8) triangles.push(at, at + 9, at + 1, at + 1, at + 9, at + 10);
    }
  return { positions, triangles };
}

describe("openness", () => {
  it("is full on a bare plate and little under a roof", () => {
    const [floor, roof] = [plate(0, 0.1), plate(0.03, 0.1)];
    const bare = Uint32Array.from(floor.triangles);
    const covered = Uint32Array.from([...floor.triangles, ...roof.triangles.map((row) => row + 81)]);
    const open = openness(fans([bare], 81), Float32Array.from(floor.positions), [bare]);
    const shut = openness(fans([covered], 162), Float32Array.from([...floor.positions, ...roof.positions]), [covered]);
    expect(open[40]).toBeGreaterThan(0.95);
    expect(shut[40]).toBeLessThan(0.2);
    expect(shut[121]).toBeGreaterThan(0.95);
    expect(shut[0]).toBeGreaterThan(shut[40] as number);
  });
});
