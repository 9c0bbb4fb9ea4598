import { describe, expect, it } from "vitest";
import { divideLong } from "./curved_triangles";

/** A ball of 8 triangles with a fan of small ones in one of them, so that flat and curved parts meet. */
const places: readonly (readonly [number, number, number])[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
  [-1, 0, 0],
  [0, -1, 0],
  [0, 0, -1],
  [0.35, 0.3, 0.35],
  [0.3, 0.35, 0.35],
  [0.35, 0.35, 0.3],
];
const triangles = Uint32Array.from(
  [
    [6, 8, 7],
    [0, 1, 8],
    [0, 8, 6],
    [1, 2, 7],
    [1, 7, 8],
    [2, 0, 6],
    [2, 6, 7],
    [1, 0, 5],
    [3, 1, 5],
    [4, 3, 5],
    [0, 4, 5],
    [1, 3, 2],
    [3, 4, 2],
    [4, 0, 2],
  ].flat(), // prettier-ignore
);
const place = (vertex: number) => places[vertex] as readonly number[];

describe("large triangles", () => {
  const { flat, curved, corners, shares } = divideLong(triangles, place, () => 0.4);
  const point = (own: number) =>
    [0, 1, 2].map((axis) =>
      [0, 1, 2].reduce(
        (sum, at) => sum + (shares[3 * own + at] as number) * (place(corners[3 * own + at] as number)[axis] as number),
        0,
      ),
    );
  const drawn = [...Array.from(curved, point), ...Array.from(flat, (vertex) => [...place(vertex)])];
  const edges = drawn.map((from, at) => [from, drawn[at - (at % 3) + ((at + 1) % 3)] as number[]] as const);

  it("are divided until no edge is longer than asked for", () => {
    for (const [from, to] of edges)
      expect(Math.hypot(...from.map((value, axis) => value - (to[axis] as number)))).toBeLessThanOrEqual(0.4);
    expect(Array.from(flat)).toEqual([6, 8, 7]);
  });

  it("leave no crack: every edge is drawn once in each direction", () => {
    const name = (point: readonly number[]) => point.map((value) => value.toFixed(6)).join();
    const there = new Set(edges.map(([from, to]) => `${name(from)} ${name(to)}`));
    expect(there.size).toBe(edges.length);
    for (const [from, to] of edges) expect(there).toContain(`${name(to)} ${name(from)}`);
  });

  it("share their vertices, whose shares are whole", () => {
    const names = Array.from({ length: corners.length / 3 }, (_, own) =>
      point(own)
        .map((value) => value.toFixed(6))
        .join(),
    ); // prettier-ignore
    expect(new Set(names).size).toBe(names.length);
    for (let own = 0; own < corners.length; own += 3)
      expect(shares.subarray(own, own + 3).reduce((sum, share) => sum + share, 0)).toBe(1);
  });

  it("that are small stay as they are", () => {
    const small = divideLong(triangles, place, () => 2);
    expect(small.flat).toEqual(triangles);
    expect(small.curved).toHaveLength(0);
  });

  it("leave no crack where edges may be longer in one place than in another", () => {
    const uneven = divideLong(triangles, place, (middle) => 0.15 + 0.5 * Math.max(0, 0.4 - (middle[1] as number)));
    const at = (own: number) =>
      [0, 1, 2]
        .map((axis) =>
          [0, 1, 2].reduce(
            (sum, corner) =>
              sum +
              (uneven.shares[3 * own + corner] as number) *
                (place(uneven.corners[3 * own + corner] as number)[axis] as number),
            0,
          ),
        )
        .map((value) => value.toFixed(6))
        .join();
    const names = [
      ...Array.from(uneven.curved, at),
      ...Array.from(uneven.flat, (v) =>
        place(v)
          .map((x) => x.toFixed(6))
          .join(),
      ),
    ];
    const sides = new Set(names.map((name, n) => `${name} ${names[n - (n % 3) + ((n + 1) % 3)]}`));
    expect(sides.size).toBe(names.length);
    for (const side of sides) expect(sides).toContain(side.split(" ").reverse().join(" "));
  });
});
