import { describe, expect, it } from "vitest";
import { ROW_WIDTH } from "../../../face/gpu/pass_shaders";
import { bandsOf } from "./atlas_bands";
import { BAND } from "./atlas_shaders";

describe("bandsOf", () => {
  it("names each band once, in order, and every row lies in one of them", () => {
    const rows = Uint32Array.of(5000, 3, 0, 700, 4999, 12 * BAND * ROW_WIDTH);
    const bands = bandsOf(rows);
    expect([...bands]).toEqual([...new Set(bands)].sort((a, b) => a - b));
    const size = BAND * ROW_WIDTH;
    for (const row of rows) expect([...bands].some((band) => row >= band * size && row < (band + 1) * size)).toBe(true);
    for (const band of bands) expect([...rows].some((row) => Math.floor(row / size) === band)).toBe(true);
  });

  it("is empty for no rows", () => {
    expect(bandsOf(new Uint32Array())).toHaveLength(0);
  });
});
