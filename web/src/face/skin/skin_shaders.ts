/** Shaders of the skin: its light in hollows and through flesh, fine relief, two specular lobes. */

import { MOUTH_LIGHT_LAW } from "../light/mouth_light";
import { FRAGMENT_HEAD, LIGHTS, VERTEX_HEAD } from "../light/shader_prelude";
import { BLOOD, FLUSHED } from "./blood";
import { FOLDS } from "./fold_shaders";
import { SCALP_COLOURS, SKIN_COLOURS } from "./skin_colour_shaders";
import { OILY } from "./skin_paint_shaders";
import { WATER } from "./water_shaders";

/** The slope that 0 and 1 of the layer `relief` stand for (tools/baking/skin/relief.py: STEEPEST). */
const STEEPEST = 0.8;

/**
 * Light out of the shade. `onFlesh`: cool light from aside turns grey on skin, so flesh takes it mostly in the hue of the
 * key. `bounced`: what a hollow leaves of the light that goes to and fro in it; it keeps the skin's own hue
 * (J. Jimenez et al., "Practical Realtime Strategies for Accurate Indirect Occlusion", 2016). `deepened`: the hue of what
 * only light from skin to skin reaches.
 */
const SHADE_LIGHT = `
vec3 onFlesh(vec3 light, float flesh) {
  const vec3 SEEN = vec3(0.2126, 0.7152, 0.0722);
  vec3 hue = (KEY_LIGHT + 1e-3) / (dot(KEY_LIGHT, SEEN) + 1e-3);
  return mix(light, dot(light, SEEN) * hue, 0.85 * flesh);
}

vec3 bounced(float open, vec3 albedo) {
  vec3 a = 2.0404 * albedo - 0.3324, b = 0.6417 - 4.7951 * albedo, c = 2.7552 * albedo + 0.6903;
  return max(vec3(open), ((open * a + b) * open + c) * open);
}

vec3 deepened(vec3 albedo, float flesh) {
  return mix(vec3(1.0), 1.12 * albedo / max(max(albedo.r, albedo.g), max(albedo.b, 1e-3)), 0.32 * flesh)
    * mix(vec3(1.0), vec3(1.08, 0.97, 0.945), flesh); // blood lets red pass
}
`;

/** How much light is left on lips and in the mouth's lining at least: lips that part let it in, and flesh lets it through. */
const GLOW = "0.42";

/** The share of the key light that the lining of a wide open mouth shows. */
const WALLS = "0.14";

/** How much deeper the lining of the mouth is drawn, metres. */
const DEEPER = "0.012";

