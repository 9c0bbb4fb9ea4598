import { expect, test } from "vitest";
import { mixSkinTraits, SKIN_TRAITS, type SkinTraits, skinUniforms } from "./skin_layers";

const traits = (value: number): SkinTraits =>
  Object.fromEntries(SKIN_TRAITS.map((name, index) => [name, value / (index + 1)])) as SkinTraits;

test("traits are linear in the weights of the faces", () => {
  const [one, other] = [traits(1), traits(0.25)];
  for (const share of [0, 0.3, 0.5, 1]) {
    const mixed = mixSkinTraits([
      [one, 1 - share],
      [other, share],
    ]);
    for (const name of SKIN_TRAITS) expect(mixed[name]).toBeCloseTo((1 - share) * one[name] + share * other[name], 12);
  }
});

test("one face alone wears its own traits, and other fields of its look stay out", () => {
  const look = { ...traits(0.5), skin: "#ffffff" };
  expect(mixSkinTraits([[look, 1]])).toEqual(traits(0.5));
});

test("a skin without pictures is plain: every layer is one texel", () => {
  const uniforms = skinUniforms();
  for (const name of ["mask", "marks", "patches", "relief", "finish", "pelt"] as const)
    expect(uniforms[name].value.image).toMatchObject({ width: 1, height: 1 });
  for (const name of SKIN_TRAITS) expect(uniforms[name].value).toBe(0);
});
