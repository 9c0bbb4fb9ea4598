/** Shaders of teeth and tongue, lit through the lips. */

import { EDGE_POINTS } from "../anatomy/openings";
import { MOUTH_LIGHT_LAW } from "../light/mouth_light";
import { FRAGMENT_HEAD, VERTEX_HEAD } from "../light/shader_prelude";
import { SURFACE } from "../skin/skin_shaders";
import { OPENING } from "./opening_shaders";

/**
 * What comes in to a place in the mouth: the key light comes straight through the lips' opening, or not at all; the rest by
 * how large the opening looks from there.
 */
export const MOUTH_LIGHT = `${VERTEX_HEAD}${OPENING}${MOUTH_LIGHT_LAW}
uniform vec3 KEY;
uniform float fur;
out vec3 vPoint;
out vec3 vNormal;
out vec3 vLight; // of the key, of what comes from everywhere, and how far the lips are shut

vec3 lightAt(vec3 here) {
  float middle = 0.5 * (rowAt(upperRows[0]).x + rowAt(upperRows[${EDGE_POINTS - 1}]).x);
  float half_ = 0.5 * abs(rowAt(upperRows[${EDGE_POINTS - 1}]).x - rowAt(upperRows[0]).x);
  float front = mix(0.7, 1.0, fur); // cheeks are seen through a person's mouth from ahead, a muzzle's through its sides
  Gap ahead = gapAt(middle + front * clamp(here.x - middle, -half_, half_));
  float behind = mix(ahead.lower.z, ahead.upper.z, 0.5) - here.z;
  float deep = max(behind, 0.0);
  vec3 key = KEY * headTurn;
  vec2 to = here.xy + 0.5 * key.xy / max(key.z, 0.25) * deep; // half the slant: stages have more lamps above than one
  vec2 inside = insideOf(gapAt(to.x), to);
  float soft = 0.0012 + 0.22 * deep;
  float direct = smoothstep(-soft, soft, min(inside.x, inside.y)) * smoothstep(0.0, 0.3, key.z);
  float sky = skyThrough(vec4(ahead.upper.y - here.y, here.y - ahead.lower.y, here.x - ahead.right.x, ahead.left.x - here.x), deep);
  float parted = smoothstep(0.0, 0.004, ahead.upper.y - ahead.lower.y);
  float within = smoothstep(-0.003, 0.002, behind); // a tongue that is out is in the light
  return vec3(mix(vec2(1.0), vec2(direct, sky) * parted, within), (1.0 - parted) * within);
}
`;

/** Teeth as the cast's own strips. */
export const TEETH_VERTEX = `${MOUTH_LIGHT}
in vec4 place; // depth in the mouth, angle on the arch, height from the gum (0) to the edge (1), upper jaw (1) or not
out vec4 vPlace;

void main() {
  vec3 here = fetchRow(positions);
  vPoint = turned(here, 1.0);
  vNormal = turnedNormal(fetchRow(normals), 1.0);
  vPlace = place;
  vLight = lightAt(here);
  gl_Position = project(vPoint);
}
`;

/**
 * The tongue. The cast's goes with the chin as one piece and stays high when the jaw opens; one that does nothing of its
 * own lies down between the teeth, and its sides lower than its middle, so that it is round and not a shelf.
 */
