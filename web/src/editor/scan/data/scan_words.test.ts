import { describe, expect, it } from "vitest";
import type { SeenScan } from "./scan_document";
import { adviceOf, asksEyes, nearnessOf } from "./scan_words";

const FIGURES = { median: 0.034, p95: 0.5, seen: 0.99 };
const EYES = { kind: "eyes", sentence: "Its lids were opened." } as const;
const LOST = { kind: "place", sentence: "Where are its eyes, and are these eyes shut?" } as const;
const scan = (change: Partial<SeenScan> = {}): SeenScan =>
  ({ unit: "metres, y up", doubts: [], shut: null, given: {}, face: { figures: FIGURES }, ...change }) as SeenScan;

describe("what is said of a fit", () => {
  it("has its distances, its unit, and how much was made up", () => {
    expect(nearnessOf(scan())).toBe(
      "Half of the face lies within 0.03 mm of the scan, 95 % within 0.50 mm. Taken for: metres, y up.",
    );
    const half = scan({ face: { figures: { ...FIGURES, seen: 0.5 } } as SeenScan["face"] });
    expect(nearnessOf(half)).toContain("50 % of the face was scanned; the rest is made up.");
    expect(nearnessOf(scan({ face: null }))).toBe("No face has been fitted yet.");
  });

  it("says what to do in each state", () => {
    expect(adviceOf(scan(), false)).toContain("Omote is sure");
    expect(adviceOf(scan({ doubts: [LOST] }), false)).toContain("not sure");
    expect(adviceOf(scan({ face: null }), false)).toContain("Click the seven points");
    expect(adviceOf(scan({ face: null }), true)).toContain("Fit again");
    const givenPoints = Object.fromEntries([..."abcdefg"].map((name) => [name, [0, 0, 0]]));
    expect(adviceOf(scan({ face: null, given: givenPoints } as Partial<SeenScan>), false)).toContain(
      "move those that are off",
    );
    expect(adviceOf(scan({ doubts: [EYES] }), false)).toContain("sure of all but the eyes");
    expect(adviceOf(scan({ doubts: [EYES, LOST] }), false)).toContain("not sure");
  });

  it("asks for the eyes until it is told, by the kind of a doubt and not by its words", () => {
    expect([
      asksEyes(scan()),
      asksEyes(scan({ doubts: [EYES] })),
      asksEyes(scan({ doubts: [EYES], shut: true })),
      asksEyes(scan({ doubts: [LOST] })),
    ]).toEqual([false, true, false, false]);
  });
});
