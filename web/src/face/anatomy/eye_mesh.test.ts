import { describe, expect, it } from "vitest";
import { ballFrame, dome } from "./eye_mesh";

type Vector = [number, number, number];
const apply = (m: readonly number[], v: Vector): Vector =>
  [0, 1, 2].map((row) =>
    [0, 1, 2].reduce((sum, n) => sum + (m[3 * n + row] as number) * (v[n] as number), 0),
  ) as Vector;

describe("the dome of an eyeball", () => {
  const { directions, triangles } = dome(6, 10);
  const corner = (n: number) => directions.subarray(3 * n, 3 * n + 3) as unknown as Vector;

  it("lies on the unit sphere", () => {
    for (let n = 0; n < directions.length / 3; n++) expect(Math.hypot(...corner(n))).toBeCloseTo(1);
  });

  it("has a triangle fan in front and faces outwards everywhere", () => {
    expect(triangles.length / 3).toBe(10 + 5 * 20);
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map((n) => corner(triangles[t + n] as number)) as [Vector, Vector, Vector];
      const [u, v] = [b.map((x, n) => x - (a[n] as number)), c.map((x, n) => x - (a[n] as number))] as [Vector, Vector];
      const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      expect(normal.reduce((sum, x, n) => sum + x * ((a[n] as number) + (b[n] as number)), 0)).toBeGreaterThan(0);
    }
  });
});

describe("the axes read from an eyeball's rows", () => {
  const generic = dome(5, 8).directions;
  const both = new Float32Array([...generic, ...generic.map((x) => -x)].map((x) => 0.015 * x));
  const count = both.length / 3;

  it("are the linear map that the ball went by", () => {
    const map = [0.9, 0.1, -0.2, 0.05, 1.1, 0.3, 0.2, -0.1, 1.2];
    const frame = ballFrame(both, 0, count);
    const moved = frame.rows.map((row) => apply(map, Array.from(both.subarray(3 * row, 3 * row + 3)) as Vector));
    const pairs = [0, 2, 4].flatMap((n) =>
      [0, 1, 2].map(
        (axis) => ((moved[n] as Vector)[axis] as number) / 2 - ((moved[n + 1] as Vector)[axis] as number) / 2,
      ),
    );
    const axes = [0, 3, 6].flatMap((n) => apply(pairs, frame.fromPairs.slice(n, n + 3) as Vector));
    for (const [n, value] of axes.entries()) expect(value).toBeCloseTo(0.015 * (map[n] as number), 6);
  });
});
