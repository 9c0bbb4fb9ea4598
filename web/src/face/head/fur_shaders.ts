/** Shaders of the strands of fur, along the outline and on the face. */

import { FRAGMENT_HEAD, LIGHTS, VERTEX_HEAD } from "../light/shader_prelude";
import { DEPTH, REACH } from "../light/shadow_shaders";

/** How much of the key light comes to a root: by one sample, for strands are many and break every edge. */
const ROOT_SHADOW = `
#ifdef SHADOW
uniform sampler2D shadowHeights; // as in shadow_shaders.ts
uniform vec3 shadowCentre, shadowSide, shadowUp;

float sunlit(vec3 point) {
  vec3 from = point - shadowCentre;
  vec3 at = vec3(dot(from, shadowSide), dot(from, shadowUp), dot(from, KEY));
  float height = textureLod(shadowHeights, at.xy * ${(0.5 / REACH).toFixed(6)} + 0.5, 0.0).r;
  float over = (height - 0.5) * ${DEPTH.toFixed(4)} - at.z;
  return mix(1.0, 1.0 - smoothstep(0.002, 0.008, over), SHADE);
}
#else
float sunlit(vec3 point) { return 1.0; }
#endif
`;

/**
 * Strands of fur in the colour that is painted at their roots: they stand off along the outline, and lie on the painted
 * fur elsewhere, each a little darker or lighter than it. As brows they fade where they are narrower than a pixel.
 */
