import { describe, expect, it } from "vitest";
import { layOut, type PictureGrid, wholePose } from "./picture_grid";

const grid = (rows: number, columns: number, changes: Partial<PictureGrid> = {}): PictureGrid => ({
  poses: Array.from({ length: rows }, () => Array.from({ length: columns }, () => ({}))),
  rows: [],
  columns: [],
  captions: [],
  part: [0, 0, 1, 1],
  paper: null,
  kind: "image/png",
  ...changes,
});

describe("a sheet", () => {
  it("of one picture without names is the picture", () => {
    const { width, height, part, corner } = layOut(grid(1, 1), 320, 240, 0);
    expect([width, height, ...part, ...corner(0, 0)]).toEqual([320, 240, 0, 0, 320, 240, 0, 0]);
  });

  it("puts every cell beside and below its neighbours, inside the sheet", () => {
    const layout = layOut(grid(3, 4, { rows: ["a", "b", "c"], columns: ["x", "y", "z", "w"] }), 100, 120, 2);
    for (let row = 0; row < 3; row++)
      for (let column = 0; column < 4; column++) {
        const [x, y] = layout.corner(row, column);
        expect(x).toBeGreaterThan(column > 0 ? layout.corner(row, column - 1)[0] + 99 : layout.letter);
        expect(y).toBeGreaterThan(row > 0 ? layout.corner(row - 1, column)[1] + 119 : layout.letter);
        expect(x + 100).toBeLessThanOrEqual(layout.width);
        expect(y + 120).toBeLessThanOrEqual(layout.height);
      }
  });

  it("keeps a part of each picture", () => {
    const layout = layOut(grid(2, 2, { part: [0.25, 0.5, 0.5, 0.25] }), 200, 400, 0);
    expect(layout.part).toEqual([50, 200, 100, 100]);
    expect(layout.corner(1, 1)).toEqual([101, 101]);
    expect([layout.width, layout.height]).toEqual([201, 201]);
  });
});

describe("wholePose", () => {
  it("has the bytes of a body that come as base64, and all else as it is", () => {
    const figure = {
      poses: { stand: 1 },
      regions: {},
      bodies: { own: 1 },
      tracked: { shares: [1], pose: btoa("\x01\xff") },
    };
    const whole = wholePose({ figure } as unknown as Parameters<typeof wholePose>[0]);
    expect(whole.figure).toEqual({ ...figure, tracked: { shares: [1], pose: new Uint8Array([1, 255]) } });
    expect(wholePose({}).figure).toEqual(wholePose({ head: [0, 0, 0] }).figure);
  });
});
