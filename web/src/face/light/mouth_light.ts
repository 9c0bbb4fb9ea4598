/** Light in the mouth, one law for teeth, gums, tongue and lining. */

/**
 * `skyThrough`: the share of the light from everywhere that comes through the lips to a place `deep` behind them; `edges`:
 * how far it is under the upper one, over the lower one, and from the two corners, metres. It is a rectangle's form
 * factor, taken for each direction by itself. `outOfDark`: how much of a place is seen where so much comes in.
 */
export const MOUTH_LIGHT_LAW = `
/** What the mouth's end shows of the key light: all that lies in it dies in this, so none of it ends in an edge. */
const vec3 MOUTH_DARK = vec3(0.026, 0.0075, 0.0062);

float outOfDark(float sky) { return smoothstep(0.02, 0.32, sky); }

float skyThrough(vec4 edges, float deep) {
  vec4 sines = edges * inversesqrt(edges * edges + deep * deep + 4e-6);
  return max(0.5 * (sines.x + sines.y), 0.0) * max(0.5 * (sines.z + sines.w), 0.0);
}
`;
