import { ROW_SHIFT, ROW_WIDTH } from "./pass_shaders";

/** What every vertex shader of the head shares: its row's blended position and normal, turned with the head. */
const VERTEX_HEAD = `
precision highp float;
precision highp int;
precision highp sampler2D;
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
uniform sampler2D positions;
uniform sampler2D normals;
uniform mat3 headTurn;
uniform vec3 pivot;
in float source;

vec3 fetchRow(sampler2D rows) {
  int row = int(source + 0.5);
  return texelFetch(rows, ivec2(row & ${ROW_WIDTH - 1}, row >> ${ROW_SHIFT}), 0).xyz;
}
vec3 turned(vec3 point, float part) { return mix(point, pivot + headTurn * (point - pivot), part); }
vec3 turnedNormal(vec3 normal, float part) { return normalize(mix(normal, headTurn * normal, part)); }
vec4 project(vec3 point) { return projectionMatrix * viewMatrix * vec4(point, 1.0); }
`;

/** Light and tone that every fragment shader of the head shares: a warm key, a cool fill, two rims. */
const FRAGMENT_HEAD = `
precision highp float;
precision highp sampler2D;
uniform vec3 cameraPosition;
out vec4 colour;

const vec3 KEY = normalize(vec3(-0.68, 0.62, 0.66));
const vec3 FILL = normalize(vec3(0.85, 0.0, 0.5));
const vec3 RIM_LEFT = normalize(vec3(-0.9, 0.25, -0.45));
const vec3 RIM_RIGHT = normalize(vec3(0.9, 0.35, -0.5));
const vec3 KEY_LIGHT = vec3(1.72, 1.52, 1.34);
const vec3 FILL_LIGHT = vec3(0.25, 0.24, 0.27);
const vec3 RIM_LIGHT = vec3(0.62, 0.70, 0.90);

/** Linear light to the display, with a shoulder for the highlights. */
vec3 display(vec3 light) {
  vec3 x = max(light, 0.0);
  x = x * (1.0 + x * 0.12) / (1.0 + x * 0.72);
  return pow(x, vec3(1.0 / 2.2));
}
vec4 premultiplied(vec3 light, float alpha) { return vec4(display(light) * alpha, alpha); }
/** A lobe of shine. */
float shine(vec3 normal, vec3 view, vec3 light, float sharpness) {
  return pow(max(dot(normal, normalize(light + view)), 0.0), sharpness);
}
`;

export const SKIN_VERTEX = `${VERTEX_HEAD}
in vec2 uv;
in vec4 traits; // turn with the head, open sky, hair, light at the neck
out vec3 vPoint;
out vec3 vNormal;
out vec2 vUv;
out vec3 vTraits;

void main() {
  vPoint = turned(fetchRow(positions), traits.x);
  vNormal = turnedNormal(fetchRow(normals), traits.x);
  vUv = uv;
  vTraits = traits.yzw;
  gl_Position = project(vPoint);
}
`;

export const SKIN_FRAGMENT = `${FRAGMENT_HEAD}
uniform sampler2D mask;
uniform sampler2D grain;
uniform vec3 skin;
uniform vec3 lip;
uniform vec3 brow;
uniform vec3 blush;
in vec3 vPoint;
in vec3 vNormal;
in vec2 vUv;
in vec3 vTraits;

void main() {
  vec4 region = texture(mask, vUv);
  vec4 pores = texture(grain, vUv * 9.0) - 0.5;
  vec4 blotch = texture(grain, vUv * 1.7) - 0.5;
  vec3 view = normalize(cameraPosition - vPoint);
  vec3 normal = normalize(vNormal);
  float sky = vTraits.x;
  float hair = smoothstep(0.35, 0.65, vTraits.y + (pores.r + blotch.g) * 0.35);
  float lips = region.r;

  vec3 albedo = skin * (1.0 + pores.g * 0.14 + blotch.r * 0.16) * (1.0 + vec3(0.10, -0.04, -0.06) * blotch.b);
  albedo = mix(albedo, blush, region.b * 0.55);
  albedo = mix(albedo, lip, lips * 0.9);
  albedo = mix(albedo, brow, region.g * 0.92);
  albedo = mix(albedo, brow * (0.75 + 0.7 * pores.r), hair);
  albedo *= pow(region.a, 1.3); // what cavities and the lash line leave of the light

  float open = smoothstep(0.05, 1.0, sky);
  vec3 wrap = mix(vec3(0.34, 0.17, 0.12), vec3(0.05), hair);
  vec3 key = clamp((dot(normal, KEY) + wrap) / (1.0 + wrap), 0.0, 1.0);
  key *= mix(vec3(1.0, 0.90, 0.86), vec3(1.0), key); // the terminator is warm: light that went through the skin
  float fill = clamp(dot(normal, FILL) * 0.6 + 0.4, 0.0, 1.0);
  float edge = pow(1.0 - max(dot(normal, view), 0.0), 4.0);
  float rim = edge * (max(dot(normal, RIM_LEFT), 0.0) * 0.7 + max(dot(normal, RIM_RIGHT), 0.0));
  vec3 ambient = mix(vec3(0.070, 0.050, 0.046), vec3(0.105, 0.100, 0.110), normal.y * 0.5 + 0.5);
  vec3 shade = mix(vec3(open), vec3(sqrt(open), open, open), 0.6); // light that bounces in a hollow reddens
  vec3 light = albedo * (KEY_LIGHT * key * mix(vec3(1.0), shade, 0.8) + (FILL_LIGHT * fill + ambient) * shade * open);

  float oil = (0.055 + 0.11 * lips) * (1.0 - hair) * open * (1.0 + pores.a * 1.4) * (1.0 - region.g);
  light += KEY_LIGHT * oil * (shine(normal, view, KEY, 22.0) + (1.2 + 3.0 * lips) * shine(normal, view, KEY, 70.0));
  light += FILL_LIGHT * oil * shine(normal, view, FILL, 22.0);
  light += RIM_LIGHT * rim * open * open * mix(0.12 + 1.1 * albedo, vec3(0.16), hair);
  colour = premultiplied(light * vTraits.z, 1.0);
}
`;

