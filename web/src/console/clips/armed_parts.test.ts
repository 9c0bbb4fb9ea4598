import { describe, expect, it } from "vitest";
import { CLIP_PARTS } from "../../link/constants";
import { armedAfter, armingOf } from "./armed_parts";

const ALL = new Set(CLIP_PARTS);

describe("the parts that are armed", () => {
  it("are one alone by a plain press, and more or less of them by Shift", () => {
    expect([...armedAfter(ALL, "mouth", "only")]).toEqual(["mouth"]);
    expect([...armedAfter(new Set(["mouth"]), "mouth", "only")]).toEqual(["mouth"]);
    expect([...armedAfter(new Set(["mouth"]), "brows", "beside")]).toEqual(["brows", "mouth"]);
    expect([...armedAfter(new Set(["mouth"]), "mouth", "beside")]).toEqual([]);
  });

  it("are one alone by the first touch, then more or less, and never none", () => {
    expect([...armedAfter(ALL, "mouth", "touch")]).toEqual(["mouth"]);
    expect([...armedAfter(new Set(["mouth"]), "head", "touch")]).toEqual(["mouth", "head"]);
    expect([...armedAfter(new Set(["mouth"]), "mouth", "touch")]).toEqual([...CLIP_PARTS]);
  });

  it("are armed by clicks as by keys", () => {
    const plain = { shiftKey: false, ctrlKey: false, metaKey: false };
    expect([armingOf(plain, false), armingOf(plain, true)]).toEqual(["only", "touch"]);
    expect([armingOf({ ...plain, ctrlKey: true }, false), armingOf({ ...plain, shiftKey: true }, true)]).toEqual([
      "beside",
      "beside",
    ]);
  });
});
