/** Shader code of skin that is pressed: folds along the lines that the cast has, and tears that run over it. */

/** The slope that 0 and 1 of a layer of folds stand for, and the rank that 1 does (tools/baking/skin/folds.py). */
const [STEEPEST, RANKS] = [1.25, 1.5];

/**
 * Folds: how deep a line shows is the share of the most that its place is pressed across it, by age. The lines lie on S
 * and only their depth changes, so nothing swims. `Folded`: where the skin rises, as a slope in space, and how deep it
 * lies in grooves, 0..1.
 */
export const FOLDS = `
uniform sampler2D level_folds;
uniform sampler2D upright_folds;
uniform float folds;
in vec3 vPressed; // level, mixed, upright, of the most
struct Folded { vec3 slope; float groove; };

/** How deep a line is; \`across\`: its normal, level and upright. */
float depthOf(vec4 line, vec2 across, Ground at) {
  float pressed = -(vPressed.x * across.x * across.x + 2.0 * vPressed.y * across.x * across.y + vPressed.z * across.y * across.y);
  float rank = line.b * ${RANKS.toFixed(1)};
  float grown = smoothstep(rank - 0.35, rank + 0.12, age);
  float skinned = (1.0 - at.hair) * (1.0 - lacquer) * (1.0 - 0.6 * at.lips);
  return folds * clamp(1.7 * (pressed - 0.12), 0.0, 1.2) * mix(mix(0.42, 1.15, sqrt(age)) * grown, 1.3, at.fur) * skinned;
}

vec2 turnedBy(vec4 line) {
  float turn = (line.a - 0.5) * 3.14159265;
  return vec2(cos(turn), sin(turn));
}

Folded foldsAt(vec3 normal, Ground at) {
  vec3 level = normalize(cross(vUp, normal));
  vec3 upright = cross(normal, level);
  vec4 line = layer(level_folds);
  vec2 turn = turnedBy(line);
  vec2 across = vec2(-turn.y, turn.x);
  float depth = depthOf(line, across, at);
  float slope = (line.r - 0.5) * ${(2 * STEEPEST).toFixed(2)} * depth;
  Folded found = Folded(slope * (across.x * level + across.y * upright), line.g * depth);
  line = layer(upright_folds);
  across = turnedBy(line);
  depth = depthOf(line, across, at);
  slope = (line.r - 0.5) * ${(2 * STEEPEST).toFixed(2)} * depth;
  found.slope += slope * (across.x * level + across.y * upright);
  found.slope *= inversesqrt(1.0 + dot(found.slope, found.slope)); // softly below 1
  found.groove = clamp(max(found.groove, line.g * depth), 0.0, 1.0);
  return found;
}
`;

/**
 * Tears: two ways a side, down from the lower lid and past the corner of the mouth. `Tear`: how much water lies there, and the
 * slope of its surface aside and up. Slopes go into the mirror alone: in diffuse light they would be dark slits.
 */
export const TEARS = `
uniform float tears;
uniform float drops; // metres that they have run
in vec3 vFrontal; // the place on the generic head, metres
struct Tear { float water; vec2 slope; };

/** One way: where it begins, how far aside it goes, and where its drops are. */
Tear wayOf(vec2 place, vec2 start, float aside, float ahead, float reach) {
  float down = start.y - place.y;
  float share = clamp(down / 0.085, 0.0, 1.0);
  float middle = start.x + aside * share * (1.6 - 0.6 * share) + 0.0008 * sin(down * 330.0 + ahead * 40.0) * share;
  float off = (place.x - middle) / 0.0011;
  float film = exp(-off * off) * smoothstep(-0.001, 0.003, down) * (1.0 - smoothstep(reach - 0.012, reach, down));
  float along = fract((down - drops) / 0.038 + ahead);
  vec2 from = vec2(place.x - middle, (along - 0.5) * 0.038) / vec2(0.0021, 0.0034);
  float drop = exp(-dot(from, from)) * smoothstep(0.0, 0.006, down) * (1.0 - smoothstep(reach - 0.006, reach, down));
  return Tear(max(0.55 * film, drop), vec2(off * film * 0.35 + 1.1 * from.x * drop, -1.1 * from.y * drop));
}

Tear tearAt() {
  float run = smoothstep(0.3, 0.6, tears);
  if (run == 0.0) return Tear(0.0, vec2(0.0));
  vec2 place = vec2(abs(vFrontal.x), vFrontal.y);
  float side = vFrontal.x > 0.0 ? 0.0 : 0.37;
  float reach = 0.1 * smoothstep(0.3, 1.0, tears);
  Tear inner = wayOf(place, vec2(0.0235, -0.0125), 0.0085, side, reach);
  Tear outer = wayOf(place, vec2(0.0385, -0.0115), 0.0045, side + 0.61, 0.8 * reach);
  float front = smoothstep(0.06, 0.08, vFrontal.z);
  vec2 slope = (inner.slope + outer.slope) * vec2(sign(vFrontal.x), 1.0);
  return Tear(run * front * max(inner.water, outer.water), run * front * slope);
}
`;