/** What falls on the skin at one vertex, before its colour: for slow machines. */
const VERTEX_LIGHT = `
uniform vec3 skin;
struct Fall { vec3 diffuse; vec2 gloss; float rim; };

Fall fall(vec3 point, vec3 normal, float open, float hair) {
  vec3 view = normalize(viewPoint - point);
  float flesh = 1.0 - hair;
  vec3 wrap = mix(vec3(0.05), vec3(0.22, 0.16, 0.13), flesh);
  vec3 key = clamp((dot(normal, KEY) + wrap) / (1.0 + wrap), 0.0, 1.0);
  key *= mix(vec3(1.0, 0.95, 0.92), vec3(1.0), key); // the terminator is warm: light that went through the skin
  float fill = clamp(dot(normal, FILL) * 0.6 + 0.4, 0.0, 1.0);
  vec3 shade = mix(vec3(open), bounced(open, skin), flesh);
  vec3 around = onFlesh(FILL_LIGHT * fill + ambient(normal), mix(1.0, flesh, 0.4)) * deepened(skin, flesh);
  vec3 diffuse = KEY_LIGHT * key * mix(vec3(1.0), shade, 0.8) + around * shade * open;
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
in vec3 vUp;
${FOLDS}${WATER}

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
  vec4 slope = (layer(relief) - 0.5) * ${(2 * STEEPEST).toFixed(1)};
  float skinned = (1.0 - at.hair) * (1.0 - at.fur) * (1.0 - lacquer);
  vec2 young = slope.rg * max(pores, at.lips * 0.8);
  return tilted(normal, (young * 2.6 + slope.ba * age * (1.0 - 0.6 * at.lips)) * skinned);
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

#ifdef DETAIL
/**
 * What a drop adds to the light of the skin under it, \`below\`: its own highlights, what it mirrors at its rim, the light
 * that it gathers at its side away from the key, what it lacks at the other, and its shadow.
 */
vec3 dropped(Water water, vec3 form, vec3 normal, vec3 view, vec3 below, vec3 key, vec3 fill) {
  vec3 level = cross(vUp, form);
  level *= inversesqrt(max(dot(level, level), 1e-6)); // under the chin nothing is level
  vec3 upright = cross(form, level);
  normal = normalize(mix(normal, form, water.lies)); // pores are under water
  vec3 domed = normalize(normal + water.slope.x * level + water.slope.y * upright);
  vec2 towards = vec2(dot(KEY, level), dot(KEY, upright));
  float steep = min(length(water.slope), 1.2);
  float lamp = dot(water.slope, towards) * inversesqrt(dot(towards, towards) + 0.05) / max(steep, 0.05);
  float far = max(-lamp, 0.0);
  float foot = 4.0 * water.lies * (1.0 - water.lies);
  float gathered = water.lies * steep * (0.9 * far * steep - 0.25 * max(lamp, 0.0)) - 0.4 * foot * far * smoothstep(0.2, 0.6, steep); // a film has no foot
  float edge = 1.0 - max(dot(domed, view), 0.0);
  vec3 rim = edge * edge * (0.35 * fill + 0.25 * ambient(domed));
  vec3 shining = key * lobes(domed, view, KEY, mix(45.0, 150.0, steep / 1.2)) + fill * lobes(domed, view, FILL, 60.0);
  return below * gathered + water.lies * (2.8 * shining + rim);
}
#endif

vec3 lit(Layers layers, Ground at, float open) {
  vec3 form = normalize(vNormal);
  vec3 view = normalize(viewPoint - vPoint);
#ifdef DETAIL
  vec3 normal = fine(form, at);
  if (folds > 0.0) {
    Folded folded = foldsAt(form, at);
    normal = normalize(normal - folded.slope);
    at.albedo *= mix(vec3(1.0), mix(vec3(0.60, 0.47, 0.42), vec3(0.5), at.fur), folded.groove);
    open *= mix(1.0, 0.65, folded.groove);
  }
#else
  vec3 normal = form;
#endif
  float flesh = (1.0 - at.hair) * (1.0 - 0.6 * at.fur) * (1.0 - 0.7 * lacquer);
  vec3 blurred = vec3(0.65, 0.32, 0.2) * flesh; // red light goes furthest: fine relief hardly shows in it
  vec3 wrap = vec3(0.05) + (vec3(0.19, 0.10, 0.065) + layers.finish.g * vec3(0.10, 0.045, 0.025)) * flesh;
  vec3 key = mix(vec3(dot(normal, KEY)), vec3(dot(form, KEY)), blurred);
  key = clamp((key + wrap) / (1.0 + wrap), 0.0, 1.0);
  float sunlit = shadow(vPoint, form);
  float inside = max(at.lining, at.lips * smoothstep(0.7, 0.95, layers.mask.r)); // seen edge on, it mirrors the mouth behind it
#ifdef DETAIL
  sunlit = max(sunlit, 0.3 * inside); // lips shade each other, and light goes through them
#endif
  key *= mix(vec3(sunlit), vec3(sqrt(sunlit), sunlit, sunlit * sunlit), 0.14 * flesh); // light that comes out beside: red far into a shadow, blue not
  key *= mix(vec3(1.0), mix(vec3(1.0, 0.93, 0.88), vec3(1.0), key), flesh);
  float fill = clamp(dot(normal, FILL) * 0.6 + 0.4, 0.0, 1.0);
  vec3 shade = mix(vec3(open), bounced(open, at.albedo), flesh);
  float warm = mix(flesh, 1.0, 0.6 * at.hair); // the scalp between hairs is skin too
  vec3 around = onFlesh(FILL_LIGHT * fill + ambient(normal), warm) * deepened(at.albedo, flesh);
  vec3 diffuse = KEY_LIGHT * key * mix(vec3(1.0), shade, 0.8) + around * shade * open;

  float edge = 1.0 - max(dot(normal, view), 0.0);
  float down = edge * edge * edge;
  float rims = max(dot(form, RIM_LEFT), 0.0) * 0.7 + max(dot(form, RIM_RIGHT), 0.0);
  float behind = max(dot(-form, RIM_LEFT), 0.0) * 0.7 + max(dot(-form, RIM_RIGHT), 0.0);
  float through = smoothstep(0.66, 1.0, layers.finish.g) * flesh * (1.0 - smoothstep(0.02, 0.06, vPoint.z)); // in front, the head stands between

  float wet = at.lips * gloss * (1.0 - at.fur) + at.leather * 0.7;
  float oily = layers.finish.r * (0.35 + 0.65 * pores) * (1.0 - 0.55 * age);
  float sharpness = mix(mix(11.0, 32.0, oily), 90.0, max(wet, lacquer * 0.75));
  float strength = (0.32 + 0.66 * oily + 1.1 * wet) * mix(1.0, layers.finish.b, pores);
  strength = mix(strength, 0.8, lacquer) * (1.0 - 0.97 * at.hair) * (1.0 - 0.8 * (at.fur - at.leather));
  strength *= open;
#ifdef DETAIL
  Water water = waterAt((1.0 - at.hair) * (1.0 - at.lips));
  wet = max(wet, max(water.lies, 0.5 * water.film));
  sharpness = mix(sharpness, 42.0, 0.8 * water.film);
  strength = mix(strength, max(strength, 0.85 * open), water.film) * (1.0 - 0.4 * water.lies);
#endif
  vec3 aside = onFlesh(FILL_LIGHT, flesh) * mix(1.0, 0.6, flesh);
  vec3 mirror = KEY_LIGHT * sunlit * lobes(normal, view, KEY, sharpness) + aside * lobes(normal, view, FILL, sharpness * 0.5);
  mirror += onFlesh(ambient(reflect(-view, normal)), flesh) * (0.03 + 0.4 * down * edge) * (0.4 + 2.0 * wet + lacquer) * open * (1.0 - inside);

  vec3 seen = at.albedo * diffuse + strength * 1.6 * mirror;
#ifdef DETAIL
  if (water.lies > 0.0) seen += dropped(water, form, normal, view, at.albedo * diffuse, KEY_LIGHT * sunlit, aside) * sqrt(open);
#endif
  seen += at.albedo * (aside + KEY_LIGHT * 0.25 * sunlit * max(dot(form, KEY) + 0.5, 0.0)) * down * (0.35 * flesh + 1.2 * at.fur) * open; // down on the skin
  vec3 rim = onFlesh(RIM_LIGHT, 0.5 * flesh) * mix(1.0, 0.75, flesh);
  seen += rim * rims * down * edge * open * open * mix(mix(0.10, 0.03, flesh) + 1.1 * at.albedo, 0.02 + 0.5 * at.albedo, at.hair) * (1.0 + at.fur);
  seen += at.albedo * vec3(1.0, 0.34, 0.18) * RIM_LIGHT * behind * through * open * 0.6;
#ifdef DETAIL
  seen += at.lining * at.albedo * (KEY_LIGHT * ${WALLS} + ambient(normal)) * mix(0.4, 1.0, sunlit); // to and fro between the walls of the mouth
#endif
  return seen;
}
`;

