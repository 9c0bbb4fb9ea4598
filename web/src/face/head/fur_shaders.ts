/** Shaders of the strands of fur along the outline. */

import { FRAGMENT_HEAD, LIGHTS, VERTEX_HEAD } from "../light/shader_prelude";

/**
 * Strands of fur where the skin turns away from the eye, in the colour that is painted at their roots: what lies flat on
 * the skin everywhere else is the painted fur. As brows they fade where they are narrower than a pixel.
 */
export const FUR_VERTEX = `${VERTEX_HEAD}${LIGHTS}
in vec2 strand; // side (-1, 1), along (0 root, 1 tip)
in vec3 rootRows, rootShares;
in vec4 root; // place on the skin's pictures, turn with the head, chance
uniform float pixel; // metres a pixel is wide, one metre away
uniform sampler2D mask, patches, pelt;
uniform vec3 skin, coat, brow;
uniform float fur, stripes;
out vec2 vAcross; // side, what is left of it where a pixel is wider
out float vAlong;
out vec3 vLight;

const float LONG = 0.0082, HALF = 0.00032; // metres, of the longest and of the widest
const vec3 NOSE = vec3(0.0, -0.035, 0.19); // fur lies away from it, and down

/** A painted layer at the root, without its finest parts. */
vec4 painted(sampler2D layer) {
  return texelFetch(layer, ivec2(fract(root.xy) * vec2(textureSize(layer, 2))), 2);
}

#ifdef FIGURE
#define PLACES figurePositions
#define STANDING figureNormals
#else
#define PLACES positions
#define STANDING normals
#endif

/** How far it faces the eye at its nearest row, about: most strands are not at the outline, and end with this. */
float about() {
  ivec2 row = texelOf(int(rootRows.x + 0.5));
  vec3 here = texelFetch(PLACES, row, 0).xyz, normal = texelFetch(STANDING, row, 0).xyz;
#ifndef FIGURE
  here = turned(here, root.z);
  normal = turnedNormal(normal, root.z);
#endif
  return dot(normal, normalize(viewPoint - here));
}

vec3 on(sampler2D rows) {
  ivec3 row = ivec3(rootRows + 0.5);
  return rootShares.x * texelFetch(rows, texelOf(row.x), 0).xyz + rootShares.y * texelFetch(rows, texelOf(row.y), 0).xyz
    + rootShares.z * texelFetch(rows, texelOf(row.z), 0).xyz;
}

void main() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // nothing to draw
  if (abs(about()) > 0.7) return;
  vec3 here = on(PLACES);
  vec3 normal = normalize(on(STANDING));
#ifndef FIGURE
  here = turned(here, root.z);
  normal = turnedNormal(normal, root.z);
#endif
  vec3 view = viewPoint - here;
  float away = length(view);
  view /= away;
  float facing = dot(normal, view);
  float outline = smoothstep(0.52, 0.2, facing) * smoothstep(-0.55, -0.3, facing);
  if (outline <= 0.0) return;
  vec4 masked = painted(mask), patched = painted(patches), drawn = painted(pelt);
  float grown = fur * (1.0 - patched.r) * (1.0 - 0.9 * patched.g) * smoothstep(0.3, 0.6, masked.a) * (1.0 - smoothstep(0.6, 0.9, masked.r));
  if (grown <= 0.05) return;
  vec2 hairs = mix(drawn.rg, drawn.ba, stripes);
  vec3 albedo = mix(skin, mix(mix(skin, coat, hairs.r), brow, 0.9 * hairs.g), fur) * masked.a; // as \`furred\`

  float chance = fract(7.0 * root.w);
  vec3 standing = normalize(on(normals));
  vec3 back = on(positions) - NOSE - vec3(0.0, 0.03, 0.0);
  vec3 flat_ = normalize(back - standing * dot(back, standing) + 1e-5);
  vec3 aside = cross(standing, flat_) * (root.w - 0.5);
  vec3 lean = turnedNormal(normalize(flat_ + 0.7 * aside), root.z);
  float t = strand.y;
  float long_ = LONG * grown * (0.45 + 0.75 * chance);
  float lift = 0.24 + 0.45 * fract(13.0 * root.w);
  vec3 point = here + long_ * (t * (1.0 - lift * 0.4) * lean + (lift * t * (1.6 - 0.7 * t) - 0.06) * normal);
  vec3 along = normalize(lean + lift * (1.6 - 1.4 * t) * normal);
  float wide = HALF * (0.6 + 0.6 * chance) * (1.0 - 0.8 * t);
  float least = 0.6 * pixel * away;
  vAcross = vec2(strand.x, min(wide / least, 1.0) * outline);
  vAlong = t;

  float key = clamp((dot(normal, KEY) + 0.3) / 1.3, 0.0, 1.0); // no cast shadow: outlines hardly show one
  float fill = clamp(dot(normal, FILL) * 0.6 + 0.4, 0.0, 1.0);
  float rims = max(dot(normal, RIM_LEFT), 0.0) * 0.7 + max(dot(normal, RIM_RIGHT), 0.0);
  vec3 diffuse = KEY_LIGHT * key + FILL_LIGHT * fill + ambient(normal);
  diffuse += fur * (0.6 * FILL_LIGHT + KEY_LIGHT * 0.25 * max(dot(normal, KEY) + 0.5, 0.0) + 1.1 * rims * RIM_LIGHT); // through it
  float across = dot(along, normalize(KEY + view));
  float sheen = 1.0 - across * across;
  sheen *= sheen;
  sheen *= sheen;
  sheen *= sheen; // to the power of 8
  vLight = albedo * (diffuse * mix(0.75, 1.1, t) * (0.8 + 0.4 * chance) + 0.25 * sheen * key * KEY_LIGHT);
  gl_Position = project(point + normalize(cross(along, view)) * strand.x * max(wide, least));
}
`;

export const FUR_FRAGMENT = `${FRAGMENT_HEAD}
in vec2 vAcross;
in float vAlong;
in vec3 vLight;

void main() {
  float soft = 1.0 - smoothstep(0.4, 1.0, abs(vAcross.x));
  float alpha = soft * vAcross.y * (1.0 - 0.8 * smoothstep(0.3, 1.0, vAlong));
  if (alpha < 0.01) discard;
  colour = premultiplied(vLight, alpha);
}
`;
