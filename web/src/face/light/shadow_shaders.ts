/** Shaders that write and read the shadow map. */

/** Half a side of the square that the shadow map covers, and from where to where its depth reaches, metres. */
export const REACH = 0.22;
export const DEPTH = 0.5;

/** A vertex shader sees no cast shadows: they are found pixel by pixel. */
export const NO_SHADOW = `
float shadow(vec3 point, vec3 normal) { return 1.0; }
`;

/**
 * `shadow(point, normal)`: how much of the key light comes to a point, 0..1. Percentage-closer soft shadows (Fernando
 * 2005): what stands in the light near by gives the gap to the receiver, the gap the width of the penumbra.
 */
export const SHADOW = `
#ifdef SHADOW
#ifndef SPIN
#define SPIN fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) // Jimenez 2014
#endif
precision highp sampler2DShadow;
uniform sampler2D shadowHeights; // towards the light, 0..1; 0: nothing stands there
uniform sampler2DShadow shadowDepths;
uniform vec3 shadowCentre;
uniform vec3 shadowSide;
uniform vec3 shadowUp;
uniform float KEY_SIZE;

const float LIFT = 0.0012; // metres off the surface: its triangles cut the corners of what it stands for
const float BIAS = 0.0006;
const float GRAZED = 0.12; // the least cosine by which a surface is taken for flat: under more, brows and temples shade themselves
const int BLOCKERS = 16;
const int SAMPLES = 28;

/** A turn by the golden angle: places that far from each other, by the root of their number from the middle, spread evenly over a disc (Vogel 1979). */
const mat2 GOLDEN = mat2(-0.737368878, 0.675490294, -0.675490294, -0.737368878);

float shadow(vec3 point, vec3 normal) {
  if (KEY_LIGHT.r + KEY_LIGHT.g + KEY_LIGHT.b <= 0.0) return 1.0;
  vec3 from = point + normal * LIFT - shadowCentre;
  vec3 at = vec3(dot(from, shadowSide), dot(from, shadowUp), dot(from, KEY)); // metres
  if (max(abs(at.x), abs(at.y)) > ${(0.97 * REACH).toFixed(4)} || at.z < ${(-DEPTH / 2).toFixed(4)}) return 1.0;
  float facing = dot(normal, KEY);
  float grazing = 1.0 - smoothstep(0.0, 0.45, facing); // there light that went through the skin blurs all edges
  // A surface that turns away is in its own shade already: only what stands further off counts
  float bias = BIAS + 0.14 * max(0.06 - facing, 0.0);
  vec2 slope = -vec2(dot(normal, shadowSide), dot(normal, shadowUp)) / max(facing, GRAZED);
  float turn = 6.2831853 * SPIN;
  vec2 first = vec2(cos(turn), sin(turn));
  float texel = ${(2 * REACH).toFixed(4)} / float(textureSize(shadowHeights, 0).x);
  float least = mix(max(2.0 * texel, 0.0012), 0.007, grazing);
  float widest = clamp(KEY_SIZE * 0.07, least, 0.02);

  vec2 spoke = first;
  float gap = 0.0;
  float count = 0.0;
  for (int i = 0; i < BLOCKERS; i++) {
    vec2 aside = spoke * sqrt((float(i) + 0.5) / float(BLOCKERS)) * widest;
    spoke = GOLDEN * spoke;
    float height = textureLod(shadowHeights, (at.xy + aside) * ${(0.5 / REACH).toFixed(6)} + 0.5, 0.0).r;
    float over = (height - 0.5) * ${DEPTH.toFixed(4)} - at.z - max(dot(slope, aside), 0.0) - bias;
    if (over > 0.0) { gap += over; count += 1.0; }
  }
  if (count == 0.0) return 1.0;
  if (count == float(BLOCKERS)) return 1.0 - SHADE; // all of the lamp is hidden
  float width = clamp(KEY_SIZE * gap / count, least, max(0.8 * widest, least)); // inside what was searched: no lone dots
  spoke = first;
  float light = 0.0;
  for (int i = 0; i < SAMPLES; i++) {
    vec2 aside = spoke * sqrt((float(i) + 0.5) / float(SAMPLES)) * width;
    spoke = GOLDEN * spoke;
    float height = at.z + max(dot(slope, aside), 0.0) + bias;
    light += texture(shadowDepths, vec3((at.xy + aside) * ${(0.5 / REACH).toFixed(6)} + 0.5, 0.5 - height / ${DEPTH.toFixed(4)}));
  }
  return mix(1.0, light / float(SAMPLES), SHADE);
}
#else
${NO_SHADOW}
#endif
`;

/**
 * What the shadow map keeps: how far towards the light the nearest surface stands. Ribbons of hair (STRANDS) are fibres
 * that end one after the other here too, where they do in the picture: whole ribbons cast bars with square ends.
 */
export const HEIGHT_FRAGMENT = `
precision highp float;
out vec4 height;
#ifdef STRANDS
uniform highp sampler2D grain;
in vec3 vPlace;
in vec2 vChance;
#endif

void main() {
#ifdef STRANDS
  vec4 fibre = texture(grain, vec2(vPlace.x * 0.05 + vChance.x * 7.3, vPlace.y * 0.013 + vChance.y));
  float edge = vPlace.x * vPlace.x;
  float tip = vPlace.y * vPlace.y;
#ifdef DETAIL
  float bare = 0.1 * edge * edge + 0.12 * tip + 0.5 * smoothstep(0.9, 1.06, vPlace.y);
#else
  float bare = 0.2 * edge * edge + 0.28 * tip + 0.9 * smoothstep(0.86, 1.06, vPlace.y); // broad ones end earlier
#endif
  if (fibre.r < bare) discard;
#endif
  height = vec4(1.0 - gl_FragCoord.z, 0.0, 0.0, 1.0);
}
`;