/** The code of a surface whose rows and normals are in these textures. */
const surfaceOf = (positions: string, normals: string): string => `
uniform sampler2D roots; // how densely hair grows at each row
vec3 placeAt(int row) { return texelFetch(${positions}, texelOf(row), 0).xyz; }
vec3 normalAt(int row) { return texelFetch(${normals}, texelOf(row), 0).xyz; }
#ifdef CURVED
in vec3 rows;
in vec3 shares;

vec3 besides(vec3 point, vec3 corner, vec3 normal) { return dot(point - corner, normal) * normal; }

vec3 surface(out vec3 normal) {
  ivec3 at = ivec3(rows + 0.5);
  vec3 a = placeAt(at.x), b = placeAt(at.y), c = placeAt(at.z);
  vec3 na = normalAt(at.x), nb = normalAt(at.y), nc = normalAt(at.z);
  normal = shares.x * na + shares.y * nb + shares.z * nc;
  vec3 point = shares.x * a + shares.y * b + shares.z * c;
  return point - 0.5 * (shares.x * besides(point, a, na) + shares.y * besides(point, b, nb) + shares.z * besides(point, c, nc));
}

float grown() {
  ivec3 at = ivec3(rows + 0.5);
  return dot(shares, vec3(texelFetch(roots, texelOf(at.x), 0).r, texelFetch(roots, texelOf(at.y), 0).r, texelFetch(roots, texelOf(at.z), 0).r));
}
#else
float grown() { return texelFetch(roots, texelOf(int(source + 0.5)), 0).r; }

vec3 surface(out vec3 normal) {
  int row = int(source + 0.5);
  normal = normalAt(row);
  return placeAt(row);
}
#endif
`;

/**
 * Where a vertex of the skin lies, and which way it faces. CURVED: between three rows, each of which says by its normal
 * how the skin curves (T. Boubekeur and M. Alexa, "Phong Tessellation", 2008; 0.5 keeps a ball round).
 */
