/** Shader code of the skin's own colour. */

/**
 * The skin's own colour: every layer of the cast's picture, weighed by the traits of the faces on air. All of it is a sum
 * of traits, so nothing pops while faces mix.
 */
export const SKIN_COLOURS = `
uniform sampler2D mask;
uniform sampler2D marks;
uniform sampler2D patches;
uniform sampler2D pelt;
uniform vec3 skin;
uniform vec3 lip;
uniform vec3 brow;
uniform vec3 blush;
uniform vec3 hair;
uniform vec3 coat;
uniform float pores;
uniform float age;
uniform float freckles;
uniform float stubble;
uniform float brows;
uniform float makeup;
uniform float fur;
uniform float stripes;
uniform float lacquer;
uniform float scalp;

const float RIM = 0.22; // of the brows' colour, the dark skin along lids and lips under fur

/** The skin's layers at one place (tools/baking paints them). */
struct Layers {
  vec4 mask; // lips, brows, blush, light that is left
  vec4 marks; // age, freckles, stubble, strands of fur
  vec4 patches; // leather, dark rims, make-up, paint of a mask
  vec4 finish; // oil, thinness, fine hollows, mottling of the blood
  vec4 pelt; // a hound's pale and dark fur, a tabby's pale and dark fur
};

/** What the light falls on: the colour, and how much of it is lip, hair (brows too), fur, bare leather, or lining (0..1 each). */
struct Ground { vec3 albedo; float lips; float hair; float fur; float leather; float lining; };

/** How much a brow's hairs cover: the thinner the brow, the higher the threshold. */
float browHairs(float drawn) { return clamp((drawn - mix(1.0, -0.12, brows)) * 2.3, 0.0, 1.0); }

vec3 bare(Layers at) {
  vec3 seen = skin * (1.0 + pores * (at.finish.a - 0.5) * vec3(0.08, -0.34, -0.30));
  seen *= mix(1.0, at.finish.b, 0.5 * pores);
  seen *= mix(vec3(1.0), vec3(0.70, 0.50, 0.42), at.marks.r * age);
  seen *= mix(vec3(1.0), vec3(0.70, 0.50, 0.36), at.marks.g * freckles);
  seen = mix(seen, blush, at.mask.b * 0.4);
  seen = mix(seen, 0.5 * brow + 0.14 * skin, at.marks.b * stubble * 0.78);
  return mix(seen, brow * 0.6 + lip * 0.18, at.patches.b * makeup * 0.85);
}

vec3 furred(Layers at) {
  vec2 drawn = mix(at.pelt.rg, at.pelt.ba, stripes);
  vec3 seen = mix(mix(skin, coat, drawn.r), brow, drawn.g * 0.9);
  seen = mix(seen, brow * RIM, at.patches.g * 0.92);
  float strand = at.marks.a - 0.5;
  return seen * (1.0 + 1.15 * strand) + max(strand, 0.0) * 0.10;
}

Ground ground(Layers at, float hairline) {
  Ground found;
  found.hair = smoothstep(0.15, 0.9, hairline + (at.marks.a - 0.5) * 2.8 * hairline * (1.0 - hairline)) * scalp;
  float narrow = 0.12 * age;
  float human = smoothstep(0.06 + narrow, 0.5 + narrow, at.mask.r);
  found.lips = mix(human, smoothstep(0.86, 0.97, at.mask.r), fur);
  // The mouth's lining: painted like lips, in little light; wet flesh on every face, under fur too.
  float lining = smoothstep(0.55, 0.7, at.mask.r) * (1.0 - smoothstep(0.38, 0.5, at.mask.a));
  found.lips = max(found.lips, lining);
  found.lining = lining;
  found.fur = fur * (1.0 - found.lips);
  float leather = at.patches.r;
  found.leather = found.fur * leather;
  vec3 seen = mix(bare(at), lip * (0.86 + 0.28 * at.finish.a), found.lips * 0.9);
  seen = mix(seen, mix(furred(at), lip, leather), found.fur);
  float hairs = browHairs(at.mask.g);
  seen = mix(seen, brow * (0.7 + 0.6 * at.marks.a), hairs * 0.88);
  seen = mix(seen, brow * 0.5, at.patches.a * lacquer);
  seen = mix(seen, hair * (0.7 + 0.6 * at.marks.a), found.hair);
  found.hair = max(found.hair, hairs * 0.85);
  seen = mix(seen, vec3(0.62, 0.16, 0.14), lining);
  float left = mix(at.mask.a, 0.75, max(lining, 0.6 * human * smoothstep(0.5, 0.8, at.mask.r))); // light comes in between lips, and through them
  found.albedo = seen * left * mix(1.0, left, 0.3); // what cavities and the lash line leave of the light
  return found;
}
`;