/** Eyeballs: the true sphere under each pixel, white, iris and pupil by the angle from the line of sight. */
export const EYE_VERTEX = `${VERTEX_HEAD}
out vec3 vPoint;

void main() {
  vPoint = turned(fetchRow(positions), 1.0);
  gl_Position = project(vPoint);
}
`;

export const EYE_FRAGMENT = `${FRAGMENT_HEAD}
uniform vec3 centre; // in the world
uniform float radius;
uniform mat3 eyeTurn; // eye to world
uniform mat3 headTurn;
uniform vec3 iris;
uniform sampler2D grain;
in vec3 vPoint;

void main() {
  vec3 view = normalize(cameraPosition - vPoint);
  vec3 from = vPoint - centre;
  float b = dot(from, view);
  float inside = b * b - dot(from, from) + radius * radius;
  vec3 normal = normalize(from + view * (inside > 0.0 ? sqrt(inside) - b : 0.0));
  vec3 local = normal * eyeTurn; // transposed: world to eye
  float angle = acos(clamp(local.z, -1.0, 1.0)) / 0.43; // 1 at the iris' edge
  float spoke = texture(grain, vec2(atan(local.y, local.x) * 0.9549, angle * 0.22)).r - 0.5;
  float pupil = 1.0 - smoothstep(0.36, 0.43, angle);
  float disc = 1.0 - smoothstep(0.94, 1.04, angle);
  float limbus = smoothstep(0.72, 0.98, angle);

  vec3 white = vec3(0.80, 0.76, 0.72) - vec3(0.02, 0.16, 0.15) * smoothstep(1.1, 2.4, angle);
  vec3 fibres = iris * (0.95 + 2.0 * spoke) * (1.0 - 0.9 * limbus * limbus);
  fibres += iris * vec3(0.8, 0.65, 0.45) * smoothstep(0.72, 0.42, angle); // brighter around the pupil
  vec3 albedo = mix(white, mix(fibres, vec3(0.004), pupil), disc);

  vec3 upright = normal * headTurn; // in the head's frame
  float lidShadow = mix(0.22, 1.0, smoothstep(0.50, -0.05, upright.y)) * smoothstep(-0.15, 0.70, upright.z);
  float key = clamp(dot(normal, KEY) * 0.75 + 0.25, 0.0, 1.0);
  vec3 light = albedo * (KEY_LIGHT * key * 0.62 + FILL_LIGHT * 0.6 + 0.16) * lidShadow;
  // the light on the far side of the cornea, as a lens gathers it
  light += iris * KEY_LIGHT * disc * (1.0 - pupil) * 0.35 * max(dot(local.xy, -(KEY * eyeTurn).xy), 0.0) * lidShadow;
  vec3 bulge = normalize(normal + 0.35 * disc * (normal - (eyeTurn * vec3(0.0, 0.0, 1.0))));
  light += KEY_LIGHT * (2.6 * shine(bulge, view, KEY, 420.0) + 0.10 * shine(normal, view, KEY, 60.0));
  light += FILL_LIGHT * 1.2 * shine(bulge, view, FILL, 500.0);
  colour = premultiplied(light, 1.0);
}
`;

/** The tongue: darker the deeper it lies in the mouth. */
export const MOUTH_VERTEX = `${VERTEX_HEAD}
in vec3 place; // depth in the mouth, angle on the arch, height from the gum (0) to the edge (1)
out vec3 vPoint;
out vec3 vNormal;
out vec3 vPlace;

void main() {
  vPoint = turned(fetchRow(positions), 1.0);
  vNormal = turnedNormal(fetchRow(normals), 1.0);
  vPlace = place;
  gl_Position = project(vPoint);
}
`;