export const SURFACE = surfaceOf("positions", "normals");

/** The same of skin that a body carries: its rows are where the figure has them. */
export const POSED_SURFACE = `
#ifdef FIGURE${surfaceOf("figurePositions", "figureNormals")}
#else${SURFACE}
#endif
`;

/**
 * `layer(picture)`: a painted layer at this pixel. SHARPEN: where the skin is seen at a slant, the texels of one level
 * finer at most, for trilinear filtering blurs as far across the slant as along it, and lines are lost.
 */
const LAYER_SAMPLING = `
#ifdef SHARPEN
float sharper; // levels of the mipmap

/** How many levels of a mipmap lie between a pixel's long side and its short one on the texture, 1 at most. */
float slant() {
  vec2 across = dFdx(vUv), down = dFdy(vUv);
  float both = 0.5 * (dot(across, across) + dot(down, down));
  float area = abs(across.x * down.y - across.y * down.x);
  float longest = both + sqrt(max(both * both - area * area, 0.0)); // squared, of the ellipse
  return clamp(log2(max(longest, 1e-20) / max(area, 1e-20)), 0.0, 1.0);
}

vec4 layer(sampler2D picture) { return texture(picture, vUv, sharper); }
#else
vec4 layer(sampler2D picture) { return texture(picture, vUv); }
#endif
`;

export const SKIN_VERTEX = `${VERTEX_HEAD}${LIGHTS}${SHADE_LIGHT}${VERTEX_LIGHT}${BLOOD}${FLUSHED}
in vec2 uv;
in vec4 traits; // turn with the head, open sky, hair on who wears none, light at the neck
in float behind; // metres behind the lips
uniform ivec4 lipRows; // right and left corner, the middle of the upper and of the lower edge
${POSED_SURFACE}
#ifdef FAST
uniform float scalp;
uniform vec3 hair;
out vec4 vPaint; // place on its pictures, hairline, shine
out vec4 vLight; // and shine on lips
#else
out vec2 vUv;
out vec4 vTraits;
out vec3 vPoint;
out vec3 vNormal;
#ifdef DETAIL
uniform sampler2D strains;
uniform float pressed;
in vec3 frontal;
in float folding;
out vec3 vPressed;
out vec3 vUp;
out vec3 vFrontal;

#ifdef CURVED
vec3 strained() {
  ivec3 at = ivec3(rows + 0.5);
  return mat3(texelFetch(strains, texelOf(at.x), 0).xyz, texelFetch(strains, texelOf(at.y), 0).xyz, texelFetch(strains, texelOf(at.z), 0).xyz) * shares;
}
#else
vec3 strained() { return fetchRow(strains); }
#endif

/** How far the skin is pressed, of the most that it is; and what blood that drives out, or draws in. */
float press(out vec3 share) {
  share = vec3(0.0);
  if (pressed * folding <= 0.0) return 0.0;
  vec3 strain = strained();
  share = strain / folding;
  return clamp(-0.5 * (strain.x + strain.z), -0.22, 0.22);
}
#endif
#endif

/** The lining of the mouth lies so close around gums and crowns that its triangles cut them: it is drawn as if it lay deeper. */
vec4 drawnDeeper(vec3 point) {
  vec4 place = project(point);
  float deeper = ${DEEPER} * smoothstep(0.0, 0.003, behind) * (1.0 - 0.85 * smoothstep(0.015, 0.03, behind)); // far inside, the head's other side is near
  place.z = (place.z - projectionMatrix[2][2] * deeper) * place.w / (place.w + deeper);
  return place;
}

#ifdef DETAIL
${MOUTH_LIGHT_LAW}
/** How much light comes through the lips to the lining of the mouth: by one opening for all of it. */
float entering(vec3 here) {
  vec3 right = rowAt(lipRows.x), left = rowAt(lipRows.y), upper = rowAt(lipRows.z), lower = rowAt(lipRows.w);
  float deep = max(0.5 * (upper.z + lower.z) - here.z, 0.0);
  float sky = skyThrough(vec4(upper.y - here.y, here.y - lower.y, here.x - right.x, left.x - here.x), deep);
  return mix(1.0, sky, smoothstep(0.0, 0.005, behind));
}
#else
float entering(vec3 here) { return 1.0; }
#endif

float openness(float sky) { return smoothstep(0.05, 1.0, shaded(sky)); }

void main() {
  vec3 normal;
  vec3 here = surface(normal);
#ifdef FIGURE
  vec3 point = here; // its bones have turned it
#ifdef CURVED
  here = rowAt(int(rows.x + 0.5));
#else
  here = fetchRow(positions);
#endif
#else
  vec3 point = turned(here, traits.x);
  normal = turnedNormal(normal, traits.x);
#endif
  float light = traits.w * entering(here);
  float open = openness(traits.y);
  float haired = grown();
#ifdef FAST
  Fall fallen = fall(point, normal, open, haired * scalp);
  vec2 shines = light * open * fallen.gloss;
  vec3 edges = mix(0.85 + 0.02 / max(skin, 0.02), 0.5 + 0.02 / max(hair, 0.02), haired * scalp); // as the colour that they are multiplied with wants it
  vPaint = vec4(uv, haired, shines.x + 1.2 * shines.y);
  vec3 bled = mix(flushed(bloodAt(0.0)), vec3(1.0), haired * scalp);
  vLight = vec4(light * bled * (fallen.diffuse + fallen.rim * edges * RIM_LIGHT), 3.0 * shines.y);
#else
  vUv = uv;
  float squeezed = 0.0;
#ifdef DETAIL
  squeezed = press(vPressed);
  vUp = mix(vec3(0.0, 1.0, 0.0), headTurn[1], traits.x);
  vFrontal = frontal;
#endif
  vTraits = vec4(open, haired, light, bloodAt(squeezed));
  vPoint = point;
  vNormal = normal;
#endif
  gl_Position = drawnDeeper(point);
}
`;

