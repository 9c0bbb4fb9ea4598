/** The passes that put all faces where the hand leads: of each face the bands of its atlas that hold rows that change. */

import { ROW_SHIFT, ROW_WIDTH } from "../../../face/gpu/pass_shaders";

/** Faces that the atlas holds at most: the work, ten beside it, and one that leaves. */
export const MOST_BLOCKS = 12;

const HEAD = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp isampler2D;
precision highp usampler2D;
precision highp sampler2DArray;
uniform int lines; // of the atlas that one face takes
`;

/** A row of a face in the atlas: faces lie one below the other. */
const PLACES = `
ivec2 texel(int row, int block) { return ivec2(row & ${ROW_WIDTH - 1}, block * lines + (row >> ${ROW_SHIFT})); }
`;

/** Lines of a band: drivers without a graphics processor shade four by four texels at once, however few are asked for. */
export const BAND = 4;

/** A rectangle for each band in the list and each of \`faces\` blocks from \`firstBlock\` on. */
export const BAND_VERTEX = `${HEAD}
uniform int firstBlock;
uniform int faces;
uniform float height; // of the atlas, lines
in uint band;
flat out int vBlock;
void main() {
  vBlock = firstBlock + gl_InstanceID % faces;
  ivec2 corner = ivec2(gl_VertexID & 1, gl_VertexID >> 1);
  int line = vBlock * lines + min(${BAND} * (int(band) + corner.y), lines);
  gl_Position = vec4(float(corner.x) * 2.0 - 1.0, float(line) / height * 2.0 - 1.0, 0.0, 1.0);
}
`;

const FRAGMENT = `${HEAD}
flat in int vBlock;
out vec4 result;
${PLACES}
`;

/** The texel that is drawn, and the row that it holds. */
const HERE = `
  ivec2 at = ivec2(gl_FragCoord.xy);
  int row = ((at.y - vBlock * lines) << ${ROW_SHIFT}) | at.x;
`;

/** A linearised displacement: tangents times field (docs/method.md, "Drags: tangents and the solve"). */
export const MOVE_FRAGMENT = `${FRAGMENT}
uniform sampler2DArray tangents;
uniform sampler2D fields;
uniform int slots[${MOST_BLOCKS}]; // which of the fields a face takes; -1: none
void main() {
  result = vec4(0.0);
  int slot = slots[vBlock];
  if (slot < 0) return;
  ${HERE}
  vec3 field = texelFetch(fields, texel(row, slot), 0).xyz;
  result.xyz = texelFetch(tangents, ivec3(at, 0), 0).xyz * field.x
    + texelFetch(tangents, ivec3(at, 1), 0).xyz * field.y
    + texelFetch(tangents, ivec3(at, 2), 0).xyz * field.z;
}
`;

/** Base, displacement (a follower: that of its anchors), and what easing still holds back. */
export const PLACE_FRAGMENT = `${FRAGMENT}
uniform sampler2D bases;
uniform sampler2D offsets;
uniform sampler2D moves;
uniform usampler2D spans; // first and end of a row's anchors
uniform sampler2D anchors; // row, share
uniform float lags[${MOST_BLOCKS}];
void main() {
  ${HERE}
  vec3 place = texelFetch(bases, at, 0).xyz + texelFetch(moves, at, 0).xyz;
  uvec2 span = texelFetch(spans, texel(row, 0), 0).xy;
  for (uint slot = span.x; slot < span.y; slot++) {
    vec2 anchor = texelFetch(anchors, ivec2(int(slot & 511u), int(slot >> 9)), 0).xy;
    place += anchor.y * texelFetch(moves, texel(int(anchor.x), vBlock), 0).xyz;
  }
  float lag = lags[vBlock];
  if (lag > 0.0) place += lag * texelFetch(offsets, at, 0).xyz;
  result = vec4(place, 1.0);
}
`;

/** Area-weighted normals from the triangles around each row. */
export const TURN_FRAGMENT = `${FRAGMENT}
uniform sampler2D positions;
uniform usampler2D ranges;
uniform usampler2D corners;
vec3 place(uint row) { return texelFetch(positions, texel(int(row), vBlock), 0).xyz; }
void main() {
  ${HERE}
  vec3 here = place(uint(row));
  uvec2 range = texelFetch(ranges, texel(row, 0), 0).xy;
  vec3 sum = vec3(0.0);
  for (uint slot = range.x; slot < range.y; slot++) {
    uvec2 pair = texelFetch(corners, ivec2(int(slot & 511u), int(slot >> 9)), 0).xy;
    sum += cross(place(pair.x) - here, place(pair.y) - here);
  }
  float size = length(sum);
  result = vec4(size > 0.0 ? sum / size : vec3(0.0, 0.0, 1.0), 1.0);
}
`;
