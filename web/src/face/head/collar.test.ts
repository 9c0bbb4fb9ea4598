import { describe, expect, it } from "vitest";
import type { Anatomy } from "../anatomy/anatomy";
import { collar } from "./collar";

/** A neck whose rim goes up and down and in and out from row to row, as scanned necks do; `map` moves its points. */
function raggedNeck(map = (point: number[]) => point): Anatomy {
  const rim = Array.from({ length: 46 }, (_, row) => row);
  const positions = rim.flatMap((row) => {
    const angle = (2 * Math.PI * row) / 46;
    const [radius, height] = [0.05 + 0.006 * Math.sin(11 * angle), -0.13 + 0.01 * Math.cos(13 * angle)];
    return map([radius * Math.sin(angle), height, 0.02 + 0.9 * radius * Math.cos(angle)]);
  });
  return { rim, positions: Float32Array.from(positions) } as unknown as Anatomy;
}

/** Where the shader puts the collar's vertices on a neck. */
function drawn(geometry: ReturnType<typeof collar>, { positions }: Anatomy): number[][] {
  const read = (name: string, at: number) => {
    const { array, itemSize } = geometry.getAttribute(name);
    return Array.from(array.slice(itemSize * at, itemSize * (at + 1)));
  };
  return Array.from({ length: geometry.getAttribute("fade").count }, (_, at) => {
    const [anchors, shares, offset] = [read("anchors", at), read("shares", at), read("offset", at)];
    return offset.map((value, axis) =>
      anchors.reduce(
        (sum, row, n) => sum + (shares[n] as number) * (positions[3 * row + axis] as number),
        value as number,
      ),
    );
  });
}

/** The sharpest turn of a closed line, degrees. */
function sharpestTurn(line: number[][]): number {
  const steps = line.map((point, at) =>
    point.map((value, axis) => (line[(at + 1) % line.length]?.[axis] as number) - value),
  );
  const turns = steps.map((step, at) => {
    const next = steps[(at + 1) % steps.length] as number[];
    const along = step.reduce((sum, value, axis) => sum + value * (next[axis] as number), 0);
    return Math.acos(Math.min(1, along / (Math.hypot(...step) * Math.hypot(...next))));
  });
  return (Math.max(...turns) * 180) / Math.PI;
}

describe("the collar", () => {
  const neck = raggedNeck();
  const geometry = collar(neck);
  const points = drawn(geometry, neck);
  const rings = Array.from({ length: points.length / 48 }, (_, ring) => points.slice(48 * ring, 48 * (ring + 1)));

  it("has smooth rings around a ragged neck", () => {
    const rim = neck.rim.map((row) => Array.from(neck.positions.slice(3 * row, 3 * row + 3)));
    expect(sharpestTurn(rim)).toBeGreaterThan(60);
    for (const ring of rings) expect(sharpestTurn(ring)).toBeLessThan(15);
  });

  it("goes with every neck as a whole, and stays as thick", () => {
    const move = ([x, y, z]: number[]) => [
      1.2 * (x as number) + 0.1 * (z as number),
      (y as number) - 0.02,
      0.9 * (z as number),
    ];
    const other = drawn(geometry, raggedNeck(move));
    const offset = geometry.getAttribute("offset").array;
    points.forEach((point, at) => {
      const carried = point.map((value, axis) => value - (offset[3 * at + axis] as number));
      move(carried).forEach((value, axis) => {
        expect(other[at]?.[axis]).toBeCloseTo(value + (offset[3 * at + axis] as number), 6);
      });
    });
  });

  it("faces outwards", () => {
    const facing = geometry.getAttribute("facing").array;
    const roll = 48 * 5; // the upright part
    for (let at = roll; at < roll + 48; at++) {
      const [x, , z] = points[at] as [number, number, number];
      expect((facing[3 * at] as number) * x + (facing[3 * at + 2] as number) * (z - 0.02)).toBeGreaterThan(0);
    }
  });
});
