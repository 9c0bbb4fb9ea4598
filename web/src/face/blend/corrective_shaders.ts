/** Shaders of the corrective passes: folds repaired, lids off eyeballs, lips apart; for several characters at once. */

import { RUNGS } from "../../link/constants";
import { type CorrectivesData, DATA_WIDTH } from "../anatomy/correctives_data";
import { ROW_SHIFT, ROW_WIDTH } from "../gpu/pass_shaders";

/** Characters that the passes take at once. */
export const SLOTS = 8;

/** Lines of a slot in the textures: places, triangles, rungs, allowances. */
export type Lines = readonly [places: number, triangles: number, rungs: number, allowed: number];

/** A number as GLSL reads it as a float, in full. */
const float = (value: number): string => value.toExponential();

/*
 * All passes but the first and the last draw one texel per place (`correctives_data.ts`), not one point per row: software
 * renderers shade whole blocks of texels at once.
 */

/** What all shaders begin with: the numbers that never change, and where things lie in the textures. */
export function correctiveHead({ document, ...data }: CorrectivesData, lines: Lines): string {
  const { least_area, floor, over_relaxation, least_slope, full, momentum, margin, farthest } = document;
  const upward = data.upward.reduce((bits, up, line) => bits + (up > 0.5 ? 2 ** line : 0), 0);
  return `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

// What omote.perform.blending.correctives and omote.geometry.orientation say of each.
const float LEAST_AREA = ${float(least_area)};
const float FLOOR = ${float(floor)};
const float OVER_RELAXATION = ${float(over_relaxation)};
const float LEAST_SLOPE = ${float(least_slope)};
const float FULL = ${float(full)};
const float MOMENTUM = ${float(momentum)};
const float MARGIN = ${float(margin)};
const float FARTHEST = ${float(farthest)};
const float DEEP = ${float(document.deep)};
const float KEPT = ${float(document.kept)};
const float SLIVER = ${float(document.sliver)};
const float BULGE = ${float(document.bulge)};
const float CORNEA_END = ${float(Math.cos(document.cornea))}; // the cosine

const ivec4 lines = ivec4(${lines.join(", ")}); // of places, triangles, rungs, allowances
const int FIRST_RUNG = ${data.triangles.length / 4}; // its place in an allowance
const int UPWARD = ${upward}; // a bit for each line that opens upward
const int ANCHORS = ${data.width}; // of a follower
const uint PATCHES = ${data.patches.length / 2}u;
const int ROW_PATCHES = ${data.rowPatches};

ivec2 rowAt(uint row) { return ivec2(int(row & ${ROW_WIDTH - 1}u), int(row >> ${ROW_SHIFT})); }
ivec2 dataAt(uint index) { return ivec2(int(index % ${DATA_WIDTH}u), int(index / ${DATA_WIDTH}u)); }

// Characters lie one above the other: each has a slot of so many lines in every texture that is its own.
ivec2 inSlot(uint index, int slot, int height) { return dataAt(index) + ivec2(0, slot * height); }
ivec2 here() { return ivec2(gl_FragCoord.xy); }
int slotHere(int height) { return here().y / height; }
ivec2 ownHere(int height) { return here() - ivec2(0, slotHere(height) * height); }
uint numberOf(ivec2 own) { return uint(own.y * ${DATA_WIDTH} + own.x); }

vec3 placeAt(sampler2D points, uint place, int slot) { return texelFetch(points, inSlot(place, slot, lines.x), 0).xyz; }
float allowance(sampler2D allowed, uint place, int slot) { return texelFetch(allowed, inSlot(place, slot, lines.w), 0).x; }

/** A triangle's first corner, and the way from there to the other two. */
mat3 triangleAt(sampler2D points, uvec4 places, int slot) {
  vec3 a = placeAt(points, places.x, slot);
  return mat3(a, placeAt(points, places.y, slot) - a, placeAt(points, places.z, slot) - a);
}

/** The area between two edges, seen along the normal at rest, of that at rest; negative: folded. */
float areaShare(vec3 b, vec3 c, vec4 rested) { return dot(cross(b, c), rested.xyz) / rested.w; }
`;
}

/** Textures of whole numbers; all others hold floats. */
const WHOLE = ["rows", "triangles", "patchTriangles", "patches", "rungPlaces", "spans", "corners", "roles"];

