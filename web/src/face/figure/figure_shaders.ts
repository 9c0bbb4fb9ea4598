/** Shaders of the passes that hang a body below a head and skin both. */

import { LIMBS, SHAPES } from "../../link/constants";
import { CORRECTED } from "../../link/figures";
import { PASS_HEAD, ROW_SHIFT, ROW_WIDTH } from "../gpu/pass_shaders";

/** Bodies that are mixed at most. */
export const MOST_BODIES = 16;

/** Texels of one bone: three lines of its turn with its shift (w), and the two parts of its dual quaternion. */
export const BONE_TEXELS = 5;

const ROW_TEXEL = `ivec2 texelOf(int row) { return ivec2(row & ${ROW_WIDTH - 1}, row >> ${ROW_SHIFT}); }`;

/**
 * What the head's edge is off the body's own, one texel a row of the edge: less the mean of the rim, which lies behind the
 * last.
 */
export const edgeFragment = (edge: number, rim: number): string => `${PASS_HEAD}
uniform sampler2D head;
uniform usampler2D edgeRows;
uniform sampler2D bodyEdge;
out vec4 off;
${ROW_TEXEL}

vec3 offAt(int place) {
  int row = int(texelFetch(edgeRows, ivec2(place, 0), 0).x);
  return texelFetch(head, texelOf(row), 0).xyz - texelFetch(bodyEdge, ivec2(place, 0), 0).xyz;
}

void main() {
  int place = int(gl_FragCoord.x);
  vec3 mean = vec3(0.0);
  for (int at = 0; at < ${rim}; at++) mean += offAt(at);
  mean /= ${rim}.0;
  off = vec4(place < ${edge} ? offAt(place) - mean : mean, 1.0);
}
`;

/** The rows of a space of figures, as the shader is written for them. */
export interface FigureRows {
  readonly head: number;
  readonly body: number;
  readonly edge: number;
  /** Those that have correctives, which lie behind the body's rows in each of the bodies' layers. */
  readonly bending: number;
}

const CALLS = `vec${SHAPES}`;

/**
 * The rows of a figure: those of the head as they are blended, those of the body summed over bodies and joined to the
 * head's edge; those of limbs moved as fields have it; those around joints with their correctives; then skinned, by its share by dual quaternions and else linearly (\`omote.geometry.skinning\`).
 */
export const figureFragment = ({ head, body, edge, bending }: FigureRows): string => `${PASS_HEAD}
uniform sampler2D head;
uniform sampler2DArray bodies;
uniform usampler2D rows;
uniform sampler2D join;
uniform sampler2D off;
uniform sampler2D bones;
uniform vec2 mixed[${MOST_BODIES}]; // layer, weight
uniform int count;
uniform sampler2D limbPlaces; // of rows on limbs: how far along, which limb
uniform sampler2D limbFields; // of these: out, round, along
uniform vec3 limbAxes[${3 * LIMBS.length}]; // of each limb: where it begins, from there to its end, about what angles grow
uniform bool limbsMove;
uniform ${CALLS} calls[${CORRECTED}]; // of correctives, by joint
out vec4 position;
${ROW_TEXEL}

vec3 bodyAt(int row, int joined) {
  vec3 sum = texelFetch(off, ivec2(${edge}, 0), 0).xyz;
  ivec2 at = texelOf(row);
  for (int i = 0; i < count; i++) sum += mixed[i].y * texelFetch(bodies, ivec3(at, int(mixed[i].x)), 0).xyz;
  if (joined >= 0)
    for (int i = 0; i < ${edge}; i++)
      sum += texelFetch(join, ivec2(i, joined), 0).x * texelFetch(off, ivec2(i, 0), 0).xyz;
  return sum;
}

vec3 limbMove(int place, vec3 here) {
  ivec2 at = texelOf(place);
  vec3 field = texelFetch(limbFields, at, 0).xyz;
  if (field == vec3(0.0)) return field;
  vec2 lies = texelFetch(limbPlaces, at, 0).xy;
  int limb = 3 * int(lies.y + 0.5);
  vec3 way = limbAxes[limb + 1];
  vec3 off = here - limbAxes[limb] - lies.x * way;
  return field.x * off + field.y * cross(limbAxes[limb + 2], off) + field.z * way;
}

vec3 correctiveAt(int place, ${CALLS} called) {
  vec3 sum = vec3(0.0);
  for (int shape = 0; shape < ${SHAPES}; shape++) {
    if (called[shape] == 0.0) continue;
    ivec2 at = texelOf(${body} + shape * ${bending} + place);
    for (int i = 0; i < count; i++)
      sum += called[shape] * mixed[i].y * texelFetch(bodies, ivec3(at, int(mixed[i].x)), 0).xyz;
  }
  return sum;
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  int row = (at.y << ${ROW_SHIFT}) + at.x;
  position = vec4(0.0, 0.0, 0.0, 1.0);
  if (row >= ${head + body}) return;
  uvec4 first = texelFetch(rows, ivec2(2 * at.x, at.y), 0);
  uvec4 second = texelFetch(rows, ivec2(2 * at.x + 1, at.y), 0);
  vec3 here = row < ${head} ? texelFetch(head, at, 0).xyz : bodyAt(row - ${head}, int(second.w & 65535u) - 1);
  int limb = int(second.w >> 16) - 1;
  if (limbsMove && limb >= 0) here += limbMove(limb, here);
  int bent = int((second.z >> 8) & 65535u) - 1;
  if (bent >= 0) here += correctiveAt(bent, calls[int(second.z >> 24)]);
  uvec4 named = uvec4(first.xy, 0u, 0u);
  uvec4 pairs = uvec4(first.zw, second.xy); // of weights
  float share = float(second.z & 255u) / 255.0;
  vec3 linear = vec3(0.0);
  vec4 real = vec4(0.0), dual = vec4(0.0), leading = vec4(0.0);
  for (int i = 0; i < 8; i++) {
    uint weighed = (pairs[i >> 1] >> uint(16 * (i & 1))) & 65535u;
    if (weighed == 0u) break; // they fall
    float weight = float(weighed) / 65535.0;
    int bone = ${BONE_TEXELS} * int((named[i >> 2] >> uint(8 * (i & 3))) & 255u);
    if (share < 1.0) {
      vec4 a = texelFetch(bones, ivec2(bone, 0), 0), b = texelFetch(bones, ivec2(bone + 1, 0), 0), c = texelFetch(bones, ivec2(bone + 2, 0), 0);
      linear += weight * (vec3(dot(a.xyz, here), dot(b.xyz, here), dot(c.xyz, here)) + vec3(a.w, b.w, c.w));
    }
    if (share > 0.0) {
      vec4 turn = texelFetch(bones, ivec2(bone + 3, 0), 0);
      if (i == 0) leading = turn;
      if (dot(leading, turn) < 0.0) weight = -weight; // the shorter way
      real += weight * turn;
      dual += weight * texelFetch(bones, ivec2(bone + 4, 0), 0);
    }
  }
  vec3 moved = (1.0 - share) * linear;
  if (share > 0.0) {
    float size = length(real);
    vec4 r = real / size, d = dual / size;
    vec3 u = cross(r.xyz, here) + r.w * here;
    moved += share * (here + 2.0 * cross(r.xyz, u) + 2.0 * (r.w * d.xyz - d.w * r.xyz + cross(r.xyz, d.xyz)));
  }
  position = vec4(moved, 1.0);
}
`;
