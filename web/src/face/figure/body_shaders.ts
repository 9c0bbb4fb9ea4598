/** Shaders of the body below the head: bare skin, shoes, and the garment, which ends as a roll around the neck. */

import { FRAGMENT_HEAD, VERTEX_HEAD } from "../light/shader_prelude";
import { POSED_SURFACE } from "../skin/skin_shaders";

/** How far shoes stand off what is under them, metres. */
const LEATHER = "0.003";

/** Where the roll around the neck ends, metres above the head's rim; it is round within the last of them. */
export const ROLL = 0.016;
const ROUND = "0.006";

/** The joints along which patterns run, of one side. */
export const LIMBS = ["upperarm01", "lowerarm01", "wrist", "upperleg01", "lowerleg01", "foot"] as const;

/** Pinstripes and checks around trunk, arms and legs: even numbers, so that no pattern has a seam. */
const AROUND = { trunk: "44.0", arm: "16.0", leg: "22.0" };
/** How far a pattern's lines lie apart along a limb, metres. */
const APART = "0.024";

export const BODY_VERTEX = `${VERTEX_HEAD}
in vec4 parts; // hand and shoe, 0..1, metres above the head's rim, and arm (1) or leg (-1)
in vec3 place; // on the generic figure, metres
uniform sampler2D worn; // cover, thick, trim, hidden; metres
${POSED_SURFACE}
out vec3 vPoint;
out vec3 vNormal;
out vec4 vParts;
out vec4 vWorn;
out vec3 vPlace;

vec4 wornAt(float row) { return texelFetch(worn, texelOf(int(row + 0.5)), 0); }

void main() {
#ifdef CURVED
  vWorn = shares.x * wornAt(rows.x) + shares.y * wornAt(rows.y) + shares.z * wornAt(rows.z);
#else
  vWorn = wornAt(source);
#endif
  vPlace = place;
  vec3 normal;
  vec3 point = surface(normal);
  float rolled = clamp((parts.z - ${ROLL.toFixed(4)} + ${ROUND}) / ${ROUND}, 0.0, 1.0);
  float cloth = (vWorn.y + ${LEATHER} * smoothstep(0.3, 0.7, parts.y)) * (1.0 - 0.75 * rolled * rolled);
  vPoint = point + cloth * normal;
  vNormal = normalize(normal + 0.7 * rolled * vec3(0.0, 1.0, 0.0));
  vParts = parts;
  gl_Position = project(vPoint);
#ifdef SKIRT
  if (vWorn.x < -0.4) gl_Position = vec4(0.0, 0.0, 0.0, 1.0); // far below the hem, or no skirt: no pixel to ask
#endif
}
`;

