import { expect, test } from "vitest";
import { palette } from "./theme";

/** The relative luminance of a colour, as WCAG 2 has it. */
function luminance(colour: string): number {
  const linear = [1, 3, 5].map((at) => {
    const value = Number.parseInt(colour.slice(at, at + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
  const [red, green, blue] = linear as [number, number, number];
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

const colourOf = (name: string): string =>
  new RegExp(`--${name}: (#[0-9a-f]{6});`).exec(palette.cssText)?.[1] ?? "none";

test.each(["text", "dim", "faint", "air", "coming", "attention", "focus"])(
  "words in %s are read on every ground (4.5 to 1, WCAG AA)",
  (name) => {
    for (const ground of ["ground", "panel", "raised"]) {
      const [dark, light] = [colourOf(ground), colourOf(name)].map((colour) => luminance(colour) + 0.05) as [
        number,
        number,
      ];
      expect(light / dark).toBeGreaterThanOrEqual(4.5);
    }
  },
);
