import * as THREE from "three";
import { describe, expect, it } from "vitest";
import { headUniforms } from "../head/head";
import { SKIN_TRAITS } from "./skin_layers";
import { lookOf } from "./skin_paint";
import { PAINT_FRAGMENT } from "./skin_paint_shaders";

describe("what a skin is painted by", () => {
  it("differs with every colour, trait, layer and picture that is painted, however little", () => {
    const uniforms = headUniforms(null, null);
    const seen = new Set([lookOf(uniforms)]);
    const changes = [
      ...(["skin", "lip", "brow", "blush", "coat"] as const).map(
        (name) => () => uniforms[name].value.setRGB(0, 0, 1e-6),
      ),
      ...SKIN_TRAITS.filter((name) => name !== "scalp").map((name) => () => {
        uniforms[name].value += 1e-6;
      }),
      ...(["mask", "marks", "patches", "pelt", "picture0", "picture3"] as const).map((name) => () => {
        uniforms[name].value = new THREE.Texture();
      }),
      () => uniforms.pictureWeights.value.set(0, 0, 0, 1e-6),
      () => uniforms.pictured.value.coat.setRGB(0, 1e-6, 0),
      () => {
        uniforms.pictured.value.stripes = 1e-6;
      },
      () => {
        uniforms.mask.value.needsUpdate = true; // the same texture with something else in it
      },
    ];
    for (const change of changes) {
      change();
      seen.add(lookOf(uniforms));
    }
    expect(seen.size).toBe(changes.length + 1);
  });

  it("is the same whatever the light, the pose, and the hair on the scalp", () => {
    const uniforms = headUniforms(null, null);
    const before = lookOf(uniforms);
    uniforms.KEY_LIGHT.value.set(3, 2, 1);
    uniforms.headTurn.value.set(0, 1, 0, -1, 0, 0, 0, 0, 1);
    uniforms.hair.value.setRGB(1, 0, 0);
    uniforms.scalp.value = 1;
    expect(lookOf(uniforms)).toBe(before);
  });

  it("is all that its shader is told, but for hair on the scalp, which is left to the vertices", () => {
    const uniformNames = [...PAINT_FRAGMENT.matchAll(/^uniform \w+ (\w+);/gm)].map(([, name]) => name as string);
    const uniforms = headUniforms(null, null);
    for (const name of uniformNames.filter((name) => name !== "hair" && name !== "scalp")) {
      const before = lookOf(uniforms);
      const uniform = uniforms[name] as THREE.IUniform;
      uniform.value = new THREE.Texture();
      expect(lookOf(uniforms), name).not.toBe(before);
    }
  });
});
