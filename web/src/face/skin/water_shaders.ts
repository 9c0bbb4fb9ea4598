/** Shader code of what lies on the skin: tears that run over it, and sweat. */

/**
 * `Water`: how much lies there as a drop, the slope of its surface aside and up, and how much as a film. Slopes go into
 * the mirror alone: in diffuse light they would be dark slits. `drops`: the metres that both have run, so that all tiles
 * of a wall have them at one place.
 */
const DROPS = `
uniform float drops;
struct Water { float lies; vec2 slope; float film; };

float bell(vec2 place, vec2 middle, vec2 radius) {
  vec2 off = (place - middle) / radius;
  return exp(-dot(off, off));
}
`;

/** Tears: two ways a side, down from the lower lid and past the corner of the mouth. */
const TEARS = `
uniform float tears;

/** One way: where it begins, how far aside it goes, and where its drops are. */
Water wayOf(vec2 place, vec2 start, float aside, float ahead, float reach) {
  float down = start.y - place.y;
  float share = clamp(down / 0.085, 0.0, 1.0);
  float middle = start.x + aside * share * (1.6 - 0.6 * share) + 0.0008 * sin(down * 330.0 + ahead * 40.0) * share;
  float off = (place.x - middle) / mix(0.0014, 0.0010, share);
  float edge = (abs(off) - 1.05) / 0.4; // a film is level, and rises from the skin at its two edges
  float film = (1.0 - smoothstep(0.7, 1.5, abs(off))) * smoothstep(-0.001, 0.003, down) * (1.0 - smoothstep(reach - 0.012, reach, down));
  float along = fract((down - drops) / 0.038 + ahead);
  vec2 from = vec2(place.x - middle, (along - 0.5) * 0.038) / vec2(0.0021, 0.0034);
  float drop = exp(-dot(from, from)) * smoothstep(0.0, 0.006, down) * (1.0 - smoothstep(reach - 0.006, reach, down));
  return Water(max(0.55 * film, drop), vec2(0.8 * sign(off) * exp(-edge * edge) * film + 1.1 * from.x * drop, -1.1 * from.y * drop), 0.0);
}

Water tearAt(vec2 place, float side) {
  float run = smoothstep(0.3, 0.6, tears);
  if (run == 0.0) return Water(0.0, vec2(0.0), 0.0);
  float ahead = side > 0.0 ? 0.0 : 0.37;
  float reach = 0.1 * smoothstep(0.3, 1.0, tears);
  Water inner = wayOf(place, vec2(0.0235, -0.0125), 0.0085, ahead, reach);
  Water outer = wayOf(place, vec2(0.0385, -0.0115), 0.0045, ahead + 0.61, 0.8 * reach);
  float front = smoothstep(0.06, 0.08, vFrontal.z);
  vec2 slope = (inner.slope + outer.slope) * vec2(side, 1.0);
  return Water(run * front * max(inner.lies, outer.lies), run * front * slope, 0.0);
}
`;

/**
 * Sweat: a film on forehead, temples, upper lip and around the nose, then beads in it that grow, then some that run. Beads
 * lie in cells of a lattice on the unrolled head, whole numbers of which say by a hash which has one, where and how large.
 */
