import { describe, expect, it } from "vitest";
import { readRegionMasks } from "./region_masks";

const bytes = (counts: number[]): Uint8Array => new Uint8Array(Uint16Array.from(counts).buffer);
const ROWS = bytes([65535, 0, 0, 0, 0, 13107, 52428, 0]);

describe("the masks of the regions", () => {
  it("are shares of one, four for each row", () => {
    const masks = readRegionMasks({ rows: ROWS, allowances: bytes([0, 0, 0, 65535]) }, 2);
    expect([...masks.rows].map((share) => share.toFixed(6))).toEqual(
      [1, 0, 0, 0, 0, 0.2, 0.8, 0].map((share) => share.toFixed(6)),
    );
    expect([...masks.allowances]).toEqual([0, 0, 0, 1]);
  });

  it("are refused where they are of another cast", () => {
    expect(() => readRegionMasks({ rows: ROWS, allowances: bytes([]) }, 3)).toThrow(
      "The regions' masks hold 2 rows, the cast 3.",
    );
  });
});
