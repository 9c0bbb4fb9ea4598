/** Shaders of the eyeball: cornea, iris, wetness, the shadow of the lids. */

import { FRAGMENT_HEAD, VERTEX_HEAD } from "../light/shader_prelude";
import { OPENING } from "./opening_shaders";

/** How far the middle of the cornea stands out of the ball where no lid covers it, in the ball's radii. */
export const BULGE = 0.025;
/** How far the ball draws back behind the lids, so that it never comes through them, in its radii. */
export const RETREAT = 0.07;

/**
 * An eyeball: a fine dome carried by the axes of the blended ball. It knows for every place how far the lids' edges
 * are (in radii, after they are blended), draws back behind them, and swells into the cornea between them.
 */
export const EYE_VERTEX = `${VERTEX_HEAD}${OPENING}
uniform int frameRows[6];
uniform mat3 fromPairs;
uniform float irisSize;
in vec3 direction;
out vec3 vLocal; // on the unit ball, +z the line of sight
out vec3 vPoint;
out vec3 vLids; // under the upper lid's edge, over the lower one's, from the inner (-1) to the outer (1) corner

void main() {
  vec3 rows[6];
  for (int n = 0; n < 6; n++) rows[n] = rowAt(frameRows[n]);
  vec3 centre = (rows[0] + rows[1] + rows[2] + rows[3] + rows[4] + rows[5]) / 6.0;
  mat3 axes = 0.5 * mat3(rows[0] - rows[1], rows[2] - rows[3], rows[4] - rows[5]) * fromPairs;
  float radius = length(axes[2]);
  vec3 at = centre + axes * direction;

  Gap gap = gapAt(at.x);
  vec2 inside = insideOf(gap, at.xy) / radius;
  float across = (at.x - gap.right.x) / max(gap.left.x - gap.right.x, 1e-4) * 2.0 - 1.0;
  vLids = vec3(inside, clamp(across, -1.5, 1.5) * sign(centre.x));

  float covered = max(smoothstep(0.03, -0.16, min(inside.x, inside.y)), smoothstep(0.12, 0.03, inside.x + inside.y));
  float cap = clamp(1.0 - dot(direction.xy, direction.xy) / min(0.21 * irisSize * irisSize, 0.30), 0.0, 1.0);
  float swell = ${BULGE.toFixed(3)} * cap * step(0.0, direction.z) * (1.0 - covered);
  at = centre + axes * direction * (1.0 + swell - ${RETREAT.toFixed(3)} * covered);
  vLocal = direction;
  vPoint = turned(at, 1.0);
  gl_Position = project(vPoint);
}
`;

