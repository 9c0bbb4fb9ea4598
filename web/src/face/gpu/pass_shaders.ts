/** Shaders of the passes that blend positions and derive normals. */

/** Texels in a line of the position texture; a power of two, so that a row's texel is a shift and a mask. */
export const ROW_WIDTH = 128;
export const ROW_SHIFT = 7;

/** What every shader of a pass begins with. */
export const PASS_HEAD = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
precision highp sampler2DArray;
`;

/** One triangle over the whole target. */
export const PASS_VERTEX = `${PASS_HEAD}
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
`;

/** Entries that one pass takes; the uniform block of 8 KB holds two in each vec4. */
export const MOST_ENTRIES = 1024;
/** Entries of regions that one pass takes, 10 KB: first the weights of all, then four layers in each vec4. */
export const MOST_REGIONAL = 512;

const REGIONAL_BLOCK = `
layout(std140) uniform Regional { vec4 weights[${MOST_REGIONAL}]; vec4 among[${MOST_REGIONAL / 4}]; };
uniform sampler2D masks;
uniform int count;
`;
const REGIONAL_SUM = `
  vec4 mask = texelFetch(masks, at, 0);
  for (int i = 0; i < count; i++)
    sum += dot(mask, weights[i]) * texelFetch(layers, ivec3(at, int(among[i >> 2][i & 3])), 0).xyz;
`;

/**
 * Eq. 3 of Arai (1993): P = sum of weight x layer (docs/method.md, "The mix"), a layer for each compound; `regional`: and of layers that weigh another in each region; the
 * eyeballs' rows turn about their centres.
 */
export const blendFragment = (regional: boolean): string => `${PASS_HEAD}
layout(std140) uniform Mix { vec4 entries[${MOST_ENTRIES / 2}]; };
uniform sampler2DArray layers;
uniform int pairs;
uniform ivec4 eyeRows;
uniform vec3 eyeCentres[2];
uniform mat3 eyeTurns[2];
${regional ? REGIONAL_BLOCK : ""}
out vec4 position;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < pairs; i++) {
    vec4 two = entries[i];
    sum += two.y * texelFetch(layers, ivec3(at, int(two.x)), 0).xyz;
    sum += two.w * texelFetch(layers, ivec3(at, int(two.z)), 0).xyz;
  }
${regional ? REGIONAL_SUM : ""}
  int row = (at.y << ${ROW_SHIFT}) + at.x;
  if (row >= eyeRows.x && row < eyeRows.y) sum = eyeCentres[0] + eyeTurns[0] * (sum - eyeCentres[0]);
  if (row >= eyeRows.z && row < eyeRows.w) sum = eyeCentres[1] + eyeTurns[1] * (sum - eyeCentres[1]);
  position = vec4(sum, 1.0);
}
`;

/** Area-weighted normals from the triangles around each row. */
export const NORMAL_FRAGMENT = `${PASS_HEAD}
uniform sampler2D positions;
uniform usampler2D ranges;
uniform usampler2D corners;
out vec4 normal;

vec3 place(uint row) {
  return texelFetch(positions, ivec2(int(row & ${ROW_WIDTH - 1}u), int(row >> ${ROW_SHIFT})), 0).xyz;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec3 here = texelFetch(positions, at, 0).xyz;
  uvec2 range = texelFetch(ranges, at, 0).xy;
  vec3 sum = vec3(0.0);
  for (uint slot = range.x; slot < range.y; slot++) {
    uvec2 pair = texelFetch(corners, ivec2(int(slot & 511u), int(slot >> 9)), 0).xy;
    sum += cross(place(pair.x) - here, place(pair.y) - here);
  }
  float size = length(sum);
  normal = vec4(size > 0.0 ? sum / size : vec3(0.0, 0.0, 1.0), 1.0);
}
`;