const MOUTH_HEAD = `${FRAGMENT_HEAD}
in vec3 vPoint;
in vec3 vNormal;
in vec3 vPlace;

vec3 lit(vec3 albedo, float wet) {
  vec3 view = normalize(cameraPosition - vPoint);
  vec3 normal = normalize(gl_FrontFacing ? vNormal : -vNormal);
  float open = pow(clamp(1.0 - vPlace.x, 0.0, 1.0), 2.0);
  float key = clamp((dot(normal, KEY) + 0.7) / 1.7, 0.0, 1.0);
  vec3 light = albedo * (KEY_LIGHT * key * 0.85 + FILL_LIGHT * 0.5 + vec3(0.10, 0.07, 0.06)) * open;
  return light + KEY_LIGHT * wet * shine(normal, view, KEY, 50.0) * open;
}
`;

export const TONGUE_FRAGMENT = `${MOUTH_HEAD}
void main() {
  float furrow = 1.0 - 0.35 * exp(-pow(vPlace.y / 0.09, 2.0));
  colour = premultiplied(lit(vec3(0.36, 0.085, 0.08) * furrow * (1.0 - 0.6 * vPlace.x), 0.10), 1.0);
}
`;

/** Teeth: grooves between them by the angle on the arch, gum above. */
export const TEETH_FRAGMENT = `${MOUTH_HEAD}
void main() {
  float tooth = fract(vPlace.y / 0.235) * 2.0 - 1.0;
  float groove = smoothstep(0.72, 1.0, abs(tooth));
  float gum = smoothstep(0.06, -0.06, vPlace.z - 0.40 - 0.10 * tooth * tooth);
  vec3 enamel = vec3(1.05, 0.97, 0.84) * (1.0 - 0.55 * groove) * mix(0.85, 1.0, vPlace.z);
  colour = premultiplied(lit(mix(enamel, vec3(0.42, 0.13, 0.12), gum), 0.20), 1.0);
}
`;

/** Lashes: dark strands that thin out towards their tips. */
export const LASH_VERTEX = `${VERTEX_HEAD}
in vec3 strand; // along the lid, from root (0) to tip (1), upper (1) or lower (0) lid
out vec3 vStrand;

void main() {
  vStrand = strand;
  gl_Position = project(turned(fetchRow(positions), 1.0));
}
`;

export const LASH_FRAGMENT = `${FRAGMENT_HEAD}
uniform vec3 brow;
in vec3 vStrand;

void main() {
  float id = floor(vStrand.x);
  float chance = fract(sin(id * 91.7) * 4375.85);
  float lean = (chance - 0.5) * 0.9 * vStrand.y;
  float across = abs(fract(vStrand.x) - 0.5 + lean) * 2.0;
  float tip = vStrand.y / mix(0.35 + 0.30 * chance, 0.62 + 0.38 * chance, vStrand.z);
  float width = mix(0.34, 0.55, vStrand.z) * (1.0 - tip * tip);
  float alpha = smoothstep(width + 0.25, width - 0.10, across) * (1.0 - smoothstep(0.75, 1.0, tip)) * step(-0.3, vStrand.y);
  alpha *= mix(0.5, 1.0, vStrand.z);
  if (alpha < 0.02) discard;
  colour = premultiplied(brow * 0.08, alpha);
}
`;

/** The collar: a roll of dark cloth around the neck that widens into shoulders; it stays when the head turns. */
export const COLLAR_VERTEX = `${VERTEX_HEAD}
in vec3 offset;
in vec3 facing;
in float fade;
out vec3 vPoint;
out vec3 vNormal;
out float vFade;

void main() {
  vPoint = fetchRow(positions) + offset;
  vNormal = facing;
  vFade = fade;
  gl_Position = project(vPoint);
}
`;

export const COLLAR_FRAGMENT = `${FRAGMENT_HEAD}
in vec3 vPoint;
in vec3 vNormal;
in float vFade;

void main() {
  vec3 view = normalize(cameraPosition - vPoint);
  vec3 normal = normalize(vNormal);
  float edge = pow(1.0 - max(dot(normal, view), 0.0), 2.5);
  vec3 cloth = vec3(0.0055, 0.0055, 0.0075);
  vec3 light = cloth * (KEY_LIGHT * max(dot(normal, KEY), 0.0) + FILL_LIGHT + 0.1);
  light += RIM_LIGHT * edge * 0.06 * (max(dot(normal, RIM_LEFT), 0.0) + max(dot(normal, RIM_RIGHT), 0.0));
  colour = premultiplied(light * vFade, 1.0);
}
`;

/** The stage behind the head: near black, with a breath of light so that the silhouette reads. */
export const BACKDROP_VERTEX = `
precision highp float;
uniform vec4 window; // this picture's part of the wall's: left, bottom, width, height
out vec2 vPlace;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  vPlace = window.xy + corner * window.zw;
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
`;

export const BACKDROP_FRAGMENT = `
precision highp float;
uniform float aspect;
in vec2 vPlace;
out vec4 colour;
void main() {
  vec2 from = (vPlace - vec2(0.5, 0.58)) * vec2(aspect, 1.0);
  float glow = exp(-dot(from, from) * 3.2);
  vec3 light = mix(vec3(0.030, 0.031, 0.038), vec3(0.115, 0.108, 0.125), glow);
  float dither = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453) - 0.5;
  colour = vec4(light + dither / 255.0, 1.0);
}
`;
