import { describe, expect, it } from "vitest";
import { STRETCH } from "../../link/constants";
import type { HairStrands } from "../../link/strands";
import { drawnStrands, lengthAt, mixOffsets, offsetsOn, styleWeights } from "./hair_strands";

/** One strand of two places over two rows of skin. */
const hair: HairStrands = {
  stations: 2,
  links: 2,
  width: 0.004,
  points: Float32Array.from([0, 0, 0, 0.5, 1, 0]),
  rows: Uint32Array.from([0, 1, 0, 1]),
  weights: Float32Array.from([1, 0, 0.5, 0.5]),
  anchors: Uint32Array.from([0]),
  facing: new Int8Array(6),
  light: new Uint8Array(2),
  fullness: new Float32Array(1).fill(1),
};
const generic = Float32Array.from([0, 0, 0, 1, 0, 0]);
const wide = Float32Array.from([-0.2, 0, 0, 1.4, 0, 0]);
const torn = Float32Array.from([-9, 0, 0, 30, 8, 0]);

describe("offsets", () => {
  it("are the strand itself on the face it was made on", () => {
    expect([...offsetsOn(hair, generic, generic)]).toEqual([0, 0, 0, 0.5, 1, 0]);
  });

  it("do not change when the face only shifts", () => {
    const shifted = generic.map((value) => value + 0.25);
    expect([...offsetsOn(hair, generic, shifted)]).toEqual([...offsetsOn(hair, generic, generic)]);
  });

  it("keep every piece of a strand, however far the skin beneath is torn apart", () => {
    const offsets = offsetsOn(hair, generic, torn);
    const [before, piece] = [
      [0.5, 1, 0],
      [0, 1, 2].map((axis) => (offsets[3 + axis] as number) - (offsets[axis] as number)),
    ];
    const change = Math.hypot(...piece.map((value, axis) => value - (before[axis] as number)));
    expect(change).toBeCloseTo(STRETCH * Math.hypot(...before));
  });

  it("of a mix of faces are the mix of their offsets", () => {
    const half = generic.map((value, at) => (value + (wide[at] as number)) / 2);
    const mixed = new Float32Array(8);
    mixOffsets(
      [generic, wide].map((face) => [offsetsOn(hair, generic, face), 0.5] as const),
      mixed,
    );
    const wanted = offsetsOn(hair, generic, half);
    for (let place = 0; place < 2; place++)
      for (let axis = 0; axis < 3; axis++)
        expect(mixed[4 * place + axis]).toBeCloseTo(wanted[3 * place + axis] as number);
  });
});

describe("a style", () => {
  it("is as long as its weight says, from nothing to all, and never jumps", () => {
    expect([lengthAt(-0.1), lengthAt(0), lengthAt(1), lengthAt(1.1)]).toEqual([0, 0, 1, 1]);
    expect([lengthAt(0.05), lengthAt(0.25)]).toEqual([0, 1]); // most of the way to who is bald it is one of the two
    for (let step = 1; step <= 200; step++) {
      const [before, after] = [lengthAt((step - 1) / 200), lengthAt(step / 200)];
      expect(after).toBeGreaterThanOrEqual(before);
      expect(after - before).toBeLessThan(0.05);
    }
  });

  it("keeps enough strands to cover a head at any level", () => {
    const style = (count: number): HairStrands => ({ ...hair, anchors: new Uint32Array(count) });
    expect(drawnStrands(style(1600), 1)).toBe(1600);
    expect(drawnStrands(style(1600), 0.5)).toBe(800);
    expect(drawnStrands(style(500), 0.5)).toBe(350);
    expect(drawnStrands(style(300), 0.5)).toBe(300);
  });

  it("weighs what the faces that wear it weigh; a face without hair wears none", () => {
    const faces = new Map([
      ["kaori", 0.4],
      ["doll", 0.3],
      ["man", 0.3],
      ["dog", 0.1],
      ["old", -0.1],
    ]);
    const styles: Record<string, string> = { kaori: "bob", doll: "bob", man: "short", dog: "", old: "thin" };
    const weightsByStyle = styleWeights(faces, (face) => styles[face] as string);
    expect([...weightsByStyle.keys()]).toEqual(["bob", "short"]);
    expect(Object.fromEntries(weightsByStyle.get("bob") as Map<string, number>)).toEqual({ kaori: 0.4, doll: 0.3 });
  });
});