export const TONGUE_VERTEX = `${MOUTH_LIGHT}${SURFACE}
uniform ivec4 jaw; // of the lower teeth: gum and edge in front, edges at the right and the left end
uniform ivec2 tips; // of the upper teeth's edge in front, of the tongue
uniform vec2 tipAtRest; // up and ahead of the lower edge, in widths of the arch
in vec3 spot; // behind the tip, aside of the middle, metres along the normal (spotAt in tongue.ts)
out vec2 vSpot;

/** Where the tongue lies down to in an open mouth, and how far it is out. */
vec3 sunk(out float out_) {
  vec3 edge = rowAt(jaw.y), right = rowAt(jaw.z), left = rowAt(jaw.w);
  vec3 up = normalize(edge - rowAt(jaw.x));
  vec3 ahead = normalize(edge - 0.5 * (right + left));
  float width = distance(right, left);
  vec3 tip = rowAt(tips.y) - edge;
  float own = distance(vec2(dot(tip, up), dot(tip, ahead)) / width, tipAtRest);
  float open = smoothstep(0.06, 0.6, (rowAt(tips.x).y - edge.y) / width);
  float still = 1.0 - smoothstep(0.08, 0.2, own);
  out_ = 1.0 - still;
  float aside = min(spot.y * spot.y, 1.0);
  return -(0.30 * (1.0 - 0.25 * clamp(spot.x, 0.0, 1.0)) + 0.16 * aside) * width * up * open * still;
}

void main() {
  vec3 normal;
  vec3 here = surface(normal);
  float out_ = 0.0;
  vec3 down = jaw.z == jaw.w ? vec3(0.0) : sunk(out_);
  here += spot.z * (1.0 - out_) * normal + down; // one that is out is thick, and covers the lip
  vPoint = turned(here, 1.0);
  vNormal = turnedNormal(normal, 1.0);
  vSpot = spot.xy;
  vLight = mix(lightAt(here), vec3(1.0, 1.0, 0.0), 0.8 * out_ * smoothstep(0.5, 0.1, spot.x)); // beside a tongue that is out the lip gives way
  gl_Position = project(vPoint);
  float nearer = 0.003 * out_ * smoothstep(0.8, 0.4, spot.x); // metres: no lip under it comes through it
  gl_Position.z = (gl_Position.z + projectionMatrix[2][2] * nearer) * gl_Position.w / (gl_Position.w - nearer);
}
`;

/** Light on what is wet in the mouth, for its fragments. */
export const MOUTH_HEAD = `${FRAGMENT_HEAD}${MOUTH_LIGHT_LAW}
uniform mat3 headTurn;
uniform sampler2D grain;
in vec3 vPoint;
in vec3 vNormal;
in vec3 vLight;

const vec3 FLESH = vec3(0.70, 0.54, 0.46); // of the light on the mouth's walls and teeth, what they send on
const vec3 SEAM = vec3(0.075, 0.016, 0.013);

/** How much of the key light comes to a place. */
float keyAt(vec3 normal) { return max(shaded(vLight.x), 0.0) * shadow(vPoint, normal); }

/** Light on something wet in the mouth: through the lips, so much of the key, and back from the red walls. */
vec3 lit(vec3 albedo, vec3 normal, float through, float wet, float direct) {
  vec3 view = normalize(viewPoint - vPoint);
  float around = shaded(vLight.y);
  float key = clamp((dot(normal, KEY) + through) / (1.0 + through), 0.0, 1.0);
  vec3 fallen = KEY_LIGHT * key * direct * 0.9;
  vec3 sky = (FILL_LIGHT * clamp(dot(normal, FILL) * 0.5 + 0.5, 0.0, 1.0) + ambient(normal) + KEY_LIGHT * 0.30) * around;
#ifdef DETAIL
  sky = (sky + KEY_LIGHT * vec3(0.24, 0.20, 0.165) * around) / (1.0 - FLESH * (1.0 - around)); // what the walls keep in goes to and fro, and has been on flesh
  vec3 walls = (vec3(0.06, 0.02, 0.016) * around * around + vec3(0.065, 0.031, 0.020) * (1.0 - vLight.z)) * KEY_LIGHT;
#else
  sky *= mix(vec3(1.0, 0.84, 0.66), vec3(1.0), around);
  vec3 walls = (vec3(0.20, 0.055, 0.045) * around * around + vec3(0.08, 0.026, 0.020) * (1.0 - vLight.z)) * KEY_LIGHT;
#endif
  vec3 shut = SEAM * (KEY_LIGHT + FILL_LIGHT) * vLight.z; // between closed lips: their own wet dark red, not a black slit
  vec3 light = albedo * (fallen + sky + walls);
  float gleam = shine(normal, view, KEY, 60.0) + 0.35 * shine(normal, view, KEY, 14.0);
  light += wet * (KEY_LIGHT * gleam * direct + FILL_LIGHT * shine(normal, view, FILL, 30.0) * around);
  float grazing = 1.0 - max(dot(normal, view), 0.0);
  light += wet * (0.10 + 0.9 * grazing * grazing * grazing) * (ambient(reflect(-view, normal)) + 0.25 * KEY_LIGHT) * around; // saliva mirrors all that is before it
#ifdef DETAIL
  light = mix(MOUTH_DARK * KEY_LIGHT, light, outOfDark(around));
#endif
  return mix(light, shut, vLight.z);
}

/** What a film of saliva mirrors of the lamps, as soft boxes, and of what stands before the mouth. */
vec3 wetness(vec3 film, float wet, float direct) {
  vec3 view = normalize(viewPoint - vPoint);
  float around = shaded(vLight.y);
  float key = 1.1 * smoothstep(0.974, 0.993, dot(film, normalize(KEY + view))) + 0.22 * shine(film, view, KEY, 40.0);
  float fill = 0.7 * smoothstep(0.982, 0.996, dot(film, normalize(FILL + view)));
  return wet * (1.0 - vLight.z) * outOfDark(around) * (KEY_LIGHT * key * max(sqrt(direct), 0.35 * around) + FILL_LIGHT * fill * around);
}

vec3 facing() { return normalize(gl_FrontFacing ? vNormal : -vNormal); }
`;

