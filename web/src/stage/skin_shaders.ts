import { FRAGMENT_HEAD, LIGHTS, VERTEX_HEAD } from "./shader_heads";
import { SKIN_COLOURS } from "./skin_colours";

/** The slope that 0 and 1 of the layer `relief` stand for (tools/baking/skin_relief.py: STEEPEST). */
const STEEPEST = 0.8;

/** What falls on the skin at one vertex, before its colour: for slow machines. */
const VERTEX_LIGHT = `
struct Fall { vec3 diffuse; vec2 gloss; float rim; };

Fall fall(vec3 point, vec3 normal, float open, float hair) {
  vec3 view = normalize(cameraPosition - point);
  vec3 wrap = mix(vec3(0.34, 0.17, 0.12), vec3(0.05), hair);
  vec3 key = clamp((dot(normal, KEY) + wrap) / (1.0 + wrap), 0.0, 1.0);
  key *= mix(vec3(1.0, 0.90, 0.86), vec3(1.0), key); // the terminator is warm: light that went through the skin
  float fill = clamp(dot(normal, FILL) * 0.6 + 0.4, 0.0, 1.0);
  vec3 shade = mix(vec3(open), vec3(sqrt(open), open, open), 0.6); // light that bounces in a hollow reddens
  vec3 diffuse = KEY_LIGHT * key * mix(vec3(1.0), shade, 0.8) + (FILL_LIGHT * fill + ambient(normal)) * shade * open;
  vec2 gloss = vec2(shine(normal, view, KEY, 22.0) + 0.15 * shine(normal, view, FILL, 22.0), shine(normal, view, KEY, 70.0));
  float edge = 1.0 - max(dot(normal, view), 0.0);
  float rim = edge * edge * edge * edge * (max(dot(normal, RIM_LEFT), 0.0) * 0.7 + max(dot(normal, RIM_RIGHT), 0.0));
  return Fall(diffuse, gloss, rim * open * open);
}
`;

/**
 * Light on the skin at one pixel. Light that goes in comes out again beside: the diffuse light wraps round the form,
 * red furthest, most where the skin is thin (after E. d'Eon and D. Luebke, "Advanced Techniques for Realistic Real-Time
 * Skin Rendering", 2007, and E. Penner, "Pre-Integrated Skin Shading", 2011); what stays outside shines in two lobes.
 */
const PIXEL_LIGHT = `
uniform float gloss;
#ifdef DETAIL
uniform sampler2D relief;

/** The normal tilted by slopes along the texture's columns and rows (M. Mikkelsen, "Surface Gradient Based Bump Mapping", 2020). */
vec3 tilted(vec3 normal, vec2 slope) {
  vec3 across = dFdx(vPoint), down = dFdy(vPoint);
  vec2 uvAcross = dFdx(vUv), uvDown = dFdy(vUv);
  vec3 first = cross(down, normal), second = cross(normal, across);
  vec3 u = first * uvAcross.x + second * uvDown.x;
  vec3 v = first * uvAcross.y + second * uvDown.y;
  float side = sign(dot(across, first));
  u *= inversesqrt(max(dot(u, u), 1e-24));
  v *= inversesqrt(max(dot(v, v), 1e-24));
  return normalize(normal - side * (slope.x * u + slope.y * v));
}

/** What the fine relief does to the normal. */
vec3 fine(vec3 normal, Ground at) {
  vec4 slope = (texture(relief, vUv) - 0.5) * ${(2 * STEEPEST).toFixed(1)};
  float skinned = (1.0 - at.hair) * (1.0 - at.fur) * (1.0 - lacquer);
  vec2 young = slope.rg * max(pores, at.lips * 0.8);
  return tilted(normal, (young * 2.0 + slope.ba * age * (1.0 - 0.6 * at.lips)) * skinned);
}
#endif

/** A lobe of shine that keeps its light however sharp it is. */
float lobe(float along, float sharpness) { return (sharpness + 8.0) * 0.04 * pow(along, sharpness); }

/** Two lobes, what a smooth skin mirrors of a lamp; rough 0..1. */
float lobes(vec3 normal, vec3 view, vec3 lamp, float sharpness) {
  vec3 half_ = normalize(lamp + view);
  float along = max(dot(normal, half_), 0.0);
  float grazing = 1.0 - max(dot(view, half_), 0.0);
  float mirrored = 0.04 + 0.96 * grazing * grazing * grazing * grazing * grazing;
  return mirrored * max(dot(normal, lamp) * 2.0 + 0.3, 0.0) * (0.75 * lobe(along, sharpness) + 0.25 * lobe(along, sharpness * 3.0));
}

vec3 lit(Layers layers, Ground at, float open) {
  vec3 form = normalize(vNormal);
  vec3 view = normalize(cameraPosition - vPoint);
#ifdef DETAIL
  vec3 normal = fine(form, at);
#else
  vec3 normal = form;
#endif
  float flesh = (1.0 - at.hair) * (1.0 - 0.6 * at.fur) * (1.0 - 0.7 * lacquer);
  vec3 blurred = vec3(0.65, 0.32, 0.2) * flesh; // red light goes furthest: fine relief hardly shows in it
  vec3 wrap = vec3(0.05) + (vec3(0.27, 0.11, 0.06) + layers.finish.g * vec3(0.30, 0.08, 0.04)) * flesh;
  vec3 key = mix(vec3(dot(normal, KEY)), vec3(dot(form, KEY)), blurred);
  key = clamp((key + wrap) / (1.0 + wrap), 0.0, 1.0);
  float sunlit = shadow(vPoint, form);
  vec3 bled = vec3(0.10, 0.03, 0.018) * flesh; // what comes through the flesh from where the light falls
  key *= mix(mix(vec3(sunlit), vec3(sqrt(sunlit), sunlit, sunlit), 0.5 * flesh), vec3(1.0), bled);
  key *= mix(vec3(1.0), mix(vec3(1.0, 0.88, 0.83), vec3(1.0), key), flesh);
  float fill = clamp(dot(normal, FILL) * 0.6 + 0.4, 0.0, 1.0);
  vec3 shade = mix(vec3(open), vec3(sqrt(open), open, open), 0.6 * flesh); // light that bounces in a hollow reddens
  vec3 diffuse = KEY_LIGHT * key * mix(vec3(1.0), shade, 0.8) + (FILL_LIGHT * fill + ambient(normal)) * shade * open;

  float edge = 1.0 - max(dot(normal, view), 0.0);
  float down = edge * edge * edge;
  float rims = max(dot(form, RIM_LEFT), 0.0) * 0.7 + max(dot(form, RIM_RIGHT), 0.0);
  float behind = max(dot(-form, RIM_LEFT), 0.0) * 0.7 + max(dot(-form, RIM_RIGHT), 0.0);
  float through = smoothstep(0.66, 1.0, layers.finish.g) * flesh;

  float wet = at.lips * gloss * (1.0 - at.fur) + at.leather * 0.7;
  float oily = layers.finish.r * (0.35 + 0.65 * pores) * (1.0 - 0.55 * age);
  float sharpness = mix(mix(10.0, 26.0, oily), 90.0, max(wet, lacquer * 0.75));
  float strength = (0.26 + 0.52 * oily + 1.1 * wet) * mix(1.0, layers.finish.b, pores);
  strength = mix(strength, 0.8, lacquer) * (1.0 - 0.85 * at.hair) * (1.0 - 0.8 * (at.fur - at.leather));
  strength *= open;
  vec3 mirror = KEY_LIGHT * sunlit * lobes(normal, view, KEY, sharpness) + FILL_LIGHT * lobes(normal, view, FILL, sharpness * 0.5);
  mirror += ambient(reflect(-view, normal)) * (0.03 + 0.4 * down * edge) * (0.4 + 2.0 * wet + lacquer) * open;

  vec3 seen = at.albedo * diffuse + strength * 1.6 * mirror;
  seen += at.albedo * (FILL_LIGHT + KEY_LIGHT * 0.25 * sunlit * max(dot(form, KEY) + 0.5, 0.0)) * down * (0.35 * flesh + 1.2 * at.fur) * open; // down on the skin
  seen += RIM_LIGHT * rims * down * edge * open * open * mix(0.10 + 1.1 * at.albedo, vec3(0.16), at.hair) * (1.0 + at.fur);
  seen += at.albedo * vec3(1.0, 0.28, 0.14) * RIM_LIGHT * behind * through * 0.8;
  return seen;
}
`;

