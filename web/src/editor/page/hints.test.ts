import { describe, expect, it } from "vitest";
import { hintOf } from "./hints";
import { TOOLS } from "./keys";

type Known = Parameters<typeof hintOf>[0];
const known = (draft: boolean, net: boolean, tool: Known["options"]["tool"] = "drag"): Known =>
  ({ draft: draft ? {} : null, net: net ? {} : null, options: { tool } }) as Known;
const ALL = [known(false, false), known(true, false), ...TOOLS.map(([tool]) => known(true, true, tool))];

describe("the hint", () => {
  it("speaks to fingers of nothing that only a mouse and keys have", () => {
    for (const one of ALL) expect(hintOf(one, true)).not.toMatch(/wheel|click|shift|alt|arrow|key|left|right/i);
  });

  it("says for each tool and each state something of its own", () => {
    expect(new Set(ALL.map((one) => hintOf(one, false))).size).toBe(ALL.length);
  });
});
