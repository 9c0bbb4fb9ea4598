import { describe, expect, it } from "vitest";
import { type Arrangement, FIRST, KINDS, parsed, written } from "./arrangement";
import { LONGEST } from "./timing";

const OTHER: Arrangement = {
  timing: {
    face: { seconds: 3, easing: "late", byHand: true },
    expression: { seconds: 0, easing: "sharp", byHand: false },
  },
  kind: "arkit",
  ownFaces: true,
  tab: "touched",
  linked: false,
  springs: { head: false, gaze: true },
  view: "pads",
  mixer: "gaze",
  pads: ["lips", "moods"],
  solo: { looks: true, lines: false, head: true },
  alone: true,
};

describe("a console's arrangement", () => {
  it("comes back as it was written", () => {
    for (const arrangement of [FIRST, OTHER, ...KINDS.map((kind) => ({ ...FIRST, kind }))])
      expect(parsed(written(arrangement))).toEqual(arrangement);
  });

  it("is small enough for a message", () => {
    expect(written(OTHER).length).toBeLessThan(500);
  });

  it("of before own faces had a palette of their own shows all", () => {
    const { ownFaces: _, ...before } = FIRST;
    expect(parsed(written(before as Arrangement))).toEqual(FIRST);
  });

  it("of before springs were kept springs, and what is no switch is told", () => {
    const { springs: _, ...before } = OTHER;
    expect(parsed(written(before as Arrangement))).toEqual({ ...OTHER, springs: FIRST.springs });
    for (const springs of [null, {}, { head: 1, gaze: true }])
      expect(parsed(JSON.stringify({ ...OTHER, version: 2, springs }))).toMatch(/names what this console has not/);
  });

  it("of before the mixer had groups shows its strips, and a group that is none is told", () => {
    const { mixer: _, ...before } = OTHER;
    expect(parsed(written(before as Arrangement))).toEqual({ ...OTHER, mixer: "strips" });
    expect(parsed(JSON.stringify({ ...OTHER, version: 2, mixer: "all" }))).toMatch(/names what this console has not/);
  });

  it("of before seconds were kept while calls are by hand has those of the default", () => {
    const { view: _, ...older } = FIRST;
    const timing = { face: { seconds: null, easing: "late" }, expression: { seconds: 1, easing: "smooth" } };
    const { timing: timings, view } = parsed(JSON.stringify({ ...older, version: 1, timing })) as Arrangement;
    expect(timings.face).toEqual({ seconds: FIRST.timing.face.seconds, easing: "late", byHand: true });
    expect(timings.expression).toEqual({ seconds: 1, easing: "smooth", byHand: false });
    expect(view).toBe(FIRST.view);
  });

  it("of before pads were chosen has those of the cast first, and what are no names is told", () => {
    const { pads: _, solo: __, ...before } = OTHER;
    expect(parsed(written(before as Arrangement))).toEqual({ ...OTHER, pads: FIRST.pads, solo: FIRST.solo });
    for (const wrong of [{ pads: "mouth" }, { pads: [1] }, { solo: null }, { solo: { looks: true } }])
      expect(parsed(JSON.stringify({ ...OTHER, version: 2, ...wrong }))).toMatch(/names what this console has not/);
  });

  it("brings nothing with it that it does not know", () => {
    expect(parsed(JSON.stringify({ ...JSON.parse(written(FIRST)), theme: "pink" }))).toEqual(FIRST);
  });

  const broken: [string, unknown][] = [
    ["no record", 7],
    ["a list", []],
    ["nothing", null],
    ["of another version", { ...FIRST, version: 99 }],
    ["without times", { version: 1, ...FIRST, timing: {} }],
    [
      "with a time below zero",
      { version: 1, ...FIRST, timing: { ...FIRST.timing, face: { seconds: -1, easing: "smooth" } } },
    ],
    [
      "with too long a time",
      { version: 1, ...FIRST, timing: { ...FIRST.timing, face: { seconds: LONGEST + 1, easing: "smooth" } } },
    ],
    [
      "with an easing of its own",
      { version: 1, ...FIRST, timing: { ...FIRST.timing, face: { seconds: 1, easing: "bouncy" } } },
    ],
    ["with a strange tab", { version: 1, ...FIRST, tab: "beak" }],
    ["with a strange kind", { version: 1, ...FIRST, kind: 3 }],
    ["with a strange view", { version: 2, ...FIRST, view: "sky" }],
    [
      "with a time that is text",
      { version: 2, ...FIRST, timing: { ...FIRST.timing, face: { seconds: "2", easing: "late" } } },
    ],
    ["without a link", { version: 1, ...FIRST, linked: "yes" }],
  ];

  it.each(broken)("that is %s is told in a sentence", (_, document) => {
    expect(parsed(JSON.stringify(document))).toMatch(/^The layout .*its own\.$/);
  });

  it("that is no JSON at all is told too", () => {
    expect(parsed("{")).toMatch(/cannot be read/);
  });
});
