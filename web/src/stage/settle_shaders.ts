import { ROW_SHIFT, ROW_WIDTH } from "./pass_shaders";
import { RUNGS } from "./settling";

/** Texels in a line of all other textures of the settling. */
export const DATA_WIDTH = 128;

const HEAD = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

ivec2 rowAt(uint row) { return ivec2(int(row & ${ROW_WIDTH - 1}u), int(row >> ${ROW_SHIFT})); }
ivec2 dataAt(int index) { return ivec2(index % ${DATA_WIDTH}, index / ${DATA_WIDTH}); }
`;

/** One point per row: a fragment at the row's texel, with what is known of it. */
export const ROW_VERTEX = `${HEAD}
uniform vec2 size;
layout(location = 0) in uint row;
layout(location = 1) in vec3 pull;
layout(location = 2) in ivec2 lid;
layout(location = 3) in uvec2 span;
flat out uint vRow;
flat out vec3 vPull;
flat out ivec2 vLid;
flat out uvec2 vSpan;

void main() {
  vRow = row;
  vPull = pull;
  vLid = lid;
  vSpan = span;
  gl_Position = vec4((vec2(rowAt(row)) + 0.5) / size * 2.0 - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
`;

/** One point per follower. */
export const FOLLOWER_VERTEX = `${HEAD}
uniform vec2 size;
layout(location = 0) in uint row;
flat out uint vRow;
flat out int vFollower;

void main() {
  vRow = row;
  vFollower = gl_VertexID;
  gl_Position = vec4((vec2(rowAt(row)) + 0.5) / size * 2.0 - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
`;

const ROW_HEAD = `${HEAD}
uniform sampler2D points;
uniform sampler2D rest;
uniform sampler2D allowed;
flat in uint vRow;
flat in vec3 vPull;
flat in ivec2 vLid;
flat in uvec2 vSpan;
out vec4 position;

vec3 point(uint row) { return texelFetch(points, rowAt(row), 0).xyz; }
float allowance(int place) { return texelFetch(allowed, dataAt(place), 0).x; }

// ---- lids and eyeballs

uniform vec3 centres[2];
uniform vec2 radii;
uniform vec3 sights[2];
uniform vec2 cornea; // how far it stands out, in radii; the cosine where it ends
uniform bool leaving;

float depth(vec3 at, int eye, vec3 sight) {
  vec3 outward = at - centres[eye];
  float far = max(length(outward), 1e-9);
  float up = max((dot(outward, sight) / far - cornea.y) / (1.0 - cornea.y), 0.0);
  return radii[eye] * (1.0 + cornea.x * up * up * (3.0 - 2.0 * up)) - far;
}

vec3 left(vec3 at) {
  if (!leaving || vLid.x < 0) return at;
  float still = max(depth(texelFetch(rest, rowAt(vRow), 0).xyz, vLid.x, vec3(0.0, 0.0, 1.0)), 0.0);
  float push = max(depth(at, vLid.x, sights[vLid.x]) - still - allowance(vLid.y), 0.0);
  vec3 outward = at - centres[vLid.x];
  return at + push * outward / max(length(outward), 1e-9);
}
`;

/** What either side of a line gives way at each rung: one texel a rung, one line of texels a line. */
export const RUNG_FRAGMENT = `${HEAD}
uniform sampler2D points;
uniform sampler2D rest;
uniform sampler2D allowed;
uniform usampler2D rungRows;
uniform sampler2D rungWeights;
uniform float upward[8];
uniform int first; // place of the first rung in an allowance
out vec4 half_;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uvec4 rows = texelFetch(rungRows, at, 0);
  vec4 weights = texelFetch(rungWeights, at, 0);
  vec3 still = vec3(0.0);
  vec3 now = vec3(0.0);
  for (int k = 0; k < 4; k++) {
    still += weights[k] * texelFetch(rest, rowAt(rows[k]), 0).xyz;
    now += weights[k] * texelFetch(points, rowAt(rows[k]), 0).xyz;
  }
  vec3 along = upward[at.y] > 0.5 ? vec3(0.0, 1.0, 0.0) : still / max(length(still), 1e-9);
  float own = texelFetch(allowed, dataAt(first + at.y * ${RUNGS} + at.x), 0).x;
  float lack = max(min(dot(along, still), 0.0) - own - dot(along, now), 0.0);
  half_ = vec4(0.5 * lack * along, 0.0);
}
`;

/** Lids and lips that cross give way; lids leave the eyeball. */
export const PART_FRAGMENT = `${ROW_HEAD}
uniform sampler2D rungs;

void main() {
  vec3 at = point(vRow);
  if (vPull.x >= 0.0) {
    float place = clamp(vPull.z * ${RUNGS}.0 - 0.5, 0.0, ${RUNGS - 1}.0);
    int first = min(int(place), ${RUNGS - 2});
    vec3 here = texelFetch(rungs, ivec2(first, int(vPull.x)), 0).xyz;
    vec3 next = texelFetch(rungs, ivec2(first + 1, int(vPull.x)), 0).xyz;
    at += vPull.y * mix(here, next, place - float(first));
  }
  position = vec4(left(at), 1.0);
}
`;

/** Normals of the triangles at rest, twice the areas long, and their squared lengths. */
export const REST_FRAGMENT = `${HEAD}
uniform sampler2D rest;
uniform usampler2D triangles;
out vec4 normal;

void main() {
  uvec4 rows = texelFetch(triangles, ivec2(gl_FragCoord.xy), 0);
  vec3 a = texelFetch(rest, rowAt(rows.x), 0).xyz;
  vec3 b = texelFetch(rest, rowAt(rows.y), 0).xyz;
  vec3 c = texelFetch(rest, rowAt(rows.z), 0).xyz;
  vec3 turned = cross(b - a, c - a);
  normal = vec4(turned, dot(turned, turned));
}
`;

/** Each row takes the mean of what its triangles want that lack area. */
export const UPRIGHT_FRAGMENT = `${ROW_HEAD}
uniform sampler2D restNormals;
uniform usampler2D corners;
uniform float upright;
uniform float eager;
uniform float flattest;

void main() {
  vec3 at = point(vRow);
  vec3 push = vec3(0.0);
  float wanted = 0.0;
  for (uint slot = vSpan.x; slot < vSpan.y; slot++) {
    uvec4 corner = texelFetch(corners, dataAt(int(slot)), 0);
    vec4 rested = texelFetch(restNormals, dataAt(int(corner.z)), 0);
    vec3 b = point(corner.x) - at;
    vec3 c = point(corner.y) - at;
    float lack = upright - allowance(int(corner.z)) - dot(cross(b, c), rested.xyz) / rested.w;
    if (lack <= 0.0) continue;
    vec3 atB = cross(c, rested.xyz) / rested.w;
    vec3 atC = cross(rested.xyz, b) / rested.w;
    vec3 own = -atB - atC;
    float slope = dot(own, own) + dot(atB, atB) + dot(atC, atC);
    push += lack / max(slope, flattest * inversesqrt(rested.w)) * own;
    wanted += 1.0;
  }
  if (wanted > 0.0) at += eager / wanted * push;
  position = vec4(left(at), 1.0);
}
`;

/** What has settled, copied. */
export const COPY_FRAGMENT = `${HEAD}
uniform sampler2D points;
flat in uint vRow;
out vec4 position;
void main() { position = texelFetch(points, rowAt(vRow), 0); }
`;

/** Inner skin and lashes go with the skin they hang on. */
export const FOLLOW_FRAGMENT = `${HEAD}
uniform sampler2D points;
uniform sampler2D mixed;
uniform sampler2D anchors;
uniform int width;
flat in uint vRow;
flat in int vFollower;
out vec4 position;

void main() {
  vec3 at = texelFetch(mixed, rowAt(vRow), 0).xyz;
  for (int k = 0; k < width; k++) {
    vec2 anchor = texelFetch(anchors, dataAt(vFollower * width + k), 0).xy;
    if (anchor.y == 0.0) continue;
    uint row = uint(anchor.x + 0.5);
    at += anchor.y * (texelFetch(points, rowAt(row), 0).xyz - texelFetch(mixed, rowAt(row), 0).xyz);
  }
  position = vec4(at, 1.0);
}
`;