/** The iris behind the cornea: where the bent ray meets it, and what it meets there. */
const IRIS = `
uniform vec3 iris;
uniform float irisSize; // radius over that of a person's iris
uniform float slit;
uniform float pupil; // what the expressions add: 1 as wide as it goes, -1 as narrow
uniform sampler2D grain;

const float LIMBUS = 0.42; // radius of a person's iris, in the ball's
const float WATER = 1.0 / 1.336;
const float PUPIL = 0.32; // radius in the light of a stage, in the iris's (4 of 12 mm)

/** 1 at the pupil's edge, less inside: a circle, an upright lens, or what lies between. */
float pupilAt(vec2 place, float size) {
  float wide = max(size - PUPIL, 0.0);
  float across = mix(size, 0.07 + 0.22 * size + 1.5 * wide, slit);
  float along = mix(size, max(0.86, size), slit);
  vec2 share = place / vec2(across, along);
  return mix(length(share), abs(share.x) + share.y * share.y, slit);
}

/** Noise along the fibres: \`turn\` once around is a whole number of tiles, so that there is no seam. */
vec4 fibre(float turn, float out_, float tiles, float length_, float level) {
  return textureLod(grain, vec2(turn * tiles, out_ * length_), level) - 0.5;
}

/**
 * Colour of the iris at a place (1: its edge), and in w what the pupil leaves of it. Between lids that are nearly shut
 * (slim) it is smaller: else it is a black bar from lid to lid, and an eye that laughs looks at nobody.
 */
vec4 irisAt(vec2 place, float blur, float slim) {
  float size = clamp(PUPIL + (pupil > 0.0 ? 0.31 : 0.15) * pupil, 0.15, 0.68) * (1.0 - 0.3 * slim * (1.0 - slit));
  float out_ = length(place);
  float hole = pupilAt(place, size);
  float soft = max(0.06, blur / size);
  float open = smoothstep(1.0 - soft, 1.0 + soft, hole);
  float rim = out_ / max(hole, 0.05); // the pupil's edge in this direction
  float share = clamp((out_ - rim) / max(1.0 - rim, 0.05), 0.0, 1.0); // fibres are drawn together by a wide pupil
  float turn = atan(place.y, place.x) * 0.1591549;
  float level = log2(max(256.0 * blur / max(6.2832 * out_, 0.5), 1e-3));
  float fine = fibre(turn, share, 3.0, 0.06, level + 1.6).r;
  float coarse = fibre(turn, share, 1.0, 0.05, level).b;
  float ridge = 0.30 + 0.10 * coarse; // the collarette
  float inner = 1.0 - smoothstep(ridge - 0.05, ridge + 0.06, share);
  vec3 tone = iris * mix(0.80, 1.25, smoothstep(0.95, 0.2, share)) + vec3(0.012, 0.009, 0.006);
  tone = mix(tone, tone * vec3(1.30, 1.02, 0.66) + vec3(0.02, 0.010, 0.0), 0.7 * inner); // warmer around the pupil
  tone *= 1.0 + 1.5 * fine + 0.9 * coarse;
#ifdef DETAIL
  float strand = fibre(turn, share + 0.13 * coarse, 7.0, 0.10, level + 2.8).a;
  tone *= 1.0 + 1.1 * strand;
  float crypt = fibre(turn, share, 1.0, 0.16, level + 1.0).g;
  tone *= 1.0 - 0.55 * smoothstep(0.10, 0.30, crypt) * smoothstep(ridge, ridge + 0.10, share) * smoothstep(0.9, 0.6, share);
  tone += iris * 0.9 * exp(-pow((share - ridge) / 0.05, 2.0)) * (0.5 + coarse); // the collarette's frill
#endif
  tone *= 1.0 - 0.45 * smoothstep(0.10, 0.0, share); // the ruff at the pupil's edge
  tone *= 1.0 - 0.86 * smoothstep(0.66, 1.0, out_) * smoothstep(0.66, 1.0, out_); // the ring at the edge
  return vec4(max(tone, 0.0), open);
}
`;

/** What the wet surface mirrors: lamps as soft boxes, the rest of the stage dimly. */
const MIRROR = `
float softbox(vec3 mirrored, vec3 lamp, vec2 size, float soft) {
  vec3 right = normalize(vec3(lamp.z, 0.0, -lamp.x) + vec3(1e-4, 0.0, 0.0));
  vec3 up = cross(lamp, right);
  float ahead = dot(mirrored, lamp);
  vec2 off = abs(vec2(dot(mirrored, right), dot(mirrored, up))) / max(ahead, 0.1);
  vec2 within = 1.0 - smoothstep(size - soft, size + soft, off);
  return ahead > 0.1 ? within.x * within.y : 0.0;
}
`;

