import { describe, expect, it } from "vitest";
import { PORTRAIT_SIZE } from "../link/framings";
import { cameraPosition, PORTRAIT, type Point } from "./framing";
import {
  asPortraits,
  type Clearance,
  clearances,
  groupShot,
  NO_CLEARANCE,
  type PlacedHead,
  type PlacedShot,
  portraitsAs,
  shotsOfAll,
  sizesIn,
  standFor,
} from "./scene_framing";

const HALF = Math.tan((18 * Math.PI) / 360);
const WIDE = 16 / 9;

/** A head at x, so far from the audience and so large. */
function head(x: number, { depth = 0, size = 1, presence = 1 } = {}): PlacedHead {
  const points = [-1, 1].map((side): Point => [x + side * 0.09 * size, 0.02, -depth]);
  const centre: [number, number, number] = [x + PORTRAIT.centre[0], PORTRAIT.centre[1], PORTRAIT.centre[2] - depth];
  const near = {
    shot: { centre, height: PORTRAIT.height * size, width: PORTRAIT.width * size },
    points: [...points, [x, 0.13 * size, -depth]] as Point[],
  };
  const far = { ...near, shot: { ...near.shot, height: 7 * near.shot.height } };
  return { shots: new Map([[PORTRAIT_SIZE, near], ["full", far] as const]), presence };
}

const portraitOf = (placed: PlacedHead): PlacedShot => placed.shots.get(PORTRAIT_SIZE) as PlacedShot;

/** Where a point lies in the picture of a camera that stands there: -1..1 across and up. */
const seen = ([x, y, z]: Point, [cx, cy, cz]: readonly number[], aspect: number): [number, number] => [
  (x - (cx as number)) / (((cz as number) - z) * HALF * aspect),
  (y - (cy as number)) / (((cz as number) - z) * HALF),
];

const three = new Map([
  ["a", head(-0.3, { size: 1.2 })],
  ["b", head(0.02, { depth: 0.4 })],
  ["c", head(0.35)],
]);

describe("a framing", () => {
  it("of one character is its portrait, to the last bit", () => {
    const portrait = cameraPosition(PORTRAIT, portraitOf(head(0)).points, HALF, WIDE);
    for (const key of ["one", "*"])
      expect(standFor({ [key]: 1 }, new Map([["one", head(0)]]), HALF, WIDE)).toEqual(portrait);
  });

  it.each([0.4, 1, WIDE, 4])("holds every head of its characters in a picture of %s", (aspect) => {
    for (const key of ["*", "a+b", "b+c", "a+c"]) {
      const stand = standFor({ [key]: 1 }, three, HALF, aspect) as [number, number, number];
      for (const [name, placed] of three)
        if (key === "*" || key.includes(name))
          for (const point of portraitOf(placed).points)
            for (const place of seen(point, stand, aspect)) expect(Math.abs(place)).toBeLessThanOrEqual(1);
    }
  });

  it("touches what it holds: the camera stands no farther away than it must", () => {
    const shots = [...three.values()].map((placed) => portraitOf(placed).shot);
    const group = groupShot(shots, HALF, WIDE);
    const near: [number, number, number] = [
      group.centre[0],
      group.centre[1],
      group.centre[2] + group.height / 2 / HALF,
    ];
    const corners = shots.flatMap(({ centre: [x, y, z], width, height }) =>
      [-0.5, 0.5].flatMap((side) => seen([x + side * width, y + side * height, z], near, WIDE).map(Math.abs)),
    );
    expect(Math.max(...corners)).toBeCloseTo(1, 9);
  });

  it("travels straight from one to the other", () => {
    const [from, to] = ["*", "c"].map((key) => standFor({ [key]: 1 }, three, HALF, WIDE) as number[]);
    for (const part of [0.2, 0.5, 0.9])
      standFor({ "*": 1 - part, c: part }, three, HALF, WIDE)?.forEach((value, axis) => {
        expect(value).toBeCloseTo((from?.[axis] as number) * (1 - part) + (to?.[axis] as number) * part, 9);
      });
  });

  it("is of a size, and travels straight from one size to another", () => {
    const full = standFor({ "a+b:full": 1 }, three, HALF, WIDE) as number[];
    const near = standFor({ "a+b": 1 }, three, HALF, WIDE) as number[];
    expect(full[2]).toBeGreaterThan(3 * (near[2] as number));
    for (const part of [0.1, 0.6])
      standFor({ "a+b": 1 - part, "a+b:full": part }, three, HALF, WIDE)?.forEach((value, axis) => {
        expect(value).toBeCloseTo((near[axis] as number) * (1 - part) + (full[axis] as number) * part, 9);
      });
    expect([...sizesIn({ "*": 0.25, "a:full": 0.5, "b:full": 0.25, c: 0 })]).toEqual([
      [PORTRAIT_SIZE, 0.25],
      ["full", 0.75],
    ]);
    expect(portraitsAs({ "*": 0.5, "*:bust": 0.25, "a:full": 0.25 }, "bust")).toEqual({
      "*:bust": 0.75,
      "a:full": 0.25,
    });
    expect(asPortraits({ "*": 0.5, "*:bust": 0.25, "a:full": 0.25 })).toEqual({ "*": 0.75, a: 0.25 });
  });

  it("whose characters are all gone holds everybody; with nobody there is none", () => {
    expect(standFor({ gone: 1 }, three, HALF, WIDE)).toEqual(standFor({ "*": 1 }, three, HALF, WIDE));
    expect(standFor({ "b+gone": 1 }, three, HALF, WIDE)).toEqual(standFor({ b: 1 }, three, HALF, WIDE));
    expect(standFor({ "*": 1 }, new Map(), HALF, WIDE)).toBeUndefined();
  });

  it("of all makes room for who comes as they come: no jump, and the ends are those of who is there", () => {
    const at = (presence: number) => {
      const heads = new Map([...three, ["c", head(0.35, { presence })]]);
      return standFor({ "*": 1 }, heads, HALF, WIDE) as number[];
    };
    expect(at(0)).toEqual(standFor({ "a+b": 1 }, three, HALF, WIDE));
    expect(at(1)).toEqual(standFor({ "*": 1 }, three, HALF, WIDE));
    let before = at(0);
    for (let step = 1; step <= 50; step++) {
      const now = at(step / 50);
      now.forEach((value, axis) => {
        expect(Math.abs(value - (before[axis] as number))).toBeLessThan(0.05);
      });
      before = now;
    }
  });

  it("of all counts each by how present they are, in any order, and everybody where nobody is", () => {
    const heads = new Map([
      ["a", head(0, { presence: 0.25 })],
      ["b", head(0, { presence: 1 })],
      ["c", head(0, { presence: 0.5 })],
    ]);
    expect(shotsOfAll(heads)).toEqual([
      [["b"], 0.5],
      [["b", "c"], 0.25],
      [["b", "c", "a"], 0.25],
    ]);
    const nobody = new Map([...heads].map(([name, placedHead]) => [name, { ...placedHead, presence: 0 }]));
    expect(shotsOfAll(nobody)).toEqual([[["a", "b", "c"], 1]]);
  });
});

