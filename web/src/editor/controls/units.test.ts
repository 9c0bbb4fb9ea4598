import { expect, it } from "vitest";
import { DEGREES, MILLIMETRES, PERCENT, shown, typed } from "./units";

it("numbers are shown in people's units", () => {
  expect(shown(Math.PI / 2, DEGREES)).toBe("90.00");
  expect(shown(0.0123, MILLIMETRES)).toBe("12.30");
  expect(shown(0.5, PERCENT)).toBe("50");
  expect(shown(-1e-9, MILLIMETRES)).toBe("0.00");
});

it("what is typed is what is shown", () => {
  for (const unit of [DEGREES, MILLIMETRES, PERCENT])
    for (const value of [-1.25, 0, 0.5]) {
      const again = typed(shown(value, unit), unit);
      expect(shown(again as number, unit)).toBe(shown(value, unit));
    }
  expect(typed("1,5 mm", MILLIMETRES)).toBeCloseTo(0.0015);
});

it("what is no number is none", () => {
  for (const text of ["", "soon", "1.2.3", "Infinity"]) expect(typed(text, DEGREES)).toBeNull();
});