/** The skin's colour at a pixel, from the picture that `SkinPaint` keeps of it, in the light of its vertices: for slow machines. */
const PAINTED_LIGHT = `${SCALP_COLOURS}
uniform sampler2D paint;
uniform sampler2D sheen;
in vec4 vPaint;
in vec4 vLight;

vec3 seen() {
  vec4 painted = texture(paint, vPaint.xy);
  vec4 finish = texture(sheen, vPaint.xy);
  float grown = stubbled(vPaint.z, finish.b) * scalp;
  vec3 albedo = mix(painted.rgb * painted.rgb, scalpHair(finish.b) * painted.a, grown);
  float oil = ${(1 / OILY).toFixed(4)} * finish.r * (1.0 - grown);
  return albedo * vLight.rgb + KEY_LIGHT * (oil * (vPaint.w + finish.g * vLight.a));
}
`;

/** The skin's colour and light at a pixel, from all of its layers. */
const LAYERED_LIGHT = `
in vec2 vUv;
in vec4 vTraits;
in vec3 vPoint;
in vec3 vNormal;
#ifdef DETAIL
uniform sampler2D finish;
${MOUTH_LIGHT_LAW}#endif
${LAYER_SAMPLING}${FLUSHED}${SKIN_COLOURS}${SHADE_LIGHT}${PIXEL_LIGHT}
/** How much of the blood at a place shows: in the patches of the skin's own mottling, more where it is thin, less at pores. */
float capillary(vec4 finished) {
#ifdef DETAIL
  return clamp(1.06 + 1.3 * (finished.a - 0.5), 0.5, 1.5) * mix(0.6, 1.0, finished.b)
    * (1.0 + 0.5 * smoothstep(0.7, 1.0, finished.g));
#else
  return 1.0;
#endif
}

vec3 seen() {
#ifdef SHARPEN
  sharper = -slant();
#endif
#ifdef DETAIL
  vec4 finished = layer(finish);
#else
  const vec4 finished = vec4(0.45, 0.2, 1.0, 0.5);
#endif
  Layers layers = Layers(layer(mask), layer(marks), layer(patches), finished, fur > 0.0 ? layer(pelt) : vec4(0.0));
#ifdef DETAIL
  layers.mask.g = texture(mask, vUv, 3.0).g; // hairs of the brows are drawn over their shade
#endif
  Ground at = ground(layers, vTraits.y);
  at.albedo *= mix(flushed(vTraits.w * capillary(finished)), vec3(1.0), at.hair);
  vec3 light = lit(layers, at, max(vTraits.x, ${GLOW} * max(at.lining, at.lips))) * vTraits.z;
#ifdef DETAIL
  light = mix(light, MOUTH_DARK * KEY_LIGHT, at.lining * (1.0 - outOfDark(shaded(vTraits.z))));
#endif
  return light;
}
`;

export const SKIN_FRAGMENT = `${FRAGMENT_HEAD}
#ifdef FAST
${PAINTED_LIGHT}
#else
${LAYERED_LIGHT}
#endif

void main() { colour = premultiplied(seen(), 1.0); }
`;
