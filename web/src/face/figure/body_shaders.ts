/** Shaders of the body below the head: bare hands, shoes, and a plain suit that ends as a roll around the neck. */

import { FRAGMENT_HEAD, VERTEX_HEAD } from "../light/shader_prelude";
import { POSED_SURFACE } from "../skin/skin_shaders";

/** How far cloth lies on the skin, metres. */
const THICK = "0.003";
/** How much farther shoes stand off, metres. */
const LEATHER = "0.003";

/** Where the roll around the neck ends, metres above the head's rim; it is round within the last of them. */
export const ROLL = 0.016;
const ROUND = "0.006";

export const BODY_VERTEX = `${VERTEX_HEAD}
in vec3 parts; // hand and shoe, 0..1, and metres above the head's rim
${POSED_SURFACE}
out vec3 vPoint;
out vec3 vNormal;
out vec3 vParts;

void main() {
  vec3 normal;
  vec3 point = surface(normal);
  float rolled = clamp((parts.z - ${ROLL.toFixed(4)} + ${ROUND}) / ${ROUND}, 0.0, 1.0);
  float cloth = (${THICK} + ${LEATHER} * smoothstep(0.3, 0.7, parts.y)) * (1.0 - smoothstep(0.3, 0.55, parts.x)) * (1.0 - 0.75 * rolled * rolled);
  vPoint = point + cloth * normal;
  vNormal = normalize(normal + 0.7 * rolled * vec3(0.0, 1.0, 0.0));
  vParts = parts;
  gl_Position = project(vPoint);
}
`;

export const BODY_FRAGMENT = `${FRAGMENT_HEAD}
uniform vec3 skin;
in vec3 vPoint;
in vec3 vNormal;
in vec3 vParts;

/** 1 where a part lies, 0 beside it, by its edge at a half; as wide as a pixel. */
float within(float part) {
  float wide = max(fwidth(part), 0.02);
  return smoothstep(0.5 - wide, 0.5 + wide, part);
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
  if (cover <= 0.0) discard;
  vec3 view = normalize(viewPoint - vPoint);
  vec3 normal = normalize(vNormal);
  float sunlit = shadow(vPoint, normal);
  float bare = within(vParts.x);
  float shoe = within(vParts.y);
  vec3 cloth = mix(vec3(0.016, 0.016, 0.019), vec3(0.008, 0.008, 0.009), shoe);
  vec3 light = bare > 0.0 ? skinLight(skin, normal, view, sunlit) : vec3(0.0);
  if (bare < 1.0) light = mix(clothLight(cloth, normal, view, sunlit, shoe), light, bare);
  colour = vec4(display(light), cover);
}
`;
