import { describe, expect, it } from "vitest";
import { type Box, inBox } from "./boxes";
import { tiles } from "./canvas_layout";

const SIZES = [
  [1280, 720],
  [694, 544],
  [400, 800],
] as const;

const overlap = (a: Box, b: Box): boolean =>
  a.left < b.left + b.width - 1e-9 &&
  b.left < a.left + a.width - 1e-9 &&
  a.top < b.top + b.height - 1e-9 &&
  b.top < a.top + a.height - 1e-9;

describe("tiles", () => {
  it("share the canvas without lying over each other", () => {
    for (const [width, height] of SIZES)
      for (let count = 0; count <= 10; count++) {
        const { work, beside } = tiles(width, height, count);
        const boxes = [work, ...beside];
        expect(beside).toHaveLength(count);
        boxes.forEach((box, n) => {
          expect(box.left).toBeGreaterThanOrEqual(-1e-9);
          expect(box.top).toBeGreaterThanOrEqual(-1e-9);
          expect(box.left + box.width).toBeLessThanOrEqual(width + 1e-9);
          expect(box.top + box.height).toBeLessThanOrEqual(height + 1e-9);
          for (const other of boxes.slice(n + 1)) expect(overlap(box, other)).toBe(false);
        });
      }
  });

  it("leave the work the most of it", () => {
    for (const [width, height] of SIZES)
      for (let count = 1; count <= 10; count++) {
        const { work, beside } = tiles(width, height, count);
        for (const box of beside) expect(work.width * work.height).toBeGreaterThan(1.5 * box.width * box.height);
      }
  });

  it("leave all of it to the work alone", () => {
    expect(tiles(300, 200, 0).work).toEqual({ left: 0, top: 0, width: 300, height: 200 });
  });
});

it("knows what lies in a box", () => {
  const box = { left: 10, top: 20, width: 5, height: 5 };
  expect(inBox(box, 10, 24.9)).toBe(true);
  expect(inBox(box, 15, 22)).toBe(false);
});
