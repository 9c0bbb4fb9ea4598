import { describe, expect, it } from "vitest";
import type { Library } from "../../link/assets";
import type { HairStrands } from "../../link/strands";
import { createHairStock, HairAssignment } from "./hair_assignment";
import { fullStrands, offsetsOn } from "./hair_strands";

const hair: HairStrands = {
  stations: 3,
  links: 1,
  width: 0.004,
  points: Float32Array.from([0, 0, 0, 0, 1, 0, 0, 2, 0]),
  rows: Uint32Array.from([0, 0, 0]),
  weights: Float32Array.from([1, 1, 1]),
  anchors: Uint32Array.from([0]),
  facing: new Int8Array(9),
  light: new Uint8Array(3),
  fullness: new Float32Array(1).fill(1),
};
const generic = new Float32Array(3);

/** A library of two faces, one with a bob; `come` lets the strands arrive. */
function late(): { library: Library; come: () => void } {
  let come = (): void => undefined;
  const waiting = new Promise<HairStrands>((resolve) => {
    come = () => resolve(hair);
  });
  const faces = [
    { name: "kaori", look: { hair_style: "bob" } },
    { name: "dog", look: { hair_style: "" } },
  ];
  const faceByName = new Map(faces.map((face) => [face.name, face]));
  const library = {
    faces: faceByName,
    meshes: [],
    manifest: { skin: 1 },
    hasFace: (face: string) => faceByName.has(face),
    positions: async () => generic,
    hair: () => waiting,
  };
  return { library: library as unknown as Library, come };
}

describe("the assignment of hair", () => {
  it("lets a style that comes late grow in, without a jump", async () => {
    const { library, come } = late();
    const assignment = new HairAssignment(
      library,
      generic,
      createHairStock(library, generic, () => 1),
    );
    const on = new Map([["kaori", 1]]);
    assignment.want(["kaori", "nobody"]);
    assignment.dress(on, 1, false);
    expect(assignment.worn.size).toBe(0);
    expect(assignment.settled).toBe(false); // else whoever draws only what changes would leave her bald
    come();
    await assignment.complete();
    expect(assignment.settled).toBe(false);
    const grown: number[] = [];
    for (let frame = 0; frame < 20; frame++) {
      assignment.dress(on, 1 / 60, false);
      grown.push(assignment.worn.get("bob")?.grown as number);
    }
    expect(grown.at(-1)).toBe(1);
    expect(assignment.settled).toBe(true);
    grown.forEach((value, frame) => {
      const before = grown[frame - 1] ?? 0;
      expect(value).toBeGreaterThanOrEqual(before);
      expect(value - before).toBeLessThan(0.2);
    });
  });

  it("shows all at once when it is told to, and nothing when nobody wears it", async () => {
    const { library, come } = late();
    const assignment = new HairAssignment(
      library,
      generic,
      createHairStock(library, generic, () => 1),
    );
    assignment.want(["kaori", "dog"]);
    come();
    await assignment.complete();
    assignment.dress(new Map([["kaori", 1]]), 0, true);
    const bob = assignment.worn.get("bob");
    expect(bob?.grown).toBe(1);
    expect(bob?.strands[5]).toBe(1);
    expect(fullStrands(hair, offsetsOn(hair, generic, generic))).toEqual(bob?.strands); // what one face alone wears
    assignment.dress(new Map([["dog", 1]]), 0, false);
    expect(bob?.grown).toBe(0);
  });

  it("keeps styles by name, in whatever order they come", async () => {
    for (const order of [
      ["kaori", "old"],
      ["old", "kaori"],
    ]) {
      const { library, come } = late();
      (library.faces as Map<string, unknown>).set("old", { name: "old", look: { hair_style: "thin" } });
      const assignment = new HairAssignment(
        library,
        generic,
        createHairStock(library, generic, () => 1),
      );
      for (const face of order) assignment.want([face]);
      come();
      await assignment.complete();
      expect([...assignment.worn.keys()]).toEqual(["bob", "thin"]); // sums and overlaps would differ in the last bit
    }
  });
});
