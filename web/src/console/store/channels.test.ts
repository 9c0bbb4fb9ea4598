import { describe, expect, it } from "vitest";
import type { ExpressionDocument } from "../../link/messages";
import { byRegion, mirrorOf, REGIONS, regionOf, sideOf, stripsOf, withoutSide } from "./channels";

const unit = (name: string, kind: ExpressionDocument["kind"] = "arkit", region = ""): ExpressionDocument => ({
  name,
  label: name,
  kind,
  region,
  eyes: [0, 0, 0, 0],
  pupil: 0,
  complexion: [0, 0, 0, 0, 0, 0, 0],
  source: name,
  tags: [],
  place: 0,
  head: [0, 0, 0],
});

describe("the region of an expression", () => {
  it("is the one its document names, in one or many", () => {
    expect(regionOf(unit("anything", "arkit", "eyes"))).toBe("eyes");
    expect(regionOf(unit("anything", "arkit", "Brow"))).toBe("brows");
  });

  it("is read from its name where the document says nothing", () => {
    const names = { browDownLeft: "brows", "eyebrows-left-up": "brows", "eye-left-slit": "eyes", jawOpen: "jaw" };
    for (const [name, region] of Object.entries(names)) expect(regionOf(unit(name))).toBe(region);
  });

  it("is the whole face for what is performed, and for what nobody knows", () => {
    expect(regionOf(unit("mouthy", "performed", "whole"))).toBe("face");
    expect(regionOf(unit("strange"))).toBe("face");
  });

  it("holds every expression exactly once, from the brows down, and not the neutral one", () => {
    const all = [unit("jawOpen"), unit("browInnerUp"), unit("smile", "performed"), unit("neutral", "neutral")];
    const regions = byRegion(all);
    expect([...regions.keys()]).toEqual(["brows", "jaw", "face"]);
    expect([...regions.keys()].every((region) => REGIONS.includes(region))).toBe(true);
    expect([...regions.values()].flat().map(({ name }) => name)).toEqual(["browInnerUp", "jawOpen", "smile"]);
  });
});

describe("sides", () => {
  it("are read from both ways of writing", () => {
    expect(sideOf("mouthSmileLeft")).toEqual({ side: "left", stem: "mouthSmile" });
    expect(sideOf("eyebrows-right-inner-up")).toEqual({ side: "right", stem: "eyebrows-inner-up" });
    expect(sideOf("jawOpen")).toEqual({ side: null, stem: "jawOpen" });
  });

  it("are not seen in directions: the right of jawLeft is its opposite", () => {
    for (const name of ["jawLeft", "jawRight", "mouthLeft", "mouthRight"]) expect(sideOf(name).side).toBeNull();
  });
});

describe("strips", () => {
  const strips = stripsOf([unit("mouthSmileLeft"), unit("mouthClose"), unit("mouthSmileRight"), unit("mouthLeft")]);

  it("join the sides under one name, the character's right first: the operator looks at the face", () => {
    expect(strips.map(({ unit }) => unit)).toEqual(["mouthSmile", "mouthClose", "mouthLeft"]);
    expect(strips[0]?.channels.map(({ name }) => name)).toEqual(["mouthSmileRight", "mouthSmileLeft"]);
  });

  it("know what moves the same on the other side", () => {
    expect(mirrorOf("mouthSmileLeft", strips)).toBe("mouthSmileRight");
    expect(mirrorOf("mouthSmileRight", strips)).toBe("mouthSmileLeft");
    expect(mirrorOf("mouthClose", strips)).toBeNull();
    expect(mirrorOf("nothing", strips)).toBeNull();
  });

  it("keep channels of different sets apart", () => {
    expect(stripsOf([unit("a-left-b"), unit("a-right-b", "makehuman")])).toHaveLength(2);
  });

  it("are named as people say it, the side left to their place", () => {
    expect(withoutSide("Brow down, left")).toBe("Brow down");
    expect(withoutSide("Jaw to the left")).toBe("Jaw to the left");
    const [pair] = stripsOf([{ ...unit("browDownLeft"), label: "Brow down, left" }]);
    expect(pair).toMatchObject({ label: "Brow down", unit: "browDown" });
  });
});