/** The declarations of what a shader reads. */
export function samplersOf(body: string): string {
  const reads = body.matchAll(/\b(?:texelFetch|placeAt|triangleAt|allowance)\((\w+)/g);
  const names = new Set(Array.from(reads, ([, name]) => name as string));
  return [...names].map((name) => `uniform ${WHOLE.includes(name) ? "usampler2D" : "sampler2D"} ${name};\n`).join("");
}

/** The shaders by pass, without their head and their samplers. */
export const CORRECTIVE_FRAGMENTS = {
  /** The rows that may move, gathered from all positions of the character in a slot. */
  gather: `
out vec4 position;
void main() { position = texelFetch(mixed, rowAt(texelFetch(rows, ownHere(lines.x), 0).x), 0); }
`,

  /** Per triangle: the share of the sum that it may keep. */
  keep: `
out vec4 kept;

void main() {
  int slot = slotHere(lines.y);
  ivec2 own = ownHere(lines.y);
  uvec4 places = texelFetch(triangles, own, 0);
  vec4 rested = texelFetch(restNormals, here(), 0);
  mat3 still = triangleAt(rest, places, slot);
  mat3 move = triangleAt(points, places, slot) - still;
  float goal = LEAST_AREA - allowance(allowed, numberOf(own), slot) - DEEP * max(SLIVER / sqrt(rested.w), 1.0);
  // The area at a share s of the move is 1 + slope s + square s^2.
  float slope = dot(cross(still[1], move[2]) + cross(move[1], still[2]), rested.xyz) / rested.w;
  float square = areaShare(move[1], move[2], rested);
  float share = 1.0;
  if (1.0 + slope + square < goal) {
    float root = sqrt(max(slope * slope - 4.0 * square * (1.0 - goal), 0.0));
    share = max(2.0 * (1.0 - goal) / max(root - slope, 1e-12), KEPT);
  }
  kept = vec4(share, 0.0, 0.0, 0.0);
}
`,

  /** Per patch, one line of texels to a slot: what the worst of its triangles may keep. */
  patch: `
out vec4 least;

void main() {
  uint own = uint(gl_FragCoord.x);
  float share = 1.0;
  if (own < PATCHES) {
    uvec4 span = texelFetch(patches, dataAt(own), 0);
    for (uint n = span.x; n < span.y; n++) {
      uint triangle = texelFetch(patchTriangles, dataAt(n), 0).x;
      share = min(share, texelFetch(kept, inSlot(triangle, here().y, lines.y), 0).x);
    }
  }
  least = vec4(share, 0.0, 0.0, 0.0);
}
`,

  /** Per place: back towards where it is at rest, by what its patches lose. */
  damp: `
out vec4 position;

void main() {
  int slot = slotHere(lines.x);
  uint first = numberOf(ownHere(lines.x)) * uint(ROW_PATCHES);
  vec3 at = texelFetch(points, here(), 0).xyz;
  float lost = 0.0;
  for (int k = 0; k < ROW_PATCHES; k++) {
    vec2 member = texelFetch(members, dataAt(first + uint(k)), 0).xy;
    lost += member.y * (1.0 - texelFetch(least, ivec2(int(member.x + 0.5), slot), 0).x);
  }
  position = vec4(at + lost * (texelFetch(rest, here(), 0).xyz - at), 1.0);
}
`,

  /** What either side of a line gives way at each rung: one texel a rung, one line of texels a line, slot above slot. */
  rung: `
out vec4 half_;

void main() {
  int slot = slotHere(lines.z);
  ivec2 own = ownHere(lines.z);
  uvec4 places = texelFetch(rungPlaces, own, 0);
  vec4 weights = texelFetch(rungWeights, own, 0);
  vec3 still = vec3(0.0);
  vec3 now = vec3(0.0);
  for (int k = 0; k < 4; k++) {
    still += weights[k] * placeAt(rest, places[k], slot);
    now += weights[k] * placeAt(points, places[k], slot);
  }
  vec3 along = (UPWARD >> own.y & 1) == 1 ? vec3(0.0, 1.0, 0.0) : still / max(length(still), 1e-9);
  float free = allowance(allowed, uint(FIRST_RUNG + own.y * ${RUNGS} + own.x), slot);
  float lack = max(min(dot(along, still), 0.0) - free - dot(along, now), 0.0);
  half_ = vec4(0.5 * lack * along, 0.0);
}
`,

  /** Lids and lips that cross give way; lids leave the eyeball. */
  part: `
uniform vec3 centres[${2 * SLOTS}];
uniform float radii[${2 * SLOTS}];
uniform vec3 sights[${2 * SLOTS}];
uniform bool leaving;
out vec4 position;

float depth(vec3 at, int eye, vec3 sight) {
  vec3 outward = at - centres[eye];
  float far = max(length(outward), 1e-9);
  float up = max((dot(outward, sight) / far - CORNEA_END) / (1.0 - CORNEA_END), 0.0);
  return radii[eye] * (1.0 + BULGE * up * up * (3.0 - 2.0 * up)) - far;
}

vec3 left(vec3 at, uvec4 span, int slot) {
  if (!leaving || span.x == 0u) return at;
  int eye = 2 * slot + int(span.x) - 1;
  float still = max(depth(texelFetch(rest, here(), 0).xyz, eye, vec3(0.0, 0.0, 1.0)), 0.0);
  float push = max(depth(at, eye, sights[eye]) - still - allowance(allowed, span.y, slot), 0.0);
  vec3 outward = at - centres[eye];
  return at + push * outward / max(length(outward), 1e-9);
}

void main() {
  int slot = slotHere(lines.x);
  ivec2 own = ownHere(lines.x);
  vec3 at = texelFetch(points, here(), 0).xyz;
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
`,

  /** Normals of the triangles at rest, twice the areas long, and their squared lengths. */
  rest: `
out vec4 normal;

void main() {
  mat3 still = triangleAt(rest, texelFetch(triangles, ownHere(lines.y), 0), slotHere(lines.y));
  vec3 facing = cross(still[1], still[2]);
  normal = vec4(facing, dot(facing, facing));
}
`,

  /** What each triangle is to keep of its area: what it is allowed to, and beyond it a margin where it lacks that now. */
  goal: `
out vec4 goal;

void main() {
  int slot = slotHere(lines.y);
  ivec2 own = ownHere(lines.y);
  mat3 now = triangleAt(points, texelFetch(triangles, own, 0), slot);
  float keeps = max(LEAST_AREA - allowance(allowed, numberOf(own), slot), FLOOR);
  float lack = max(keeps - areaShare(now[1], now[2], texelFetch(restNormals, here(), 0)), 0.0);
  goal = vec4(keeps + min(MARGIN * lack, FARTHEST), 0.0, 0.0, 0.0);
}
`,

  /** A round of fold repair: each vertex takes the mean of what its triangles want that lack area, and goes on a share of
   * its last step; one that lacks next to nothing weighs next to nothing, or it would halve what another wants at once. */
  repair: `
out vec4 position;

void main() {
  int slot = slotHere(lines.x);
  vec3 at = texelFetch(points, here(), 0).xyz;
  uvec4 span = texelFetch(spans, ownHere(lines.x), 0);
  vec3 push = vec3(0.0);
  float wanted = 0.0;
  for (uint n = span.z; n < span.w; n++) {
    uvec4 corner = texelFetch(corners, dataAt(n), 0);
    ivec2 triangle = inSlot(corner.z, slot, lines.y);
    vec4 rested = texelFetch(restNormals, triangle, 0);
    vec3 b = placeAt(points, corner.x, slot) - at;
    vec3 c = placeAt(points, corner.y, slot) - at;
    float lack = texelFetch(goals, triangle, 0).x - areaShare(b, c, rested);
    if (lack <= 0.0) continue;
    vec3 atB = cross(c, rested.xyz) / rested.w;
    vec3 atC = cross(rested.xyz, b) / rested.w;
    vec3 own = -atB - atC;
    float slope = dot(own, own) + dot(atB, atB) + dot(atC, atC);
    float weight = min(lack / FULL, 1.0);
    push += weight * lack / max(slope, LEAST_SLOPE * inversesqrt(rested.w)) * own;
    wanted += weight;
  }
  if (wanted > 0.0)
    at += MOMENTUM * min(wanted, 1.0) * (at - texelFetch(earlier, here(), 0).xyz) + OVER_RELAXATION / wanted * push;
  position = vec4(at, 1.0);
}
`,

  /** All positions again: what is corrected; inner skin and lashes that go with the skin they hang on; the rest as mixed. */
  spread: `
uniform int slot;
out vec4 position;

void main() {
  uvec4 role = texelFetch(roles, here(), 0);
  position = texelFetch(mixed, here(), 0);
  if (role.x > 0u) position = texelFetch(points, inSlot(role.x - 1u, slot, lines.x), 0);
  if (role.y == 0u) return;
  for (int k = 0; k < ANCHORS; k++) {
    vec2 anchor = texelFetch(anchors, dataAt((role.y - 1u) * uint(ANCHORS) + uint(k)), 0).xy;
    if (anchor.y == 0.0) continue;
    uint place = uint(anchor.x + 0.5);
    position.xyz += anchor.y * (placeAt(points, place, slot) - placeAt(before, place, slot));
  }
}
`,
} as const;