export const SKIN_VERTEX = `${VERTEX_HEAD}${LIGHTS}${VERTEX_LIGHT}
in vec2 uv;
in vec4 traits; // turn with the head, open sky, hair, light at the neck
out vec2 vUv;
out vec3 vTraits;
#ifdef FAST
uniform float scalp;
out vec3 vDiffuse;
out vec3 vGloss;
#else
out vec3 vPoint;
out vec3 vNormal;
#endif

float openness(float sky) { return smoothstep(0.05, 1.0, shaded(sky)); }

void main() {
  vec3 point = turned(fetchRow(positions), traits.x);
  vec3 normal = turnedNormal(fetchRow(normals), traits.x);
  vUv = uv;
  vTraits = vec3(openness(traits.y), traits.zw);
#ifdef FAST
  Fall light = fall(point, normal, vTraits.x, traits.z * scalp);
  vDiffuse = light.diffuse;
  vGloss = vec3(light.gloss, light.rim);
#else
  vPoint = point;
  vNormal = normal;
#endif
  gl_Position = project(point);
}
`;

export const SKIN_FRAGMENT = `${FRAGMENT_HEAD}
in vec2 vUv;
in vec3 vTraits;
#ifdef FAST
in vec3 vDiffuse;
in vec3 vGloss;
uniform float gloss;
#else
in vec3 vPoint;
in vec3 vNormal;
#endif
#ifdef DETAIL
uniform sampler2D finish;
#endif
${SKIN_COLOURS}
#ifndef FAST
${PIXEL_LIGHT}
#endif

void main() {
#ifdef DETAIL
  vec4 finished = texture(finish, vUv);
#else
  const vec4 finished = vec4(0.45, 0.2, 1.0, 0.5);
#endif
  Layers layers = Layers(texture(mask, vUv), texture(marks, vUv), texture(patches, vUv), finished);
  Ground at = ground(layers, vTraits.y);
#ifdef FAST
  float oil = (0.05 + 0.13 * at.lips * gloss + 0.06 * lacquer) * (1.0 - at.hair) * (1.0 - 0.7 * at.fur) * vTraits.x;
  vec3 seen = at.albedo * vDiffuse;
  seen += KEY_LIGHT * oil * (vGloss.x + (1.2 + 3.0 * at.lips) * vGloss.y);
  seen += RIM_LIGHT * vGloss.z * mix(0.12 + 1.1 * at.albedo, vec3(0.16), at.hair);
#else
  vec3 seen = lit(layers, at, vTraits.x);
#endif
  colour = premultiplied(seen * vTraits.z, 1.0);
}
`;
