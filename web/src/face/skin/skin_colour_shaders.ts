/** Shader code of the skin's own colour. */

import { PAINTED_COLOURS, PAINTED_TRAITS, PICTURES } from "./picture_mix";

const PAINTED = [...PAINTED_COLOURS, ...PAINTED_TRAITS];

/** The scalp under hair: by a vertex's hairline, and by the strands that are painted there (0..1). */
export const SCALP_COLOURS = `
uniform vec3 hair;
uniform float scalp;

float stubbled(float hairline, float strands) {
  return smoothstep(0.15, 0.9, hairline + (strands - 0.5) * 2.8 * hairline * (1.0 - hairline));
}

vec3 scalpHair(float strands) { return hair * (0.7 + 0.6 * strands); }
`;

/**
 * The skin's own colour: every layer of the cast's picture, weighed by the traits of the faces on air. All of it is a sum
 * of traits, so nothing pops while faces mix. Over it the pictures of certain people, by the weights of their faces, in
 * linear light; make-up, a mask's paint and stubble of the scalp lie on these too. Needs `layer(sampler2D)`.
 */
export const SKIN_COLOURS = `${SCALP_COLOURS}
uniform sampler2D mask;
uniform sampler2D marks;
uniform sampler2D patches;
uniform sampler2D pelt;
uniform vec3 ${PAINTED_COLOURS.join(", ")};
uniform float ${PAINTED_TRAITS.join(", ")}, makeup, lacquer;
uniform sampler2D ${PICTURES.join(", ")};
uniform vec4 pictureWeights;

/** What a look says of the painted skin alone. */
struct Painted { vec3 ${PAINTED_COLOURS.join(", ")}; float ${PAINTED_TRAITS.join(", ")}; };
uniform Painted pictured; // the mean of the faces that have pictures

const float RIM = 0.22; // of the brows' colour, the dark skin along lids and lips under fur

/** The skin's layers at one place (tools/baking paints them). */
struct Layers {
  vec4 mask; // lips, brows, blush, light that is left
  vec4 marks; // age, freckles, stubble, strands of fur
  vec4 patches; // leather, dark rims, make-up, paint of a mask
  vec4 finish; // oil, thinness, fine hollows, mottling of the blood
  vec4 pelt; // a hound's pale and dark fur, a tabby's pale and dark fur
};

/**
 * What the light falls on: the colour, how much of it is lip, hair (brows too), fur, bare leather, or lining (0..1 each),
 * and what light is left, which the colour has in it.
 */
struct Ground { vec3 albedo; float lips; float hair; float fur; float leather; float lining; float left; };

/** How much a brow's hairs cover: the thinner the brow, the higher the threshold. */
float browHairs(float drawn, float brows) { return clamp((drawn - mix(1.0, -0.12, brows)) * 2.3, 0.0, 1.0); }

/** The light of the pictures times how far they cover this place, and that: a weighted sum over the faces. */
vec4 pictures() {
  vec4 sum = vec4(0.0);
  vec4 seen;
${PICTURES.map((name, at) => `  if (pictureWeights[${at}] != 0.0) { seen = layer(${name}); sum += pictureWeights[${at}] * vec4(seen.rgb, 1.0) * seen.a; }`).join("\n")}
  return sum;
}

/** The mean of all looks less those whose paint a picture covers, so that half-way to a painted face its own paint shows. */
Painted painted(float covered) {
  Painted all = Painted(${PAINTED.join(", ")});
  float left = 1.0 - covered;
  if (covered == 0.0 || abs(left) < 0.01) return all;
  float more = covered / left;
${PAINTED.map((part) => `  all.${part} = clamp(all.${part} + more * (all.${part} - pictured.${part}), 0.0, 1.0);`).join("\n")}
  return all;
}

vec3 bare(Layers at, Painted own) {
  vec3 seen = own.skin * (1.0 + own.pores * (at.finish.a - 0.5) * vec3(0.08, -0.34, -0.30));
  seen *= mix(1.0, at.finish.b, 0.5 * own.pores);
  seen *= mix(vec3(1.0), vec3(0.70, 0.50, 0.42), at.marks.r * own.age);
  seen *= mix(vec3(1.0), vec3(0.70, 0.50, 0.36), at.marks.g * own.freckles);
  seen = mix(seen, own.blush, at.mask.b * 0.4);
  seen = mix(seen, 0.5 * own.brow + 0.14 * own.skin, at.marks.b * own.stubble * 0.78);
  return mix(seen, own.brow * 0.6 + own.lip * 0.18, at.patches.b * makeup * 0.85);
}

vec3 furred(Layers at, Painted own) {
  vec2 drawn = mix(at.pelt.rg, at.pelt.ba, own.stripes);
  vec3 seen = mix(mix(own.skin, own.coat, drawn.r), own.brow, drawn.g * 0.9);
  seen = mix(seen, own.brow * RIM, at.patches.g * 0.92);
  float strand = at.marks.a - 0.5;
  return seen * (1.0 + 1.15 * strand) + max(strand, 0.0) * 0.10;
}

/** A picture's light times its coverage, with what lies on the skin of every face. */
vec3 madeUp(Layers at, vec4 picture, float grown) {
  vec3 seen = mix(picture.rgb, (brow * 0.6 + lip * 0.18) * picture.a, at.patches.b * makeup * 0.85);
  seen = mix(seen, brow * 0.5 * picture.a, at.patches.a * lacquer);
  return mix(seen, scalpHair(at.marks.a) * picture.a, grown);
}

Ground ground(Layers at, float hairline) {
  Ground found;
  vec4 picture = pictures();
  Painted own = painted(picture.a);
  float grown = stubbled(hairline, at.marks.a) * scalp;
  float narrow = 0.12 * own.age;
  float human = smoothstep(0.06 + narrow, 0.5 + narrow, at.mask.r);
  found.lips = mix(human, smoothstep(0.86, 0.97, at.mask.r), own.fur);
  // The mouth's lining: painted like lips, in little light; wet flesh on every face, under fur and pictures too.
  float lining = smoothstep(0.55, 0.7, at.mask.r) * (1.0 - smoothstep(0.38, 0.5, at.mask.a));
  picture *= 1.0 - lining;
  float bareness = 1.0 - picture.a;
  found.lips = max(found.lips, lining);
  found.lining = lining;
  found.fur = own.fur * (1.0 - found.lips);
  float leather = at.patches.r;
  vec3 seen = mix(bare(at, own), own.lip * (0.86 + 0.28 * at.finish.a), found.lips * 0.9);
  seen = mix(seen, mix(furred(at, own), own.lip, leather), found.fur);
  float hairs = browHairs(at.mask.g, own.brows);
  seen = mix(seen, own.brow * (0.7 + 0.6 * at.marks.a), hairs * 0.88);
  seen = mix(seen, own.brow * 0.5, at.patches.a * lacquer);
  seen = mix(seen, scalpHair(at.marks.a), grown);
  seen = mix(seen, vec3(0.62, 0.16, 0.14), lining);
  // Light comes in between lips, and through them: beyond the red too, which thins with age, else a brown rim stays.
  float through = max(lining, 0.6 * smoothstep(0.25, 0.6, at.mask.r) * (1.0 - own.fur));
  float left = mix(at.mask.a, max(at.mask.a, 0.75), through);
  left *= mix(1.0, left, 0.3); // what cavities and the lash line leave of the light
  found.albedo = max(seen * left * bareness + madeUp(at, picture, grown) * mix(1.0, left, 0.5), 0.0);
  found.left = left * bareness + picture.a * mix(1.0, left, 0.5);
  found.fur *= bareness;
  found.leather = found.fur * leather;
  found.hair = max(grown, hairs * 0.85 * bareness);
  return found;
}
`;
