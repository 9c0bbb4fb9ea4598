/** Shader code that finds the edges of an opening on the blended face. */

import { EDGE_POINTS } from "../anatomy/openings";

/** For vertex shaders, after VERTEX_HEAD: where the edges of an opening (`openings.ts`) are on the blended face. */
export const OPENING = `
uniform int upperRows[${EDGE_POINTS}];
uniform int lowerRows[${EDGE_POINTS}];

/** The edges over and under a place, and the corners; all in metres, before the head turns. */
struct Gap { vec3 upper; vec3 lower; vec3 right; vec3 left; };

vec3 between(vec3 from, vec3 to, float x) {
  return mix(from, to, clamp((x - from.x) / max(to.x - from.x, 1e-5), 0.0, 1.0));
}

Gap gapAt(float x) {
  vec3 up = rowAt(upperRows[0]);
  vec3 low = rowAt(lowerRows[0]);
  Gap gap = Gap(up, low, up, up);
  for (int n = 1; n < ${EDGE_POINTS}; n++) {
    vec3 nextUp = rowAt(upperRows[n]);
    vec3 nextLow = rowAt(lowerRows[n]);
    if (x > up.x) gap.upper = between(up, nextUp, x);
    if (x > low.x) gap.lower = between(low, nextLow, x);
    up = nextUp;
    low = nextLow;
  }
  gap.left = up;
  return gap;
}

/** How far a place lies under the upper edge and over the lower one; both are negative beside the opening. */
vec2 insideOf(Gap gap, vec2 place) {
  float beside = max(gap.right.x - place.x, place.x - gap.left.x);
  vec2 inside = vec2(gap.upper.y - place.y, place.y - gap.lower.y);
  return beside > 0.0 ? min(inside, -beside) : inside;
}
`;
