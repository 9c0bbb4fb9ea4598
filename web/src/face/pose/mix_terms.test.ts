import { describe, expect, it } from "vitest";
import { expressionNames, expressionWeights, faceWeights, type Term, terms } from "./mix_terms";
import { mixPoses, type Pose, restPose } from "./pose";

const all = (): number => 1;

/** The mix by its definition (docs/method.md, "The mix"), for numbers instead of positions. */
function byDefinition(pose: ReturnType<typeof restPose>, at: (face: string, expression?: string) => number): number {
  let sum = 0;
  const channels = { ...pose.channels };
  for (const [name, weight] of Object.entries(pose.added)) channels[name] = (channels[name] ?? 0) + weight;
  for (const [face, s] of Object.entries(pose.faces)) {
    for (const [name, t] of Object.entries(pose.expressions)) sum += s * t * at(face, name);
    for (const [name, c] of Object.entries(channels)) sum += s * c * (at(face, name) - at(face));
  }
  return sum;
}

const pose = {
  ...restPose("generic"),
  faces: { generic: 0.3, old: 0.7 },
  expressions: { neutral: 0.25, smile: 0.85, cry: -0.1 },
  channels: { jawOpen: 0.4, smile: 0.2 },
  added: { jawOpen: -0.1, eyeBlinkLeft: 0.5 },
};

const face = (name: string): number => name.length * 1.7;
const delta = (name: string, expression: string): number =>
  expression === "neutral" ? 0 : Math.sin(name.length * 3 + expression.length * 1.3);
const position = (name: string, expression?: string): number =>
  face(name) + (expression === undefined ? 0 : delta(name, expression));

describe("the terms of a mix", () => {
  it("sum to the mix by its definition", () => {
    const sum = terms(pose, all).reduce(
      (so, term) =>
        so + term.weight * (term.expression === undefined ? face(term.face) : delta(term.face, term.expression)),
      0,
    );
    expect(sum).toBeCloseTo(byDefinition(pose, position), 12);
  });

  it("hold back what is not loaded and keep the face whole", () => {
    const held = terms(pose, (name, expression) => (expression === "smile" && name === "old" ? 0.5 : 1));
    const full = terms(pose, all);
    const bare = (list: Term[]) => list.map((term) => ({ ...term, weight: 0, most: 0 }));
    expect(bare(held)).toEqual(bare(full));
    for (const [n, term] of held.entries()) {
      const whole = (full[n] as (typeof full)[number]).weight;
      expect(term.weight).toBeCloseTo(term.face === "old" && term.expression === "smile" ? whole / 2 : whole, 12);
    }
  });

  it("give a missing face's weight to the others", () => {
    expect([...faceWeights(pose, (name) => (name === "old" ? 0 : 1))]).toEqual([["generic", expect.closeTo(1, 12)]]);
    expect(faceWeights(pose, () => 0).size).toBe(0);
    expect(terms(pose, () => 0)).toEqual([]);
  });

  it("leave out what weighs nothing", () => {
    expect(terms(restPose("kaori"), all)).toEqual([{ face: "kaori", expression: undefined, weight: 1, most: 1 }]);
  });

  it("say of each expression what it weighs at 1: the share of its face", () => {
    const faces = { kaori: 0.25, old: 0.75 };
    const termList = terms({ ...restPose("kaori"), faces, channels: { smile: 1.5 } }, all);
    for (const { face, expression, weight, most } of termList) {
      expect(most).toBe(faces[face as keyof typeof faces]);
      expect(weight).toBe(most * (expression === undefined ? 1 : 1.5));
    }
  });

  it("add channels, and what the gaze adds, to the expressions", () => {
    expect(expressionWeights(pose)).toEqual({
      neutral: 0.25,
      smile: expect.closeTo(1.05, 12),
      cry: -0.1,
      jawOpen: expect.closeTo(0.3, 12),
      eyeBlinkLeft: 0.5,
    });
  });
});

describe("the terms of a mix whose regions go their own way", () => {
  const eyes = { smile: 0.6, wink: 0.4 };
  const own: Pose = { ...pose, regions: { eyes, mouth: { ...pose.expressions } } };
  const NAMES = ["brows", "eyes", "mouth", "rest"] as const;

  it("sum in each region to the mix of that region", () => {
    const termList = terms(own, all);
    for (const [at, region] of NAMES.entries()) {
      const there = { ...pose, expressions: own.regions[region] ?? own.expressions } as typeof pose;
      const sum = termList.reduce(
        (so, { face: name, expression, weight, regions }) =>
          so + (regions?.[at] ?? weight) * (expression === undefined ? face(name) : delta(name, expression)),
        0,
      );
      expect(sum).toBeCloseTo(byDefinition(there, position), 12);
    }
  });

  it("have one weight where regions agree, as all have where none differs", () => {
    const regional = new Set(terms(own, all).flatMap((term) => (term.regions ? [term.expression] : [])));
    expect(regional).toEqual(new Set(["smile", "cry", "wink"]));
    const same = Object.fromEntries(NAMES.map((region) => [region, { ...pose.expressions }]));
    expect(terms({ ...pose, regions: same }, all)).toEqual(terms(pose, all));
  });

  it("name all that is on air anywhere", () => {
    expect(new Set(expressionNames(own))).toEqual(new Set([...Object.keys(expressionWeights(pose)), "wink"]));
    expect(expressionWeights(own, "eyes").wink).toBe(0.4);
    expect(expressionWeights(own, "brows")).toEqual(expressionWeights(own));
  });

  it("mix from pose to pose: a region that is not alone shows what its face does", () => {
    expect(mixPoses(pose, own, 0.5).regions.eyes).toEqual(
      mixPoses(pose, { ...own, expressions: eyes }, 0.5).expressions,
    );
    expect(mixPoses(own, pose, 1).regions.eyes).toMatchObject(pose.expressions);
  });
});

describe("mixing poses", () => {
  it("gives the ends at the ends and keeps sums between", () => {
    const other = { ...restPose("child"), channels: { jawOpen: 1 } };
    expect(mixPoses(pose, other, 0).faces).toMatchObject(pose.faces);
    expect(mixPoses(pose, other, 1).faces).toMatchObject({ child: 1, generic: 0, old: 0 });
    for (const part of [0.2, 0.5, 0.9]) {
      const { faces } = mixPoses(pose, other, part);
      expect(Object.values(faces).reduce((sum, weight) => sum + weight, 0)).toBeCloseTo(1, 12);
    }
  });
});