export const FUR_VERTEX = `${VERTEX_HEAD}${LIGHTS}${ROOT_SHADOW}
in vec2 strand; // side (-1, 1), along (0 root, 1 tip)
in vec3 rootRows, rootShares, flow; // how its way along the skin is made of the places of its rows
in vec4 root; // place on the skin's pictures, turn with the head, chance
in float sky; // open, 0..1
uniform float pixel; // metres a pixel is wide, one metre away
uniform sampler2D mask, patches, pelt;
uniform vec3 skin, coat, brow;
uniform float fur, stripes;
out vec2 vAcross; // side, what is left of it where a pixel is wider
out vec2 vAlong; // from the root, and whether it stands off
out vec3 vLight;

const float SHORT = 0.003, LONG = 0.0088, HALF = 0.00032; // metres, of the shortest, the longest and of the widest
const float FEWEST = 0.3; // of all strands, drawn at any distance
const float LYING = 0.85; // of the light that strands on the face hide at most

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

/** How far it faces the eye at its nearest row, about, and how far away that is: those behind or pruned end with this. */
vec2 about() {
  ivec2 row = texelOf(int(rootRows.x + 0.5));
  vec3 here = texelFetch(PLACES, row, 0).xyz, normal = texelFetch(STANDING, row, 0).xyz;
#ifndef FIGURE
  here = turned(here, root.z);
  normal = turnedNormal(normal, root.z);
#endif
  vec3 view = viewPoint - here;
  float away = length(view);
  return vec2(dot(normal, view) / away, away);
}

/** What is drawn of a strand, 0..1, and by how much wider it is for those that are not: of strands narrower than a pixel
 * a share is drawn; each fades before it goes (stochastic simplification: Cook, Halstead, Planck and Ryu 2007). */
vec2 unpruned(float away) {
  float share = clamp(HALF / (pixel * away), FEWEST, 1.0);
  float fading = 0.5 * (1.0 - share);
  return vec2(1.0 - smoothstep(share * (1.0 - fading), share, fract(29.0 * root.w)), 1.0 / (share * (1.0 - 0.5 * fading)));
}

/** What its three rows have, a column each. */
mat3 on(sampler2D rows) {
  ivec3 row = ivec3(rootRows + 0.5);
  return mat3(texelFetch(rows, texelOf(row.x), 0).xyz, texelFetch(rows, texelOf(row.y), 0).xyz, texelFetch(rows, texelOf(row.z), 0).xyz);
}

void main() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // nothing to draw
  vec2 nearest = about();
  if (nearest.x < -0.7) return;
  vec2 kept = unpruned(nearest.y);
  if (kept.x <= 0.0) return;
  mat3 places = on(PLACES);
  vec3 here = places * rootShares, way = places * flow;
  vec3 normal = normalize(on(STANDING) * rootShares);
#ifndef FIGURE
  here = turned(here, root.z);
  normal = turnedNormal(normal, root.z);
#endif
  vec3 view = viewPoint - here;
  float away = length(view);
  view /= away;
  float facing = dot(normal, view);
  float seen = smoothstep(-0.55, -0.3, facing);
  if (seen <= 0.0) return;
  float outline = smoothstep(0.52, 0.2, facing);
  vec4 masked = painted(mask), patched = painted(patches), drawn = painted(pelt);
  float grown = fur * (1.0 - patched.r) * (1.0 - 0.9 * patched.g) * smoothstep(0.3, 0.6, masked.a) * (1.0 - smoothstep(0.6, 0.9, masked.r));
  if (grown <= 0.05) return;
  vec2 hairs = mix(drawn.rg, drawn.ba, stripes);
  vec3 albedo = mix(skin, mix(mix(skin, coat, hairs.r), brow, 0.9 * hairs.g), fur) * masked.a; // as \`furred\`

  float chance = fract(7.0 * root.w);
  float reach = length(way);
  vec3 flat_ = normalize(way - normal * dot(way, normal) + 1e-7 * view);
#ifndef FIGURE
  flat_ = turnedNormal(flat_, root.z);
#endif
  vec3 lean = normalize(flat_ + mix(0.35, 0.7, outline) * (root.w - 0.5) * cross(normal, flat_));
  float t = strand.y;
  float long_ = clamp(reach, SHORT, LONG) * grown * (0.45 + 0.75 * chance);
  float lift = mix(0.14, 0.20, outline) + mix(0.16, 0.42, outline) * fract(13.0 * root.w);
  vec3 point = here + long_ * (t * (1.0 - lift * 0.4) * lean + (lift * t * (1.6 - 0.7 * t) + mix(0.05, -0.06, outline)) * normal);
  vec3 along = normalize(lean + lift * (1.6 - 1.4 * t) * normal);
  float wide = mix(1.5 * kept.y, 1.0, outline) * HALF * (0.6 + 0.6 * chance) * (1.0 - 0.8 * t);
  float least = 0.6 * pixel * away;
  vAcross = vec2(strand.x, min(wide / least, 1.0) * kept.x * seen * mix(LYING, 1.0, outline));
  vAlong = vec2(t, outline);

  float key = clamp((dot(normal, KEY) + 0.3) / 1.3, 0.0, 1.0) * sunlit(here + 0.002 * normal);
  float open = smoothstep(0.05, 1.0, shaded(sky)); // as of the skin
  float fill = clamp(dot(normal, FILL) * 0.6 + 0.4, 0.0, 1.0);
  float rims = max(dot(normal, RIM_LEFT), 0.0) * 0.7 + max(dot(normal, RIM_RIGHT), 0.0);
  vec3 diffuse = KEY_LIGHT * key * mix(1.0, open, 0.8) + (FILL_LIGHT * fill + ambient(normal)) * open * open;
  diffuse += fur * outline * (0.6 * FILL_LIGHT + KEY_LIGHT * 0.25 * max(dot(normal, KEY) + 0.5, 0.0) + 1.1 * rims * RIM_LIGHT); // through it
  float across = dot(along, normalize(KEY + view));
  float sheen = 1.0 - across * across;
  sheen *= sheen;
  sheen *= sheen;
  sheen *= sheen; // to the power of 8
  vLight = albedo * (diffuse * mix(0.75, 1.1, t) * mix(0.45 + 0.95 * chance, 0.8 + 0.4 * chance, outline) + 0.25 * sheen * key * KEY_LIGHT);
  gl_Position = project(point + normalize(cross(along, view)) * strand.x * max(wide, least));
}
`;

export const FUR_FRAGMENT = `${FRAGMENT_HEAD}
in vec2 vAcross;
in vec2 vAlong;
in vec3 vLight;

void main() {
  float soft = 1.0 - smoothstep(0.4, 1.0, abs(vAcross.x));
  float alpha = soft * vAcross.y * (1.0 - 0.8 * smoothstep(0.3, 1.0, vAlong.x)) * mix(smoothstep(0.0, 0.3, vAlong.x), 1.0, vAlong.y);
  if (alpha < 0.01) discard;
  colour = premultiplied(vLight, alpha);
}
`;
