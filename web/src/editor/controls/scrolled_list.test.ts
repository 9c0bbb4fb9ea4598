import { describe, expect, it } from "vitest";
import { scrollToRow } from "./scrolled_list";

const HEIGHT = 100;

/** A list of one row of a height at a place in it, scrolled by so much. */
function listOf(place: number, height: number, scrollTop: number) {
  const list = { scrollTop, getBoundingClientRect: () => ({ top: 0, bottom: HEIGHT }) as DOMRect };
  const row = {
    getBoundingClientRect: () => {
      const top = place - list.scrollTop;
      return { top, bottom: top + height } as DOMRect;
    },
  };
  return { list, row };
}

describe("a row of a list", () => {
  it.each([
    ["below", 300, 0, 220],
    ["above", 40, 200, 40],
    ["in sight", 150, 120, 120],
  ])("that lies %s comes into sight by as little as can be", (_where, place, from, to) => {
    const { list, row } = listOf(place, 20, from);
    scrollToRow(list, row);
    expect(list.scrollTop).toBe(to);
  });
});
