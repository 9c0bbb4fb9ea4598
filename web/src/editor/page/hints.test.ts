import { describe, expect, it } from "vitest";
import { hintOf } from "./hints";
import { TOOLS } from "./keys";

type Known = Parameters<typeof hintOf>[0];
const hintedState = (draft: boolean, net: boolean, tool: Known["options"]["tool"] = "drag"): Known =>
  ({ draft: draft ? {} : null, net: net ? {} : null, options: { tool } }) as Known;
const ALL = [
  hintedState(false, false),
  hintedState(true, false),
  ...TOOLS.map(([tool]) => hintedState(true, true, tool)),
];

describe("the hint", () => {
  it("speaks to fingers of nothing that only a mouse and keys have", () => {
    for (const one of ALL) expect(hintOf(one, true)).not.toMatch(/wheel|click|shift|alt|arrow|key|left|right/i);
  });

  it("says for each tool and each state something of its own", () => {
    expect(new Set(ALL.map((hintedState) => hintOf(hintedState, false))).size).toBe(ALL.length);
  });
});