/** The tongue: a furrow along its middle, papillae, wet. */
export const TONGUE_FRAGMENT = `${MOUTH_HEAD}
in vec2 vSpot;
void main() {
  vec3 normal = facing();
  float furrow = exp(-pow(vSpot.y / 0.10, 2.0));
  vec2 at = vec2(vSpot.y * 0.55, vSpot.x * 1.1);
#ifdef DETAIL
  vec4 bumps = texture(grain, at * 1.9) - 0.5;
  vec4 patch_ = texture(grain, at * 0.6) - 0.5;
#else
  vec4 bumps = texture(grain, at) - 0.5;
  vec4 patch_ = vec4(0.0);
#endif
  vec3 side = headTurn * vec3(1.0, 0.0, 0.0);
  vec3 back = headTurn * vec3(0.0, 0.0, 1.0);
#ifdef DETAIL
  normal = normalize(normal + 0.9 * vSpot.y * side);
#endif
  normal = normalize(normal + side * (0.5 * furrow * sign(-vSpot.y) * smoothstep(0.0, 0.06, abs(vSpot.y)) + 0.30 * bumps.r) + back * 0.30 * bumps.g);
  vec3 flesh = mix(vec3(0.54, 0.17, 0.155), vec3(0.62, 0.28, 0.255), clamp(0.35 + bumps.b + 0.6 * patch_.g, 0.0, 1.0));
  flesh *= (1.0 - 0.38 * furrow) * (1.0 - 0.65 * smoothstep(0.1, 1.1, vSpot.x));
#ifdef DETAIL
  flesh *= 1.0 - 0.75 * smoothstep(0.3, 0.8, abs(vSpot.y)); // beside it teeth and cheeks keep the light off
  vec3 film = normalize(normal + 0.35 * (bumps.r * side + bumps.g * back));
  float direct = keyAt(normal);
  vec3 light = lit(flesh, normal, 0.5, 0.16 * (1.0 + bumps.a), direct) + wetness(film, 0.5 + bumps.b, direct);
#else
  vec3 light = lit(flesh, normal, 0.7, 0.24 * (1.0 + bumps.a), keyAt(normal));
#endif
  colour = premultiplied(light, 1.0);
}
`;

/** The share of a row of teeth, from its gum's end to its edge, that is not drawn: 3 mm, as of the sheet (SHORT). */
const GUM_END = "0.16";

