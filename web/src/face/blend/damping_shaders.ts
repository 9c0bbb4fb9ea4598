/** Shaders that damp a sum, patch by patch, before it is corrected, where it turns triangles far over. */

import { DATA_WIDTH } from "../anatomy/correctives_data";
import { HEAD } from "./corrective_shaders";

/** Per triangle: the share of the sum that it may keep. */
export const KEEP_FRAGMENT = `${HEAD}
uniform sampler2D points;
uniform sampler2D rest;
uniform sampler2D allowed;
uniform sampler2D restNormals;
uniform usampler2D triangles;
uniform vec3 limits; // what is kept upright of an area, how far it may be turned over, the least share that is kept
out vec4 kept;

vec3 still(uint place, int slot) { return texelFetch(rest, inSlot(place, slot, lines.x), 0).xyz; }
vec3 move(uint place, int slot) { return texelFetch(points, inSlot(place, slot, lines.x), 0).xyz - still(place, slot); }

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  int slot = here.y / lines.y;
  ivec2 own = here - ivec2(0, slot * lines.y);
  uvec4 places = texelFetch(triangles, own, 0);
  vec4 rested = texelFetch(restNormals, here, 0);
  vec3 a = still(places.x, slot);
  vec3 b = still(places.y, slot) - a;
  vec3 c = still(places.z, slot) - a;
  vec3 moveA = move(places.x, slot);
  vec3 moveB = move(places.y, slot) - moveA;
  vec3 moveC = move(places.z, slot) - moveA;
  uint number = uint(own.y * ${DATA_WIDTH} + own.x);
  float goal = limits.x - texelFetch(allowed, inSlot(number, slot, lines.w), 0).x - limits.y;
  // The area at a share s of the move is 1 + slope s + square s^2.
  float slope = dot(cross(b, moveC) + cross(moveB, c), rested.xyz) / rested.w;
  float square = dot(cross(moveB, moveC), rested.xyz) / rested.w;
  float share = 1.0;
  if (1.0 + slope + square < goal) {
    float root = sqrt(max(slope * slope - 4.0 * square * (1.0 - goal), 0.0));
    share = max(2.0 * (1.0 - goal) / max(root - slope, 1e-12), limits.z);
  }
  kept = vec4(share, 0.0, 0.0, 0.0);
}
`;

/** Per patch, one line of texels to a slot: what the worst of its triangles may keep. */
export const PATCH_FRAGMENT = `${HEAD}
uniform sampler2D kept;
uniform usampler2D heard;
uniform usampler2D patches;
uniform uint count;
out vec4 least;

void main() {
  int slot = int(gl_FragCoord.y);
  uint own = uint(gl_FragCoord.x);
  float share = 1.0;
  if (own < count) {
    uvec4 span = texelFetch(patches, dataAt(own), 0);
    for (uint n = span.x; n < span.y; n++)
      share = min(share, texelFetch(kept, inSlot(texelFetch(heard, dataAt(n), 0).x, slot, lines.y), 0).x);
  }
  least = vec4(share, 0.0, 0.0, 0.0);
}
`;

/** Per place: back towards where it is at rest, by what its patches lose. */
export const DAMP_FRAGMENT = `${HEAD}
uniform sampler2D points;
uniform sampler2D rest;
uniform sampler2D least;
uniform sampler2D members;
uniform int each;
out vec4 position;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  int slot = here.y / lines.x;
  uint own = uint((here.y - slot * lines.x) * ${DATA_WIDTH} + here.x);
  vec3 at = texelFetch(points, here, 0).xyz;
  float lost = 0.0;
  for (int k = 0; k < each; k++) {
    vec2 member = texelFetch(members, dataAt(own * uint(each) + uint(k)), 0).xy;
    lost += member.y * (1.0 - texelFetch(least, ivec2(int(member.x + 0.5), slot), 0).x);
  }
  position = vec4(at + lost * (texelFetch(rest, here, 0).xyz - at), 1.0);
}
`;
