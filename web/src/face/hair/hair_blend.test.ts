import { describe, expect, it } from "vitest";
import { type Arc, arcStyle, BALL } from "./arc_style";
import { type CarriedStyle, HairBlend } from "./hair_blend";
import { lengthAt } from "./hair_strands";
import { radialMap, radiusOf } from "./radial_map";

const forward: Arc = { root: [0, 1, 0], toward: [0.7, 0, 1], length: 1, height: 0.006 };
const aside: Arc = { root: [0, 1, 0.02], toward: [-0.7, 0, 1], length: 0.6, height: 0.01 };
const nape: Arc = { root: [0, 0, -1], toward: [0, -1, 0], length: 0.5, height: 0.004 };
const coil: Arc = { root: [0, 1, 0], toward: [0, 0, -1], length: 4.5, height: 0.01 };

/** A style on the face that it was made on, whose row 0 lies at the origin. */
function worn(arcs: readonly Arc[], scalp = 1): CarriedStyle & { into: Float32Array } {
  const hair = arcStyle(arcs);
  const carried = new Float32Array((4 * hair.points.length) / 3);
  hair.points.forEach((value, at) => {
    carried[4 * Math.floor(at / 3) + (at % 3)] = value;
  });
  return { hair, carried, scalp, into: new Float32Array(carried.length) };
}

/** Only the octahedron's directions are here: the map's holes are filled with the ball. */
const ball = radialMap(Float32Array.from([0, BALL + 0.03, 0.045, 0, BALL + 0.03, 0.045, 0, BALL + 0.03, 0.045]), [
  Uint32Array.from([0, 1, 2]),
]);

const blend = (painted = 1): HairBlend =>
  new HairBlend(
    () => ball,
    () => painted,
  );

/** The length, the width and the whole length of a strand. */
const lengthAndScalp = ({ hair, into }: ReturnType<typeof worn>, strand = 0): number[] =>
  [3, 7, 11].map((at) => into[4 * strand * hair.stations + at] as number);

const place = ({ into }: ReturnType<typeof worn>, at: number): [number, number, number] =>
  Array.from(into.subarray(4 * at, 4 * at + 3)) as [number, number, number];

describe("a blend of hair styles", () => {
  it("of one style alone is that style, as long as its weight says", () => {
    const bob = worn([forward, nape]);
    for (const weight of [1, 0.5, 0.15]) {
      expect(blend().write(bob, new Map([[bob, weight]]), bob.into, 2)).toBeCloseTo(lengthAt(weight));
      expect(lengthAndScalp(bob)[0]).toBeCloseTo(lengthAt(weight));
      expect(lengthAndScalp(bob)[1]).toBe(1);
      for (let at = 0; at < bob.hair.stations; at++)
        for (let axis = 0; axis < 3; axis++)
          expect(place(bob, at)[axis]).toBeCloseTo(bob.carried[4 * at + axis] as number);
    }
  });

  it("shapes every strand as if it were alone", () => {
    const both = [worn([forward, nape]), worn([aside, coil])] as const;
    const weights = new Map(both.map((style) => [style, 0.5]));
    const one = blend();
    one.write(both[0], weights, both[0].into, 2);
    const second = both[0].into.slice(both[0].into.length / 2);
    one.write(both[0], weights, both[0].into, 1);
    one.write(both[1], weights, both[1].into, 2);
    one.write(both[0], weights, both[0].into, 2);
    expect(both[0].into.slice(both[0].into.length / 2)).toEqual(second);
  });

  it("of two styles leads every strand from one course to the other, over the scalp", () => {
    const [bob, crop] = [worn([forward]), worn([aside])];
    const last = bob.hair.stations - 1;
    const tips = (share: number): number[] => {
      const weights = new Map([
        [bob, share],
        [crop, 1 - share],
      ]);
      const led = share < 0.5 ? crop : bob; // a strand of the lighter style is not drawn, hence not shaped
      blend().write(led, weights, led.into, 1);
      for (let at = 1; at <= last; at++) expect(radiusOf(...place(led, at))).toBeGreaterThan(BALL);
      return place(led, last);
    };
    const way = Array.from({ length: 21 }, (_, step) => tips(step / 20)[0] as number);
    expect(way[20]).toBeCloseTo(bob.carried[4 * last] as number);
    expect(way[0]).toBeCloseTo(crop.carried[4 * last] as number);
    for (let step = 1; step < way.length; step++) {
      const gone = (way[step] as number) - (way[step - 1] as number);
      expect(gone).toBeGreaterThan(0);
      expect(gone).toBeLessThan(0.01); // where one style takes over the other's lead too
    }
  });

  it("draws the heavier style alone, both where they weigh the same, and never less than one of them", () => {
    const [bob, crop] = [worn([forward]), worn([aside])];
    for (let step = 1; step < 40; step++) {
      const weights = new Map([
        [bob, step / 40],
        [crop, 1 - step / 40],
      ]);
      const shown = [bob, crop].map((hairStyle) => {
        blend().write(hairStyle, weights, hairStyle.into, 1);
        return lengthAndScalp(hairStyle)[1] as number;
      });
      expect(Math.max(...shown)).toBe(1);
      if (Math.abs(step - 20) > 10) expect(Math.min(...shown)).toBe(0);
      if (step === 20) expect(shown).toEqual([1, 1]);
    }
  });

  it("shortens hair where the other style has none, however light that style is", () => {
    const [bob, thin] = [worn([forward, nape]), worn([nape])];
    const weights = new Map([
      [bob, 0.15],
      [thin, 0.85],
    ]);
    blend().write(bob, weights, bob.into, 2);
    expect(lengthAndScalp(bob, 0)[0]).toBeCloseTo(lengthAt(0.15, 0));
    expect(lengthAndScalp(bob, 0)[1]).toBe(1);
    expect(lengthAndScalp(bob, 1)[0]).toBe(1);
    expect(lengthAndScalp(bob, 1)[1]).toBeLessThan(0.1);
  });

  it("grows later where the scalp is bare, and is whole with all its weight", () => {
    const lengths = [worn([forward]), worn([forward], 0.3)].flatMap((hairStyle) =>
      [1, 0.5].map((painted) => {
        blend(painted).write(hairStyle, new Map([[hairStyle, 0.2]]), hairStyle.into, 1);
        const [length] = lengthAndScalp(hairStyle) as [number];
        blend(painted).write(hairStyle, new Map([[hairStyle, 1]]), hairStyle.into, 1);
        expect(lengthAndScalp(hairStyle)[0]).toBe(1);
        return length;
      }),
    );
    expect(lengths).toEqual([...lengths].sort((a, b) => b - a));
    expect(new Set(lengths).size).toBe(4);
  });

  it("lets what is wound up sink into the head instead of cutting it", () => {
    const bun = worn([coil]);
    const sizes = [1, 0.17, 0.12].map((weight) => {
      blend().write(bun, new Map([[bun, weight]]), bun.into, 1);
      expect(lengthAndScalp(bun).slice(0, 2)).toEqual([1, 1]);
      return Math.hypot(...place(bun, 4));
    });
    expect(sizes[1]).toBeCloseTo((sizes[0] as number) * lengthAt(0.17));
    expect(sizes[2]).toBeCloseTo((sizes[0] as number) * lengthAt(0.12));
  });

  it("writes no more strands than are drawn", () => {
    const bob = worn([forward, nape]);
    blend().write(bob, new Map([[bob, 1]]), bob.into, 1);
    expect([...bob.into.subarray(4 * bob.hair.stations)].every((value) => value === 0)).toBe(true);
  });
});