describe("who is not in a shot", () => {
  const clear = (framing: Record<string, number>, heads: ReadonlyMap<string, PlacedHead>, name: string): Clearance =>
    clearances(framing, heads, HALF, WIDE).get(name) ?? NO_CLEARANCE;
  const beside = (x: number, depth = 0) =>
    new Map([
      ["a", head(0.1)],
      ["b", head(x, { depth })],
    ]);

  it.each([
    [0.35, 0],
    [-0.3, 0],
    [0.8, 2],
    [-0.4, 1],
  ])("stands beyond the edge of its picture on its own side, shoulders and all: %s, %s back", (x, depth) => {
    const heads = beside(x, depth);
    const stand = standFor({ a: 1 }, heads, HALF, WIDE) as [number, number, number];
    const { aside, sunk } = clear({ a: 1 }, heads, "b");
    const { points, shot } = portraitOf(heads.get("b") as PlacedHead);
    const all: Point[] = [...points, [x - 0.2, 0, shot.centre[2]], [x + 0.2, 0, shot.centre[2]]];
    expect(sunk).toBe(0);
    for (const [px, py, pz] of all)
      expect(Math.sign(x - 0.1) * (seen([px + aside, py, pz], stand, WIDE)[0] as number)).toBeGreaterThan(1);
  });

  it("goes below the picture from behind who is in it, and from between them", () => {
    expect(clear({ a: 1 }, beside(0.15, 1), "b")).toEqual({ aside: expect.anything(), sunk: 1 });
    const row = new Map([
      ["a", head(-0.35)],
      ["b", head(0)],
      ["c", head(0.35)],
    ]);
    expect(clear({ "a+c": 1 }, row, "b")).toEqual({ aside: expect.closeTo(0), sunk: 1 });
  });

  it("is somewhere else a little for a place or a weight that is a little different", () => {
    let [before, changed] = [clear({ a: 1 }, beside(-1), "b"), 0];
    for (let x = -1; x < 1; x += 0.001) {
      const now = clear({ a: 1 }, beside(x), "b");
      expect(Math.abs(now.aside - before.aside)).toBeLessThan(0.02);
      expect(Math.abs(now.sunk - before.sunk)).toBeLessThan(0.02);
      changed += Math.abs(now.sunk - before.sunk);
      before = now;
    }
    expect(changed).toBeCloseTo(2);
    const full = clear({ a: 1 }, beside(0.35), "b").aside;
    for (const part of [0, 0.3, 1])
      expect(clear({ a: part, "*": 1 - part }, beside(0.35), "b").aside).toBeCloseTo(part * full, 12);
  });

  it("stays where it is in the shot of all, in a shot that holds it, and of somebody who is gone", () => {
    for (const key of ["*", "b", "a+b", "gone"]) expect(clear({ [key]: 1 }, beside(0.35), "b")).toEqual(NO_CLEARANCE);
    expect(clear({ a: 1 }, beside(3), "b").aside).toBe(0); // far enough away as it is
  });
});