/** Teeth as strips: each with its own width, length and roundness, gum that climbs between them. */
export const TEETH_FRAGMENT = `${MOUTH_HEAD}
in vec4 vPlace;
uniform float age, fur, milk;

/** A tooth's width on the arch, radians, by its number from the middle: of a person, of a carnivore. */
float wideAt(int n, float upper) {
  float person = n == 0 ? mix(0.180, 0.268, upper) : n == 1 ? mix(0.195, 0.212, upper) : n < 5 ? 0.235 : 0.330;
  float carnivore = n < 3 ? mix(0.134, 0.162, upper) : n == 3 ? 0.228 : n == 5 ? 0.413 : 0.298;
  return mix(person, carnivore, fur);
}

/** Place across the tooth (-1..1), half its width in radians, its number from the middle. */
vec3 toothAt(float angle, float upper) {
  float from = 0.0;
  float far = abs(angle);
  for (int n = 0; n < 7; n++) {
    float wide = wideAt(n, upper);
    if (far < from + wide || n == 6) return vec3((2.0 * (far - from) / wide - 1.0) * sign(angle), 0.5 * wide, float(n));
    from += wide;
  }
  return vec3(0.0);
}

/** Where the tooth ends, from the gum's end (0) to the row's edge (1). */
float endOf(vec3 tooth, float upper) {
  float across = abs(tooth.x);
  float sides = across * across;
  // Rounded corners, the upper lateral teeth a little shorter, canines pointed.
  float person = 1.0 - 0.075 * sides * sides * sides - (tooth.z == 2.0 ? 0.07 * across : 0.0) - (tooth.z == 1.0 ? 0.05 * upper : 0.0);
  // Three small incisors, a fang, and cheek teeth that cut.
  float carnivore = tooth.z < 3.0 ? 0.70 - 0.12 * sides : tooth.z == 3.0 ? 1.0 - 0.52 * across : 0.84 - 0.28 * pow(across, 1.3);
  float baby = tooth.z < 2.0 ? 0.94 - 0.06 * sides : 0.72; // incisors alone, and gum
  return mix(mix(person, baby, milk), carnivore, fur);
}

/** The gum ends so far above the row's own end, where it comes through cheeks first. */
const float GUM_END = ${GUM_END};

void main() {
  float upper = vPlace.w;
  vec3 tooth = toothAt(vPlace.y, upper);
  float across = tooth.x;
  float sides = across * across;
  float height = vPlace.z;
  float cover = min(endOf(tooth, upper) + 0.02 - height, height - GUM_END);
#ifdef SOFT
  cover = clamp(cover / max(fwidth(cover), 1e-4) + 0.5, 0.0, 1.0);
#endif
  if (cover <= 0.0) discard;
  float gumLine = 0.36 + 0.13 * sides * sides - (tooth.z == 1.0 ? 0.0 : 0.03);
  gumLine = mix(gumLine, tooth.z < 2.0 ? 0.66 + 0.06 * sides : 1.2, milk * (1.0 - fur));
  float gum = 1.0 - smoothstep(gumLine - 0.03, gumLine + 0.03, height);
  float groove = smoothstep(0.84, 1.0, abs(across)) * (1.0 - gum);

  vec3 normal = facing();
  vec3 along = headTurn * vec3(cos(vPlace.y), 0.0, -sin(vPlace.y));
  float curl = across * 0.42 + across * sides * 0.55;
  normal = normalize(normal + along * curl * (1.0 - 0.5 * gum) + headTurn * vec3(0.0, upper * 2.0 - 1.0, 0.0) * 0.5 * (exp(-pow((height - gumLine) / 0.05, 2.0))));
  float shade = fract(sin(tooth.z * 12.9 + sign(vPlace.y) * 3.7 + upper) * 43.7) - 0.5;
  vec3 enamel = mix(vec3(0.84, 0.72, 0.53), vec3(0.93, 0.88, 0.78), smoothstep(gumLine, gumLine + 0.35, height));
  enamel = mix(enamel, vec3(0.74, 0.74, 0.73), 0.4 * smoothstep(0.88, 1.02, height + 0.05 * sides)); // the edge lets the dark through
  enamel *= mix(vec3(1.0), vec3(0.93, 0.84, 0.66), age);
  enamel *= (1.0 + 0.07 * shade) * mix(vec3(1.0), vec3(0.46, 0.34, 0.28), groove); // light between teeth went through them
  enamel *= (1.0 - 0.20 * sides) * mix(1.0, 0.62, smoothstep(1.5, 5.5, tooth.z)); // round each, and the farther back the less light
  vec3 pink = mix(vec3(0.50, 0.17, 0.16), vec3(0.60, 0.27, 0.25), smoothstep(gumLine - 0.16, gumLine, height));
  pink *= 1.0 + 0.5 * (texture(grain, vec2(vPlace.y * 1.3, height * 0.6)).b - 0.5);
  vec3 albedo = mix(enamel, pink, gum);
  albedo *= mix(0.72, 1.0, smoothstep(0.0, 0.06, abs(height - gumLine) + 0.02)); // where the gum begins
  colour = premultiplied(lit(albedo, normal, mix(0.75, 0.4, gum), mix(0.40, 0.24, gum) * (1.0 - groove), keyAt(normal)), 1.0);
#ifdef SOFT
  colour.a = cover;
#endif
}
`;
