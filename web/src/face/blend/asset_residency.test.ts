import { describe, expect, it } from "vitest";
import type { Compound, Library } from "../../link/assets";
import { type Pose, restPose } from "../pose/pose";
import { AssetResidency } from "./asset_residency";
import type { Blender } from "./blender";
import { LayerTable } from "./layer_table";

const compound: Compound = { scale: 1, indices: new Uint32Array(), deltas: new Int16Array(), allowed: undefined };

/** A library of one face whose compounds come when told, and one that has been refused. */
function late(): { library: Library; come: () => void } {
  let come = (): void => undefined;
  const waiting = new Promise<Compound>((resolve) => {
    come = () => resolve(compound);
  });
  const library = {
    hasFace: (face: string) => face === "dog",
    hasExpression: (name: string) => name.startsWith("#"),
    expressions: new Map([["#limb", { kind: "limb" }]]),
    positions: async () => new Float32Array(3),
    compound: (_: string, name: string) => (name === "#refused" ? Promise.reject(new Error("404")) : waiting),
  };
  return { library: library as unknown as Library, come };
}

const layers = (): Blender =>
  ({
    layers: new LayerTable(8, 8),
    blankLayer: () => new Float32Array(4),
    upload: () => undefined,
  }) as unknown as Blender;

describe("what a stage holds", () => {
  it("is away until it is loaded, here until it is drawn in full, then shown", async () => {
    const { library, come } = late();
    const [residency, blender] = [new AssetResidency(library), layers()];
    const arrival = () => residency.arrival(["dog"], ["#1", "neutral"], blender);
    residency.want(["dog"], ["#1"]);
    expect(arrival()).toBe("away");
    come();
    await residency.complete();
    expect(arrival()).toBe("here");
    const pose = { ...restPose("dog"), expressions: { neutral: 0.999, "#1": 0.001 } };
    residency.advance([pose], blender, 0, false);
    expect(arrival()).toBe("shown"); // next to nothing of it shows, so it needs no easing
  });

  it("asks for no compound of what plays limbs alone, which is shown at once", async () => {
    const { library } = late();
    const [residency, blender] = [new AssetResidency(library), layers()];
    residency.want(["dog"], ["#limb"]);
    await residency.complete();
    const pose = { ...restPose("dog"), channels: { "#limb": 1 } };
    residency.advance([pose], blender, 0, true);
    expect(residency.shownInFull(pose, blender)).toBe(true);
  });

  it("adds up what differs in regions by their masks, and without masks shows the whole face's", async () => {
    const allowed = { places: new Uint32Array([1, 2]), values: new Float32Array([10, 100]) };
    const library = { ...late().library, compound: async () => ({ ...compound, allowed }) } as unknown as Library;
    const masks = Float32Array.from([1, 0, 0, 0, 0, 0.25, 0.75, 0, 0, 0, 0, 1]);
    const regional = { ...restPose("dog"), regions: { eyes: { "#1": 1 }, mouth: { neutral: 0.5, "#1": 0.5 } } };
    const mixOf = async (residency: AssetResidency, pose: Pose = regional) => {
      const blender = layers();
      Object.assign(library, {
        hasFace: () => true,
        hasExpression: () => true,
        positions: async () => new Float32Array(3),
      });
      residency.want(["dog"], ["#1"]);
      await residency.complete();
      residency.advance([pose], blender, 0, true);
      return residency.mix(pose, blender, new Float32Array(3));
    };
    const mix = await mixOf(new AssetResidency(library, masks));
    expect([mix.entries.length, mix.regional.map(({ weights }) => weights)]).toEqual([1, [[0, 1, 0.5, 0]]]);
    expect([...(mix.allowed ?? [])]).toEqual([0, 10 * (0.25 + 0.75 * 0.5), 0]);
    const whole = await mixOf(new AssetResidency(library));
    expect([whole.entries.length, whole.regional, whole.allowed]).toEqual([1, [], undefined]);
    const worn = async (weight: number) =>
      (await mixOf(new AssetResidency(library), { ...restPose("dog"), channels: { "#1": weight } })).allowed;
    expect(await worn(1)).toBe(undefined); // one compound alone needs no correctives
    expect([...((await worn(1.5)) ?? [])]).toEqual([0, 10, 100]); // and beyond its end is allowed no more than there
  });

  it("counts what was refused, and what nobody has, as shown: nothing waits for it", async () => {
    const { library } = late();
    const [residency, blender] = [new AssetResidency(library), layers()];
    residency.want(["dog"], ["#refused"]);
    await residency.complete();
    residency.advance([restPose("dog")], blender, 0, true);
    expect(residency.arrival(["dog", "nobody"], ["#refused", "nothing"], blender)).toBe("shown");
  });
});