export const BODY_FRAGMENT = `${FRAGMENT_HEAD}
uniform vec3 skin, cloth, trim;
uniform float pinstripes, checks, dots;
uniform vec3 limbs[${LIMBS.length}];
in vec3 vPoint;
in vec3 vNormal;
in vec4 vParts;
in vec4 vWorn;
in vec3 vPlace;

/** 1 where a part lies, 0 beside it, by its edge at a half; as wide as a pixel. */
float within(float part) {
  float wide = max(fwidth(part), 0.02);
  return smoothstep(0.5 - wide, 0.5 + wide, part);
}

/** 1 inside an edge that lies at 0, as wide as a pixel; metres. */
float inside(float metres) {
  float wide = max(fwidth(metres), 0.0004);
  return smoothstep(-wide, wide, metres);
}

/** Turns around the axis from one joint to another, and metres along it. */
vec2 along(vec3 from, vec3 to) {
  vec3 axis = normalize(to - from);
  vec3 off = vec3(abs(vPlace.x), vPlace.yz) - from;
  vec3 side = normalize(cross(axis, vec3(0.0, 0.0, 1.0)));
  return vec2(atan(dot(off, side), dot(off, cross(side, axis))) / 6.28318531, dot(off, axis));
}

/** Lines of a pattern where a number is whole, \`thin\` of the way to the next on both sides; as soft as a pixel is wide. */
float line(float number, float thin, float soft) {
  float off = abs(fract(number + 0.5) - 0.5);
  return 1.0 - smoothstep(thin - soft, thin + soft, off);
}

/** How much of the second colour the patterns lay on the first. */
float pattern() {
  if (pinstripes + checks + dots <= 0.0) return 0.0;
  vec3 mirrored = vec3(abs(vPlace.x), vPlace.yz);
  vec2 at = vec2(atan(vPlace.x, vPlace.z - limbs[3].z) / 6.28318531, -vPlace.y);
  float around = ${AROUND.trunk};
  if (vParts.w > 0.5) {
    at = dot(mirrored - limbs[1], limbs[2] - limbs[0]) > 0.0 ? along(limbs[1], limbs[2]) : along(limbs[0], limbs[1]);
    around = ${AROUND.arm};
  } else if (vParts.w < -0.5) {
    at = mirrored.y < limbs[4].y ? along(limbs[4], limbs[5]) : along(limbs[3], limbs[4]);
    around = ${AROUND.leg};
  }
  vec2 cell = vec2(at.x * around, at.y / ${APART});
  float across = length(vec2(length(dFdx(vPlace)), length(dFdy(vPlace)))) / ${APART}; // of an angle it would jump at the seam
  float soft = clamp(across, 0.01, 0.5);
  float striped = line(cell.x, 0.08, soft);
  float checked = 0.5 * line(cell.x * 0.5, 0.25, 0.5 * soft) + 0.5 * line(cell.y * 0.5, 0.25, 0.5 * soft);
  vec2 spot = vec2(cell.x + 0.5 * mod(floor(cell.y), 2.0), cell.y);
  float dotted = 1.0 - smoothstep(0.27 - soft, 0.27 + soft, length(fract(spot) - 0.5));
  return clamp(pinstripes * striped + checks * checked + dots * dotted, 0.0, 1.0);
}

vec3 skinLight(vec3 albedo, vec3 normal, vec3 view, float sunlit) {
  vec3 wrap = vec3(0.22, 0.16, 0.13);
  vec3 key = clamp((dot(normal, KEY) + wrap) / (1.0 + wrap), 0.0, 1.0);
  key *= sunlit * mix(vec3(1.0, 0.95, 0.92), vec3(1.0), key); // the terminator is warm
  float fill = clamp(dot(normal, FILL) * 0.6 + 0.4, 0.0, 1.0);
  vec3 seen = albedo * (KEY_LIGHT * key + FILL_LIGHT * fill + ambient(normal));
  return seen + 0.03 * KEY_LIGHT * sunlit * shine(normal, view, KEY, 22.0);
}

vec3 clothLight(vec3 albedo, vec3 normal, vec3 view, float sunlit, float polished) {
  float lit = max(dot(normal, KEY), 0.0) * sunlit;
  float fill = clamp(dot(normal, FILL) * 0.6 + 0.4, 0.0, 1.0);
  vec3 seen = albedo * (KEY_LIGHT * lit + FILL_LIGHT * fill + ambient(normal));
  float edge = 1.0 - max(dot(normal, view), 0.0);
  float nap = edge * edge; // fibres that stand off the cloth catch light at its edge
  seen += 0.5 * albedo * nap * (KEY_LIGHT * lit + FILL_LIGHT * fill) * (1.0 - polished);
  seen += RIM_LIGHT * nap * edge * 0.05 * (max(dot(normal, RIM_LEFT), 0.0) + max(dot(normal, RIM_RIGHT), 0.0));
  return seen + polished * 0.03 * KEY_LIGHT * sunlit * shine(normal, view, KEY, 60.0);
}

void main() {
#ifdef SOFT
  float cover = clamp((${ROLL.toFixed(4)} - vParts.z) / max(fwidth(vParts.z), 1e-5) + 0.5, 0.0, 1.0);
#else
  float cover = step(vParts.z, ${ROLL.toFixed(4)});
#endif
  if (cover <= 0.0 || vWorn.w > 0.0) discard;
#ifdef SKIRT
  if (vWorn.x < 0.0) discard;
#endif
  vec3 view = normalize(viewPoint - vPoint);
  vec3 normal = normalize(vNormal);
#ifdef SKIRT
  if (!gl_FrontFacing) normal = -normal;
  float shoe = 0.0, bare = 0.0;
#else
  float shoe = within(vParts.y);
  float bare = (1.0 - inside(vWorn.x)) * (1.0 - shoe);
#endif
  float sunlit = shadow(vPoint, normal);
  vec3 woven = mix(mix(cloth, trim, pattern()), trim, inside(vWorn.z));
  vec3 dyed = mix(woven, vec3(0.008, 0.008, 0.009), shoe);
#ifdef SKIRT
  if (!gl_FrontFacing) dyed *= 0.35; // little light comes in
#endif
  vec3 light = bare > 0.0 ? skinLight(skin, normal, view, sunlit) : vec3(0.0);
  if (bare < 1.0) light = mix(clothLight(dyed, normal, view, sunlit, shoe), light, bare);
  colour = vec4(display(light), cover);
}
`;
