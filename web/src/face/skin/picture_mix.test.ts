import * as THREE from "three";
import { describe, expect, it } from "vitest";
import {
  dressPictures,
  PAINTED_COLOURS,
  PAINTED_TRAITS,
  PICTURES,
  type PictureShare,
  pictureUniforms,
} from "./picture_mix";

const blank = new THREE.Texture();

/** A face of one grey and one number for all of its traits; with a picture where `grown` says how far it has grown in. */
function face(weight: number, grey: number, grown?: number): PictureShare {
  const colours = PAINTED_COLOURS.map((name) => [name, new THREE.Color(grey, grey, grey)]);
  const traits = PAINTED_TRAITS.map((name) => [name, grey]);
  return {
    weight,
    look: { ...Object.fromEntries(colours), traits: Object.fromEntries(traits) },
    picture: grown === undefined ? undefined : { texture: new THREE.Texture(), grown },
  };
}

const dressed = (...shares: PictureShare[]) => {
  const uniforms = pictureUniforms(blank);
  dressPictures(shares, uniforms);
  return uniforms;
};

describe("pictures of skin", () => {
  it("weigh nothing where no face has one", () => {
    expect(dressed(face(0.5, 0.2), face(0.5, 0.4)).pictureWeights.value.toArray()).toEqual([0, 0, 0, 0]);
    expect(dressed().picture0.value).toBe(blank);
  });

  it("weigh as their faces, as far as they have grown in", () => {
    const [painted, half, whole] = [face(0.5, 0.1), face(0.2, 0.6, 0.5), face(0.3, 0.9, 1)];
    const { pictureWeights, picture0, picture1, pictured } = dressed(painted, half, whole);
    expect(pictureWeights.value.x).toBeCloseTo(0.3);
    expect(pictureWeights.value.y).toBeCloseTo(0.1);
    expect([picture0.value, picture1.value]).toEqual([whole.picture?.texture, half.picture?.texture]);
    for (const name of PAINTED_TRAITS) expect(pictured.value[name]).toBeCloseTo(0.75 * 0.9 + 0.25 * 0.6);
    for (const name of PAINTED_COLOURS) expect(pictured.value[name].g).toBeCloseTo(0.75 * 0.9 + 0.25 * 0.6);
  });

  it("of more faces than there are samplers stand for all of them", () => {
    const shares = Array.from({ length: 6 }, (_, at) => face((at + 1) / 21, 0.5, 1));
    const { pictureWeights, picture0 } = dressed(...shares);
    expect(pictureWeights.value.toArray().reduce((sum, weight) => sum + weight)).toBeCloseTo(1);
    expect(picture0.value).toBe(shares[5]?.picture?.texture);
    expect(pictureWeights.value.toArray()).toHaveLength(PICTURES.length);
  });
});
