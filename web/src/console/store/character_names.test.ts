import { describe, expect, it } from "vitest";
import type { CharacterState } from "../../link/messages";
import { freeLabel, nameOf } from "./character_names";

const called = (...labels: string[]): Record<string, CharacterState> =>
  Object.fromEntries(labels.map((label) => [nameOf(label, []), { label } as CharacterState]));

describe("the name of a character", () => {
  it("is what addresses can hold, and nobody's yet", () => {
    expect(nameOf("Kaori Señora!", [])).toBe("kaori-senora");
    expect(nameOf("日本", [])).toBe("character");
    expect(nameOf("One", ["one", "one-2"])).toBe("one-3");
    for (const label of ["x".repeat(80), "--", " a ", "Ünï_3"])
      expect(nameOf(label, ["character"])).toMatch(/^[a-z0-9_-]{1,24}$/);
    expect(freeLabel(called("One", "Two"))).toBe("Three");
    expect(freeLabel({ one: { label: "Kaori" } as CharacterState })).toBe("Two");
  });

  it("is free where a label is taken in another case, and where all numbers are", () => {
    expect(freeLabel(called("one", "TWO"), [])).toBe("Three");
    const numbers = ["one", "two", "three", "four", "five", "six", "seven", "eight"];
    expect(freeLabel(called("Rex"), numbers)).toBe("Character");
    expect(freeLabel(called("Rex", "Character"), numbers)).toBe("Character 2");
  });
});