export const EYE_FRAGMENT = `${FRAGMENT_HEAD}${IRIS}${MIRROR}
uniform mat3 eyeTurn; // eye to world
uniform mat3 headTurn;
uniform float age;
uniform float fur;
uniform vec4 blood; // in w around the eyes
uniform float tears;
in vec3 vLocal;
in vec3 vPoint;
in vec3 vLids;

/** The white: less white towards the corners, where vessels shine through, and flesh in the inner one. */
vec3 whiteAt(vec3 local, float corner, out float flesh) {
  vec3 white = vec3(0.80, 0.745, 0.69);
  white *= mix(vec3(1.0), vec3(0.94, 0.86, 0.72), age) * mix(vec3(1.0), vec3(0.62, 0.50, 0.38), fur); // old eyes yellow, animals' are dark
  float far = smoothstep(0.35, 1.05, abs(corner));
  white = mix(white, vec3(0.72, 0.50, 0.44), 0.5 * far);
  float red = clamp(blood.w, 0.0, 1.0);
  white *= 1.0 - red * (0.35 + 0.65 * far) * vec3(0.02, 0.18, 0.20);
  white *= 1.0 - vec3(0.02, 0.10, 0.11) * smoothstep(0.45, 0.95, length(local.xy));
#ifdef DETAIL
  float off = length(local.xy);
  float turn = atan(local.y, local.x) * 0.1591549;
  float bow = textureLod(grain, vec2(turn * 2.0, off * 0.10), 1.0).b - 0.5;
  float vein = abs(textureLod(grain, vec2(turn + 0.020 * bow, off * 0.045), 1.0).b - 0.5);
  float twig = abs(textureLod(grain, vec2(turn * 2.0 - 0.035 * bow, off * 0.11), 1.0).b - 0.5);
  float vessels = 0.9 * (1.0 - smoothstep(0.0, 0.07, vein)) + 0.5 * (1.0 - smoothstep(0.0, 0.08, twig));
  white = mix(white, vec3(0.58, 0.17, 0.14), min(vessels, 1.0) * (0.08 + 0.16 * far + 0.22 * age + 0.28 * red) * smoothstep(0.46, 0.85, off));
#endif
  white *= 1.0 - 0.35 * fur;
  flesh = smoothstep(-0.86, -0.97, corner);
  return mix(white, vec3(0.55, 0.20, 0.17), flesh);
}

#ifndef FAST
/**
 * The key light's image on the cornea: a soft window. \`half_\`: between key and eye, of the ball. It stands on the iris even
 * where it would lie over the white, and at the lid's edge where that would cover it: no eye is without one.
 */
float catchlight(vec3 local, vec3 half_, float edge, float slim, float blur) {
  vec2 at = half_.xy * edge / 0.66;
  at *= min(1.0, 0.52 * edge * inversesqrt(max(dot(at, at), 1e-6)));
  at.y = clamp(at.y, local.y - 0.6 * vLids.y + 0.4 * vLids.x, local.y + 0.6 * vLids.x - 0.4 * vLids.y);
  vec2 size = vec2(0.125, 0.155) * (1.0 - 0.35 * slim) / max(irisSize, 1.0); // in radii of the iris
  vec2 off = max(abs(local.xy - at) / edge - 0.3 * size, 0.0) / (0.7 * size);
  float soft = 0.45 + blur / size.x;
  return (1.0 - smoothstep(1.0 - soft, 1.0 + soft, length(off))) * smoothstep(0.0, 0.3, half_.z) * step(0.0, local.z);
}
#endif

void main() {
  vec3 local = normalize(vLocal);
  vec3 view = normalize(viewPoint - vPoint);
  vec3 seen = view * eyeTurn; // transposed: world to eye
  vec3 key = KEY * eyeTurn;
  float edge = LIMBUS * irisSize;
  float off = length(local.xy);
  float cap = local.z > 0.0 ? 1.0 - smoothstep(0.94 * edge, 1.14 * edge, off) : 0.0;

  // The cornea is curved half as much again as the ball.
  vec2 slope = local.xy * mix(1.0, 0.66 / edge, cap);
  vec3 bent = normalize(vec3(slope, sqrt(max(1.0 - dot(slope, slope), 0.04)) * sign(local.z)));
  vec3 surface = eyeTurn * local;
  vec3 wet = eyeTurn * bent;

  // Through it onto the iris, a plane behind its edge.
  vec3 ray = refract(-seen, bent, WATER);
  float floor_ = sqrt(max(1.0 - edge * edge, 0.0)) - 0.05;
  vec2 place = (local.xy + ray.xy * max(local.z - floor_, 0.0) / max(-ray.z, 0.25)) / edge;
#ifdef FAST
  float blur = 0.04;
#else
  float blur = length(fwidth(local.xy)) / edge;
#endif

  // How far the light is kept off: by the lids' edges above all, the upper one with its lashes.
  float gap = vLids.x + vLids.y;
#ifdef DETAIL
  float slim = 1.0 - smoothstep(0.20, 0.75, gap * inversesqrt(max(1.0 - vLids.z * vLids.z, 0.1))); // lids near each other are thin: light comes in between them and through them
#else
  const float slim = 0.0;
#endif
  vec4 inner = irisAt(place, blur, slim);
  float roof = (0.06 + 0.14 * clamp((KEY * headTurn).y, 0.0, 1.0)) * (1.0 - 0.7 * slim);
  float keyOpen = smoothstep(roof - 0.13, roof + 0.10, vLids.x) * smoothstep(-0.03, 0.05, vLids.y);
  float skyOpen = smoothstep(-0.10, 0.42, vLids.x) * mix(0.55, 1.0, smoothstep(-0.04, 0.20, vLids.y));
#ifdef DETAIL
  skyOpen = mix(skyOpen, max(skyOpen, 0.6), slim);
#endif
  skyOpen *= mix(0.55, 1.0, smoothstep(1.05, 0.65, abs(vLids.z)));
  keyOpen = shaded(keyOpen) * shadow(vPoint, surface);
  skyOpen = shaded(skyOpen);

  float flesh;
  vec3 white = whiteAt(local, vLids.z, flesh);
  float toKey = dot(surface, KEY);
  vec3 wrap = vec3(0.42, 0.28, 0.24);
  vec3 fallen = clamp((toKey + wrap) / (1.0 + wrap), 0.0, 1.0);
  vec3 around = FILL_LIGHT * clamp(dot(surface, FILL) * 0.55 + 0.45, 0.0, 1.0) + ambient(surface);
  vec3 light = white * (KEY_LIGHT * fallen * keyOpen * 0.62 + around * skyOpen);

  // The iris: lit through the cornea, which gathers the light on the far side.
  float direct = clamp(0.55 * key.z + 0.25 - 0.35 * dot(place, key.xy), 0.0, 1.5);
  float gathered = pow(max(-dot(place, normalize(key.xy + vec2(1e-4, 0.0))), 0.0), 2.0) * smoothstep(1.05, 0.75, length(place));
  vec3 behind = inner.rgb * (KEY_LIGHT * (direct * 0.85 + gathered * 1.9 * max(key.z, 0.0)) * keyOpen + around * 1.15 * skyOpen);
  behind *= inner.w;
  float disc = local.z > 0.0 ? 1.0 - smoothstep(0.91 * edge, 1.07 * edge, off) : 0.0;
  light = mix(light, behind, disc);
  light *= 1.0 - 0.30 * (1.0 - smoothstep(0.0, 0.14 * edge, abs(off - 1.03 * edge))) * step(0.0, local.z);

  // The tears: a film over all, and a line that climbs the lower lid.
  vec3 up = headTurn * vec3(0.0, 1.0, 0.0);
  float climb = 1.0 - smoothstep(0.0, 0.055 + 0.05 * tears, vLids.y);
  vec3 film = normalize(wet + climb * (0.9 * up + 0.35 * view));
  vec3 mirrored = reflect(-view, film);
  float glance = 1.0 - max(dot(film, view), 0.0);
  float fresnel = 0.025 + 0.975 * glance * glance * glance * glance * glance;
  float lidded = smoothstep(-0.02, 0.10, vLids.x);
#ifdef FAST
  light += KEY_LIGHT * 2.2 * shine(film, view, KEY, 300.0) * lidded;
#else
  float soft = 0.05 + length(fwidth(mirrored));
  light += KEY_LIGHT * (2.6 * catchlight(local, normalize(KEY + view) * eyeTurn, edge, slim, blur) + 0.05 * shine(surface, view, KEY, 40.0)) * lidded;
  light += FILL_LIGHT * 0.45 * softbox(mirrored, FILL, vec2(0.09, 0.12), soft + 0.05) * lidded * mix(0.2, 1.0, cap);
  vec3 room = mix(GROUND_LIGHT, SKY_LIGHT * 1.6, smoothstep(-0.3, 0.7, mirrored.y));
  room += RIM_LIGHT * 0.5 * (pow(max(dot(mirrored, RIM_LEFT), 0.0), 8.0) + pow(max(dot(mirrored, RIM_RIGHT), 0.0), 8.0));
  light += room * min(fresnel, 0.35) * 1.6 * skyOpen * smoothstep(-0.05, 0.22, vLids.x);
  light += (KEY_LIGHT * 0.20 * keyOpen + around * 0.5) * climb * smoothstep(0.0, 0.012, vLids.y) * (0.28 + 0.5 * tears) * (1.0 - flesh);
#endif
  light *= mix(0.45, 1.0, smoothstep(-0.005, 0.022, min(vLids.x, vLids.y + 0.004))); // the crease where ball and lid meet
  light = mix(vec3(0.020, 0.008, 0.006) * KEY_LIGHT, light, smoothstep(0.03, 0.13, gap)); // lids that are shut: the dark of their lashes
  colour = premultiplied(light, 1.0);
}
`;
