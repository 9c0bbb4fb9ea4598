/** Shaders of the corrective passes: lids off eyeballs, lips apart, no triangle turned over; for several characters at once. */

import { RUNGS } from "../../link/constants";
import { DATA_WIDTH } from "../anatomy/correctives_data";
import { ROW_SHIFT, ROW_WIDTH } from "../gpu/pass_shaders";

/** Characters that the passes take at once. */
export const SLOTS = 8;

/*
 * All passes but the first and the last draw one texel per place (`correctives_data.ts`), not one point per row: software
 * renderers shade whole blocks of texels at once.
 */
export const HEAD = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

ivec2 rowAt(uint row) { return ivec2(int(row & ${ROW_WIDTH - 1}u), int(row >> ${ROW_SHIFT})); }
ivec2 dataAt(uint index) { return ivec2(int(index % ${DATA_WIDTH}u), int(index / ${DATA_WIDTH}u)); }

// Characters lie one above the other: each has a slot of so many lines in every texture that is its own.
uniform ivec4 lines; // of places, triangles, rungs, allowances
ivec2 inSlot(uint index, int slot, int height) { return dataAt(index) + ivec2(0, slot * height); }
`;

/** The rows that may move, gathered from all positions of the character in a slot. */
export const GATHER_FRAGMENT = `${HEAD}
uniform sampler2D mixed;
uniform usampler2D rows;
uniform int slot;
out vec4 position;
void main() {
  ivec2 own = ivec2(gl_FragCoord.xy) - ivec2(0, slot * lines.x);
  position = texelFetch(mixed, rowAt(texelFetch(rows, own, 0).x), 0);
}
`;

const PLACE_HEAD = `${HEAD}
uniform sampler2D points;
uniform sampler2D allowed;
uniform usampler2D spans;
out vec4 position;

vec3 point(uint place, int slot) { return texelFetch(points, inSlot(place, slot, lines.x), 0).xyz; }
float allowance(uint place, int slot) { return texelFetch(allowed, inSlot(place, slot, lines.w), 0).x; }
`;

const BALLS_HEAD = `${PLACE_HEAD}
// ---- lids and eyeballs

uniform sampler2D rest;
uniform vec3 centres[${2 * SLOTS}];
uniform float radii[${2 * SLOTS}];
uniform vec3 sights[${2 * SLOTS}];
uniform vec2 cornea; // how far it stands out, in radii; the cosine where it ends
uniform bool leaving;

float depth(vec3 at, int eye, vec3 sight) {
  vec3 outward = at - centres[eye];
  float far = max(length(outward), 1e-9);
  float up = max((dot(outward, sight) / far - cornea.y) / (1.0 - cornea.y), 0.0);
  return radii[eye] * (1.0 + cornea.x * up * up * (3.0 - 2.0 * up)) - far;
}

vec3 left(vec3 at, uvec4 span, int slot) {
  if (!leaving || span.x == 0u) return at;
  int eye = 2 * slot + int(span.x) - 1;
  float still = max(depth(texelFetch(rest, ivec2(gl_FragCoord.xy), 0).xyz, eye, vec3(0.0, 0.0, 1.0)), 0.0);
  float push = max(depth(at, eye, sights[eye]) - still - allowance(span.y, slot), 0.0);
  vec3 outward = at - centres[eye];
  return at + push * outward / max(length(outward), 1e-9);
}
`;

/** What either side of a line gives way at each rung: one texel a rung, one line of texels a line, slot above slot. */
export const RUNG_FRAGMENT = `${HEAD}
uniform sampler2D points;
uniform sampler2D rest;
uniform sampler2D allowed;
uniform usampler2D rungPlaces;
uniform sampler2D rungWeights;
uniform float upward[8];
uniform int first; // place of the first rung in an allowance
out vec4 half_;

void main() {
  int slot = int(gl_FragCoord.y) / lines.z;
  ivec2 at = ivec2(gl_FragCoord.xy) - ivec2(0, slot * lines.z);
  uvec4 places = texelFetch(rungPlaces, at, 0);
  vec4 weights = texelFetch(rungWeights, at, 0);
  vec3 still = vec3(0.0);
  vec3 now = vec3(0.0);
  for (int k = 0; k < 4; k++) {
    still += weights[k] * texelFetch(rest, inSlot(places[k], slot, lines.x), 0).xyz;
    now += weights[k] * texelFetch(points, inSlot(places[k], slot, lines.x), 0).xyz;
  }
  vec3 along = upward[at.y] > 0.5 ? vec3(0.0, 1.0, 0.0) : still / max(length(still), 1e-9);
  float own = texelFetch(allowed, inSlot(uint(first + at.y * ${RUNGS} + at.x), slot, lines.w), 0).x;
  float lack = max(min(dot(along, still), 0.0) - own - dot(along, now), 0.0);
  half_ = vec4(0.5 * lack * along, 0.0);
}
`;

/** Lids and lips that cross give way; lids leave the eyeball. */
export const PART_FRAGMENT = `${BALLS_HEAD}
uniform sampler2D pulls;
uniform sampler2D rungs;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  int slot = here.y / lines.x;
  ivec2 own = here - ivec2(0, slot * lines.x);
  vec3 at = texelFetch(points, here, 0).xyz;
  vec4 pull = texelFetch(pulls, own, 0);
  if (pull.x >= 0.0) {
    float place = clamp(pull.z * ${RUNGS}.0 - 0.5, 0.0, ${RUNGS - 1}.0);
    int first = min(int(place), ${RUNGS - 2});
    int line = slot * lines.z + int(pull.x);
    vec3 one = texelFetch(rungs, ivec2(first, line), 0).xyz;
    vec3 next = texelFetch(rungs, ivec2(first + 1, line), 0).xyz;
    at += pull.y * mix(one, next, place - float(first));
  }
  position = vec4(left(at, texelFetch(spans, own, 0), slot), 1.0);
}
`;

/** Normals of the triangles at rest, twice the areas long, and their squared lengths. */
export const REST_FRAGMENT = `${HEAD}
uniform sampler2D rest;
uniform usampler2D triangles;
out vec4 normal;

