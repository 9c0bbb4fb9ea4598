import { expect, it, vi } from "vitest";
import type { FaceDocument } from "../../../link/messages";
import type { HairStrands } from "../../../link/strands";
import type { FaceHair } from "../draw/hair_painter";
import { HairCache } from "./hair_cache";

const face = (source: string, hair_style: string, hair = "#101010") => ({
  source,
  document: { look: { hair_style, hair } } as FaceDocument,
  rest: new Float32Array(),
});

function cache(strands: Promise<HairStrands>) {
  const [made, dropped, arrived, asked]: [FaceHair[], FaceHair[], string[], string[]] = [[], [], [], []];
  const painter = {
    make: () => {
      made.push({} as FaceHair);
      return made.at(-1) as FaceHair;
    },
    drop: (hair: FaceHair) => void dropped.push(hair),
  };
  const hair = (style: string) => {
    asked.push(style);
    return strands;
  };
  return { cache: new HairCache({ hair }, painter, () => arrived.push("")), made, dropped, arrived, asked };
}

const later = (): Promise<void> => new Promise((done) => setTimeout(done));

it("waits for a style once, then poses it once on each face", async () => {
  const { cache: hair, made, arrived, asked } = cache(Promise.resolve({} as HairStrands));
  expect(hair.of(face("kaori", "bob"))).toBe("awaited");
  expect(hair.of(face("child", "bob"))).toBe("awaited");
  await later();
  expect([asked, arrived.length]).toEqual([["bob"], 1]);
  expect(hair.of(face("kaori", "bob"))).toBe(made[0]);
  expect(hair.of(face("kaori", "bob"))).toBe(made[0]);
  expect(hair.of(face("child", "bob"))).toBe(made[1]);
  expect(hair.of(face("kaori", "bob", "#ffffff"))).toBe(made[2]); // dyed
  expect(hair.of(face("dog", ""))).toBeUndefined();
});

it("draws a face bald whose style cannot be had, instead of waiting for ever", async () => {
  const warn = vi.spyOn(console, "warn").mockImplementation(() => undefined);
  const { cache: hair, arrived } = cache(Promise.reject(new Error("404")));
  expect(hair.of(face("kaori", "bob"))).toBe("awaited");
  await later();
  expect(hair.of(face("kaori", "bob"))).toBeUndefined();
  expect(arrived).toHaveLength(1);
  expect(warn).toHaveBeenCalled();
  warn.mockRestore();
});

it("forgets the hair that was used longest ago, never that of a face that is shown", async () => {
  const { cache: hair, made, dropped } = cache(Promise.resolve({} as HairStrands));
  hair.of(face("shown", "bob"));
  await later();
  for (let n = 0; n < 40; n++) {
    expect(hair.of(face("shown", "bob"))).toBe(made[0]);
    hair.of(face(`#${n}`, "bob"));
  }
  expect(dropped.length).toBeGreaterThan(20);
  expect(dropped).toEqual(made.slice(1, 1 + dropped.length));
});
