/** Shader code of skin that is pressed: folds along the lines that the cast has. */

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
in vec3 vFrontal; // the place on the generic head, metres
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
  // Each opening of the mouth presses the cheeks' folds: there they are form, and hardly lines
  vec2 off = (vec2(abs(vFrontal.x), vFrontal.y) - vec2(0.034, -0.068)) / vec2(0.018, 0.036);
  float beside = exp(-dot(off, off)) * (1.0 - at.fur);
  found.slope *= 1.0 - 0.35 * beside;
  found.groove *= 1.0 - 0.65 * beside;
  return found;
}
`;