void main() {
  int slot = int(gl_FragCoord.y) / lines.y;
  uvec4 places = texelFetch(triangles, ivec2(gl_FragCoord.xy) - ivec2(0, slot * lines.y), 0);
  vec3 a = texelFetch(rest, inSlot(places.x, slot, lines.x), 0).xyz;
  vec3 b = texelFetch(rest, inSlot(places.y, slot, lines.x), 0).xyz;
  vec3 c = texelFetch(rest, inSlot(places.z, slot, lines.x), 0).xyz;
  vec3 turned = cross(b - a, c - a);
  normal = vec4(turned, dot(turned, turned));
}
`;

/** What each triangle is to keep of its area: what it is allowed to, and beyond it a margin where it lacks that now. */
export const GOAL_FRAGMENT = `${HEAD}
uniform sampler2D points;
uniform sampler2D allowed;
uniform sampler2D restNormals;
uniform usampler2D triangles;
uniform float upright;
uniform float least;
uniform vec2 margin; // a share of what lacks, and the most
out vec4 goal;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  int slot = here.y / lines.y;
  ivec2 own = here - ivec2(0, slot * lines.y);
  uvec4 places = texelFetch(triangles, own, 0);
  vec4 rested = texelFetch(restNormals, here, 0);
  vec3 a = texelFetch(points, inSlot(places.x, slot, lines.x), 0).xyz;
  vec3 b = texelFetch(points, inSlot(places.y, slot, lines.x), 0).xyz - a;
  vec3 c = texelFetch(points, inSlot(places.z, slot, lines.x), 0).xyz - a;
  uint number = uint(own.y * ${DATA_WIDTH} + own.x);
  float keeps = max(upright - texelFetch(allowed, inSlot(number, slot, lines.w), 0).x, least);
  float lack = max(keeps - dot(cross(b, c), rested.xyz) / rested.w, 0.0);
  goal = vec4(keeps + min(margin.x * lack, margin.y), 0.0, 0.0, 0.0);
}
`;

/** Each vertex takes the mean of what its triangles want that lack area, and goes on a share of its last step; one that
 * lacks next to nothing weighs next to nothing, or it would halve what another wants at once. */
export const UPRIGHT_FRAGMENT = `${PLACE_HEAD}
uniform sampler2D earlier; // the points a round before
uniform sampler2D restNormals;
uniform sampler2D goals;
uniform usampler2D corners;
uniform float momentum;
uniform float eager;
uniform float flattest;
uniform float full;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  int slot = here.y / lines.x;
  vec3 at = texelFetch(points, here, 0).xyz;
  uvec4 span = texelFetch(spans, here - ivec2(0, slot * lines.x), 0);
  vec3 push = vec3(0.0);
  float wanted = 0.0;
  for (uint n = span.z; n < span.w; n++) {
    uvec4 corner = texelFetch(corners, dataAt(n), 0);
    vec4 rested = texelFetch(restNormals, inSlot(corner.z, slot, lines.y), 0);
    vec3 b = point(corner.x, slot) - at;
    vec3 c = point(corner.y, slot) - at;
    float lack = texelFetch(goals, inSlot(corner.z, slot, lines.y), 0).x - dot(cross(b, c), rested.xyz) / rested.w;
    if (lack <= 0.0) continue;
    vec3 atB = cross(c, rested.xyz) / rested.w;
    vec3 atC = cross(rested.xyz, b) / rested.w;
    vec3 own = -atB - atC;
    float slope = dot(own, own) + dot(atB, atB) + dot(atC, atC);
    float weight = min(lack / full, 1.0);
    push += weight * lack / max(slope, flattest * inversesqrt(rested.w)) * own;
    wanted += weight;
  }
  if (wanted > 0.0)
    at += momentum * min(wanted, 1.0) * (at - texelFetch(earlier, here, 0).xyz) + eager / wanted * push;
  position = vec4(at, 1.0);
}
`;

/** All positions again: what has settled; inner skin and lashes that go with the skin they hang on; the rest as mixed. */
export const SPREAD_FRAGMENT = `${HEAD}
uniform sampler2D mixed;
uniform sampler2D before; // the rows that may move, as mixed
uniform sampler2D points; // and as they have settled
uniform usampler2D roles;
uniform sampler2D anchors;
uniform int width;
uniform int slot;
out vec4 position;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  uvec4 role = texelFetch(roles, here, 0);
  position = texelFetch(mixed, here, 0);
  if (role.x > 0u) position = texelFetch(points, inSlot(role.x - 1u, slot, lines.x), 0);
  if (role.y == 0u) return;
  for (int k = 0; k < width; k++) {
    vec2 anchor = texelFetch(anchors, dataAt((role.y - 1u) * uint(width) + uint(k)), 0).xy;
    if (anchor.y == 0.0) continue;
    ivec2 at = inSlot(uint(anchor.x + 0.5), slot, lines.x);
    position.xyz += anchor.y * (texelFetch(points, at, 0).xyz - texelFetch(before, at, 0).xyz);
  }
}
`;
