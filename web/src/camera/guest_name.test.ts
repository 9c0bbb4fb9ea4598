import { expect, test } from "vitest";
import { guestName } from "./guest_name";

test("a name for a start is two words, of which there are many", () => {
  const steps = Array.from({ length: 30 }, (_, step) => step / 30);
  const names = steps.flatMap((first) =>
    steps.map((second) => {
      const numbers = [first, second];
      return guestName(() => numbers.shift() ?? 0);
    }),
  );
  expect(new Set(names).size).toBe(900);
  for (const name of names) expect(name).toMatch(/^[A-Z][a-z]+ [A-Z][a-z]+$/);
});
