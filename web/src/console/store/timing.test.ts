import { expect, it } from "vitest";
import { CHOICES, LONGEST, neighbour, parseSeconds, remainingLabel, secondsLabel } from "./timing";

it("reads what a person types, with a point, a comma or the unit", () => {
  expect(parseSeconds("1.5")).toBe(1.5);
  expect(parseSeconds(" 0,75 ")).toBe(0.75);
  expect(parseSeconds("3s")).toBe(3);
  expect(parseSeconds("0")).toBe(0);
});

it.each(["", "soon", "-1", "1e999", "NaN", String(LONGEST + 1)])("refuses %j with a sentence that names it", (text) => {
  const said = parseSeconds(text);
  expect(said).toContain(`"${text}"`);
  expect(said).toContain("0 to 600");
});

it("labels the choices", () => {
  expect([...CHOICES, null, 1.5].map(secondsLabel)).toEqual(["cut", ".25", ".5", "1", "2", "4", "8", "hand", "1.5"]);
});

it("walks along the choices and stays at their ends", () => {
  expect(neighbour({ seconds: 1, byHand: false }, 1)).toBe(2);
  expect(neighbour({ seconds: 1, byHand: false }, -1)).toBe(0.5);
  expect(neighbour({ seconds: 1.5, byHand: false }, 1)).toBe(2);
  expect(neighbour({ seconds: 1.5, byHand: false }, -1)).toBe(1);
  expect(neighbour({ seconds: 8, byHand: false }, 1)).toBe(8);
  expect(neighbour({ seconds: 0, byHand: false }, -1)).toBe(0);
  for (const direction of [-1, 1] as const) expect(neighbour({ seconds: 3, byHand: true }, direction)).toBe(3);
});

it("says what is left", () => {
  expect(remainingLabel(1.44)).toBe("1.4");
  expect(remainingLabel(12.4)).toBe("12");
});
