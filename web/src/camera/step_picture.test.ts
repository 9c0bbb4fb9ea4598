import { expect, it } from "vitest";
import { drawStep } from "./step_picture";

/** The text of a picture with its values. */
function text(part: unknown): string {
  if (part === null || part === undefined) return "";
  if (Array.isArray(part)) return part.map(text).join("");
  if (typeof part !== "object") return String(part);
  const { strings, values } = part as { strings: string[]; values: unknown[] };
  return strings.map((string, place) => string + text(values[place])).join("");
}

const STEPS = "neutral shut wide smile pucker aa ee oo browsUp browsDown left right up down puff".split(" ");

it("draws every step as another face, without a number that is none", () => {
  const drawn = STEPS.map((step) => text(drawStep(step)));
  expect(new Set(drawn).size).toBe(STEPS.length);
  for (const string of drawn) expect(string).not.toMatch(/NaN|undefined/);
});
