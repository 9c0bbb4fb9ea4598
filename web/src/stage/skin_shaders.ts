import { FRAGMENT_HEAD, LIGHTS, VERTEX_HEAD } from "./shader_heads";

/** What falls on the skin at one place, before its colour; per vertex on slow machines, else per pixel. */
const SKIN_LIGHT = `
struct Fall { vec3 diffuse; vec2 gloss; float rim; };

float openness(float sky) { return smoothstep(0.05, 1.0, sky); }

Fall fall(vec3 point, vec3 normal, float open, float hair) {
  open = shaded(open);
  vec3 view = normalize(cameraPosition - point);
  vec3 wrap = mix(vec3(0.34, 0.17, 0.12), vec3(0.05), hair);
  vec3 key = clamp((dot(normal, KEY) + wrap) / (1.0 + wrap), 0.0, 1.0);
  float unshadowed = shadow(point, normal);
  key *= mix(vec3(unshadowed, unshadowed * unshadowed, unshadowed * unshadowed), vec3(unshadowed), 0.7); // light that bleeds into a penumbra is red
  key *= mix(vec3(1.0, 0.90, 0.86), vec3(1.0), key); // the terminator is warm: light that went through the skin
  float fill = clamp(dot(normal, FILL) * 0.6 + 0.4, 0.0, 1.0);
  vec3 shade = mix(vec3(open), vec3(sqrt(open), open, open), 0.6); // light that bounces in a hollow reddens
  vec3 diffuse = KEY_LIGHT * key * mix(vec3(1.0), shade, 0.8) + (FILL_LIGHT * fill + ambient(normal)) * shade * open;
  vec2 gloss = vec2(unshadowed * shine(normal, view, KEY, 22.0) + 0.15 * shine(normal, view, FILL, 22.0), unshadowed * shine(normal, view, KEY, 70.0));
  float edge = 1.0 - max(dot(normal, view), 0.0);
  float rim = edge * edge * edge * edge * (max(dot(normal, RIM_LEFT), 0.0) * 0.7 + max(dot(normal, RIM_RIGHT), 0.0));
  return Fall(diffuse, gloss, rim * open * open);
}
`;

export const SKIN_VERTEX = `${VERTEX_HEAD}${LIGHTS}${SKIN_LIGHT}
in vec2 uv;
in vec4 traits; // turn with the head, open sky, hair, light at the neck
out vec2 vUv;
out vec3 vTraits;
#ifdef FAST
out vec3 vDiffuse;
out vec3 vGloss;
#else
out vec3 vPoint;
out vec3 vNormal;
#endif

void main() {
  vec3 point = turned(fetchRow(positions), traits.x);
  vec3 normal = turnedNormal(fetchRow(normals), traits.x);
  vUv = uv;
  vTraits = vec3(openness(traits.y), traits.zw);
#ifdef FAST
  Fall light = fall(point, normal, vTraits.x, traits.z);
  vDiffuse = light.diffuse;
  vGloss = vec3(light.gloss, light.rim);
#else
  vPoint = point;
  vNormal = normal;
#endif
  gl_Position = project(point);
}
`;

export const SKIN_FRAGMENT = `${FRAGMENT_HEAD}${SKIN_LIGHT}
uniform sampler2D mask;
uniform sampler2D grain;
uniform vec3 skin;
uniform vec3 lip;
uniform vec3 brow;
uniform vec3 blush;
in vec2 vUv;
in vec3 vTraits;
#ifdef FAST
in vec3 vDiffuse;
in vec3 vGloss;
#else
in vec3 vPoint;
in vec3 vNormal;
#endif

void main() {
  vec4 region = texture(mask, vUv);
  vec4 pores = texture(grain, vUv * 9.0) - 0.5;
#ifdef FAST
  vec4 blotch = pores;
#else
  vec4 blotch = texture(grain, vUv * 1.7) - 0.5;
#endif
  float open = vTraits.x;
  float hair = smoothstep(0.35, 0.65, vTraits.y + (pores.r + blotch.g) * 0.35);
#ifdef FAST
  Fall light = Fall(vDiffuse, vGloss.xy, vGloss.z);
#else
  Fall light = fall(vPoint, normalize(vNormal), open, hair);
#endif
  float lips = region.r;
  vec3 albedo = skin * (1.0 + pores.g * 0.14 + blotch.r * 0.16) * (1.0 + vec3(0.10, -0.04, -0.06) * blotch.b);
  albedo = mix(albedo, blush, region.b * 0.55);
  albedo = mix(albedo, lip, lips * 0.9);
  albedo = mix(albedo, brow, region.g * 0.92);
  albedo = mix(albedo, brow * (0.75 + 0.7 * pores.r), hair);
  albedo *= region.a * mix(1.0, region.a, 0.3); // what cavities and the lash line leave of the light

  float oil = (0.055 + 0.11 * lips) * (1.0 - hair) * open * (1.0 + pores.a * 1.4) * (1.0 - region.g);
  vec3 seen = albedo * light.diffuse;
  seen += KEY_LIGHT * oil * (light.gloss.x + (1.2 + 3.0 * lips) * light.gloss.y);
  seen += RIM_LIGHT * light.rim * mix(0.12 + 1.1 * albedo, vec3(0.16), hair);
  colour = premultiplied(seen * vTraits.z, 1.0);
}
`;