const SWEAT = `
uniform float sweat;

vec3 hashed(highp ivec2 cell) { // M. Jarzynski and M. Olano, "Hash Functions for GPU Rendering", 2020: pcg3d
  highp uvec3 v = uvec3(uint(cell.x), uint(cell.y), 7u) * 1664525u + 1013904223u;
  v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
  return vec3(v >> 8u) / 16777216.0;
}

/** Where one sweats; \`place\`: as on the left half of the face. */
float sweatiness(vec2 place) {
  return min(1.0, bell(place, vec2(0.0, 0.050), vec2(0.052, 0.026)) + bell(place, vec2(0.066, 0.030), vec2(0.014, 0.026))
    + bell(place, vec2(0.0, -0.051), vec2(0.021, 0.0055)) + 0.45 * bell(place, vec2(0.031, -0.023), vec2(0.017, 0.011))
    + 0.5 * bell(place, vec2(0.0, -0.026), vec2(0.011, 0.016)) + 0.4 * bell(place, vec2(0.0, -0.086), vec2(0.015, 0.006)));
}

/** The bead of a cell \`wide\` metres wide where there is one, of a lattice turned so that no rows show; \`amount\`: 1 where most cells have one. */
Water beadAt(vec2 flat_, float wide, mat2 turn, float amount) {
  vec2 at = turn * flat_ / wide;
  vec3 chance = hashed(ivec2(floor(at)));
  float size = fract(chance.z * 37.0);
  float radius = (0.11 + 0.22 * size * size) * smoothstep(chance.z, chance.z + 0.15, 0.9 * amount);
  if (radius < 0.02) return Water(0.0, vec2(0.0), 0.0);
  vec2 off = ((fract(at) - mix(vec2(radius), vec2(1.0 - radius), chance.xy)) * turn) / radius; // upright again
  off.y *= off.y < 0.0 ? 0.82 : 1.12; // it hangs
  float lies = 1.0 - smoothstep(0.5, 1.0, dot(off, off));
  return Water(lies, 1.5 * off * lies, 0.0);
}

/** The bead that runs down a column, and the film that it leaves; one after the other, each somewhere else. */
Water runAt(vec2 flat_, float amount) {
  const float WIDE = 0.012, APART = 0.11;
  float column = floor(flat_.x / WIDE);
  float down = 0.075 - flat_.y;
  float along = (down - drops) / APART + 0.618 * column;
  vec3 chance = hashed(ivec2(int(column), int(floor(along))));
  if (chance.z >= amount) return Water(0.0, vec2(0.0), 0.0);
  float aside = flat_.x - (column + 0.3 + 0.4 * chance.x) * WIDE - 0.0012 * sin(down * 160.0 + 40.0 * chance.y);
  float ahead = (fract(along) - 0.5) * APART; // below 0 it has been there
  vec2 off = vec2(aside, ahead) / vec2(0.0015, 0.0021);
  float drop = exp(-dot(off, off));
  float across = aside / 0.0009;
  float film = 0.5 * exp(-across * across) * smoothstep(-0.035, 0.0, ahead) * step(ahead, 0.0);
  return Water(max(film, drop), vec2(0.35 * across * film + 1.1 * off.x * drop, 1.1 * -off.y * drop), 0.0);
}

Water sweatAt(vec2 place, float bare) {
  if (sweat == 0.0) return Water(0.0, vec2(0.0), 0.0);
  float where = bare * sweatiness(place);
  vec2 flat_ = vec2(0.115 * atan(vFrontal.x, vFrontal.z - 0.03), vFrontal.y);
  vec2 footprint = fwidth(flat_);
  float fine = 1.0 - smoothstep(0.0007, 0.0018, max(footprint.x, footprint.y)); // beads below a pixel are a film
  float amount = where * smoothstep(0.2, 0.9, sweat);
  Water bead = beadAt(flat_, 0.0080, mat2(0.877, 0.479, -0.479, 0.877), 1.6 * amount * amount); // where one sweats most
  Water small = beadAt(flat_, 0.0034, mat2(0.454, 0.891, -0.891, 0.454), 0.8 * amount);
  float aside = bare * min(1.0, where + bell(place, vec2(0.066, -0.012), vec2(0.014, 0.050)));
  Water run = runAt(flat_, 0.7 * aside * smoothstep(0.55, 1.0, sweat));
  float whole = smoothstep(0.02, 0.15, where);
  Water most = bead;
  if (small.lies > most.lies) most = small;
  most.lies *= whole;
  most.slope *= whole;
  if (run.lies > most.lies) most = run;
  return Water(fine * most.lies, fine * most.slope, where * smoothstep(0.0, 0.5, sweat));
}
`;

export const WATER = `${DROPS}${TEARS}${SWEAT}
/** What lies on the skin here; \`bare\`: how much of it there is, without hair. */
Water waterAt(float bare) {
  float side = vFrontal.x < 0.0 ? -1.0 : 1.0;
  vec2 place = vec2(side * vFrontal.x, vFrontal.y);
  Water tear = tearAt(place, side), bead = sweatAt(place, bare);
  if (bead.lies < tear.lies) bead = Water(tear.lies, tear.slope, bead.film);
  return bead;
}
`;
