/** Shaders of hair: ribbons that face the camera, lit as Kajiya and Kay (1989). */

import { FRAGMENT_HEAD, SHADED_LIGHTS, VERTEX_HEAD } from "../light/shader_prelude";

/**
 * Light on hair (Kajiya and Kay 1989): a soft shade around the strand, a white sheen and a coloured one beside it. What
 * changes slowly along a ribbon is found at its vertices; \`sheens\` needs the fibre too. The powers are multiplied out,
 * for software renderers.
 */
const HAIR_LIGHT = `
/** halves: cosines of the strand and of its normal to half way between the eye and the key (xy), and the fill (zw). */
struct HairFall { vec3 diffuse; vec3 rim; vec4 halves; float facing; };

HairFall hairFall(vec3 point, vec3 normal, vec3 along, float open, float sunlit) {
  vec3 view = normalize(viewPoint - point);
  float lit = dot(normal, KEY);
  float key = clamp((lit + 0.35) / 1.35, 0.0, 1.0) * shaded(open) * sunlit;
  float cosine = dot(along, KEY);
  float around = sqrt(max(1.0 - cosine * cosine, 0.0));
  vec3 diffuse = KEY_LIGHT * key * mix(around, 1.0, 0.4);
  diffuse += (FILL_LIGHT * clamp(dot(normal, FILL) * 0.5 + 0.5, 0.0, 1.0) + 1.6 * ambient(normal)) * shaded(open);
  vec3 toKey = normalize(KEY + view);
  vec3 toFill = normalize(FILL + view);
  vec4 halves = vec4(dot(along, toKey), dot(normal, toKey), dot(along, toFill), dot(normal, toFill));
  float facing = smoothstep(-0.25, 0.5, lit) * shaded(open) * key;
  float edge = 1.0 - max(dot(normal, view), 0.0);
  float rim = edge * edge * edge * (max(dot(normal, RIM_LEFT), 0.0) * 0.7 + max(dot(normal, RIM_RIGHT), 0.0));
  return HairFall(diffuse, RIM_LIGHT * rim * open, halves, facing);
}

/** The sheen of the fibres, tilted by \`shift\`, and their glow. */
void sheens(vec3 rim, vec4 halves, float facing, float open, float shift, out vec3 sheen, out vec3 glow) {
  float root = 0.10 + shift;
  float tip = 0.16 + shift;
  vec2 rootward = (halves.xz - root * halves.yw) * inversesqrt(1.0 + root * root);
  float tipward = (halves.x + tip * halves.y) * inversesqrt(1.0 + tip * tip);
  vec2 to1 = max(1.0 - rootward * rootward, 0.0);
  vec2 to2 = to1 * to1;
  vec2 to4 = to2 * to2;
  vec2 to8 = to4 * to4;
  vec2 to16 = to8 * to8;
  vec2 to32 = to16 * to16;
  vec2 to64 = to32 * to32;
  float key = to64.x * to32.x * to16.x * to8.x; // to the power of 120
  float fill = to64.y * to16.y * to8.y * to2.y; // 90
  float soft = max(1.0 - tipward * tipward, 0.0);
  soft *= soft;
  soft *= soft;
  soft *= soft;
  soft *= soft; // 16
  sheen = KEY_LIGHT * key * facing + FILL_LIGHT * 0.5 * fill * open;
  glow = KEY_LIGHT * soft * facing + rim;
}
`;

/** A ribbon of strands: its places are offsets from the skin at its root (\`source\`), mixed as the faces are. */
export const HAIR_VERTEX = `${VERTEX_HEAD}
in float strandRow;
in float fullness; // of the width, 0..1: hair is finer towards its edges; below 0 it is down at the hairline
#define SPIN chanceOf(0u)
#ifdef DETAIL
#define FIBRE 0.00045 // metres across the hairs that cling together and are seen as one
#define PARTED 0.0007 // and those between which one sees through
#else
#define FIBRE 0.0011
#define PARTED FIBRE
#endif
// Half of the pixels that a ribbon is drawn wide at least, where it is narrower or seen from its edge; with one sample a
// pixel it would be a row of dots there, and so would the skin between two ribbons: each lies that much over the next.
#ifdef SOFT
#define NARROWEST 0.55
#define OVERLAP 0.0
#else
#define NARROWEST 0.9 // an edge on either side: what smooths edges afterwards breaks thinner lines
#define OVERLAP 0.4
#endif
#define SCARCE 0.8 // of that width: ribbons end one by one where they are narrower, instead of all being wider than they are
#define HANGS 1.0 // of the swing, that the tips of long hair follow
#define LONG 0.12 // metres
#define SLENDER 0.12 // half the width of a ribbon that is this short, of its length

/** Ribbons are drawn in another order than strands are numbered; one strand's, thin ones in detail, follow each other. */
int strandNumber() { return int(strandRow + 0.5); }
#ifdef DETAIL
int ribbonNumber() { return KIN * strandNumber() + gl_InstanceID % KIN; }
#else
int ribbonNumber() { return strandNumber(); }
#endif

/** A chance (0..1) of this ribbon, another for every salt; in whole numbers, so that it is the same on every machine. */
float chanceOf(uint salt) {
  uint mixed = uint(ribbonNumber()) * 0x9e3779b1u + (fullness < 0.0 ? salt + 16u : salt) * 0x85ebca6bu;
  mixed = (mixed ^ (mixed >> 16)) * 0x7feb352du;
  mixed = (mixed ^ (mixed >> 15)) * 0x846ca68bu;
  return float(mixed >> 8) / 16777216.0;
}
${SHADED_LIGHTS}${HAIR_LIGHT}
uniform sampler2D strands; // a line for each strand: metres from its anchor, root to tip; how much of its length and width, its length (w)
uniform sampler2D shape;   // away from the head (xyz), open sky (w)
uniform float stations;
uniform float width;
uniform float pixel; // metres a pixel is wide, one metre away
uniform vec3 swing; // how far it is turned against the head, a rotation vector
in vec2 place; // across -1..1, along 0..1
#ifdef FAST
out vec4 vFibre; // place on the noise, and what covers between the fibres as below
out vec4 vDiffuse; // times the ribbon's own brightness; and its place across
out vec3 vSheen;
#else
out vec3 vPlace; // and half of the ribbon's width, in fibres
out vec2 vChance;
out vec2 vCover; // what covers between the fibres (nothing below zero), and how far a pixel shows them, 0..1
out vec3 vDiffuse;
out vec3 vRim;
out vec4 vHalves;
out vec2 vFacing; // and open sky
#endif

#ifdef DETAIL
out float vSway;
uniform sampler2D grain;
#define STRAY 0.90 // of all ribbons lie with their strand
#define DOWN_LONG 0.012 // metres
#define DOWN_FINE 0.2 // of the width
#define DOWN_APART 0.009 // metres that the down of one strand spreads over to either side, and half as far ahead of the hairline
#define KIN_APART 6.5 // half-widths of a ribbon that those of one strand spread over
/** A round course beside the stations, a uniform cubic B-spline: where it is \`part\` of the way between the middle two. */
vec3 coursed(vec3 a, vec3 b, vec3 c, vec3 d, float part) {
  return (a + 4.0 * b + c + part * (3.0 * (c - a) + part * (3.0 * (a - 2.0 * b + c) + part * (d - a + 3.0 * (b - c))))) / 6.0;
}

vec3 heading(vec3 a, vec3 b, vec3 c, vec3 d, float part) {
  return 0.5 * (c - a + part * (2.0 * (a - 2.0 * b + c) + part * (d - a + 3.0 * (b - c))));
}
#endif

void main() {
  int strand = strandNumber();
  float chance = chanceOf(1u);
  float roll = chanceOf(2u) - 0.5;
  float grown = texelFetch(strands, ivec2(0, strand), 0).w;
  float shown = texelFetch(strands, ivec2(1, strand), 0).w;
  float length_ = grown * (1.0 - 0.8 * chance * (1.0 - grown)); // no two are cut alike
  float metres = texelFetch(strands, ivec2(2, strand), 0).w;
  float thin = clamp(shown * 1.5 - 0.5 * chanceOf(0u), 0.0, 1.0) * smoothstep(0.0, 0.5, length_);
#ifdef DETAIL
  bool isDown = fullness < 0.0;
  if (isDown) length_ = min(length_, DOWN_LONG * (0.5 + chance) / metres);
#ifdef STRANDS
  thin *= max(fullness, 0.0); // down casts no shadow
#else
  thin *= isDown ? DOWN_FINE : fullness;
#endif
#else
  thin *= fullness;
#endif
  thin *= min(1.0, SLENDER * length_ * metres / width); // what is short is fine: a wide ribbon would lie there like a chip
  if (thin <= 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // nothing to draw
    return;
  }
#ifdef DETAIL
  length_ *= 1.0 - 0.1 * chanceOf(3u);
  float stray = smoothstep(STRAY, 1.0, chanceOf(7u)); // a few hairs go their own way
  thin *= stray > 0.0 ? 0.3 : 1.0;
#endif
  float at = place.y * length_ * (stations - 1.0);
  int here = int(min(at, stations - 2.0));
  vec3 before = texelFetch(strands, ivec2(max(here - 1, 0), strand), 0).xyz;
  vec3 from = texelFetch(strands, ivec2(here, strand), 0).xyz;
  vec3 to = texelFetch(strands, ivec2(here + 1, strand), 0).xyz;
#ifdef DETAIL
  float part = at - float(here);
  vec3 after = texelFetch(strands, ivec2(min(here + 2, int(stations) - 1), strand), 0).xyz;
  if (here == 0) before = 2.0 * from - to; // it begins and ends at stations
  if (here + 2 >= int(stations)) after = 2.0 * to - from;
  vec4 facing = mix(
    texelFetch(shape, ivec2(here, strand), 0), texelFetch(shape, ivec2(here + 1, strand), 0), part);
  vec3 spot = coursed(before, from, to, after, part);
  vec3 along = normalize(heading(before, from, to, after, part));
#else
  vec4 facing = texelFetch(shape, ivec2(int(at + 0.5), strand), 0);
  vec3 spot = mix(from, to, at - float(here));
  vec3 along = normalize(to - before);
#endif
  vec3 away = normalize(facing.xyz * 2.0 - 1.0);
  vec3 aside = normalize(cross(along, away));
  away = cross(aside, along);
  aside = normalize(aside + roll * away);
#ifdef DETAIL
  if (isDown) spot += DOWN_APART * ((2.0 * chanceOf(4u) - 1.0) * aside - 0.5 * chanceOf(5u) * along + 0.12 * place.y * (2.0 * chanceOf(6u) - 1.0) * aside);
  // Ribbons of one strand part in the skin: from one root they would come in tufts, with a kink where they spread
  float apart = isDown ? 0.0 : KIN_APART * width * (1.0 + 0.3 * sin(5.0 * place.y + 6.3 * chance));
  spot += apart * (mix(0.7, 1.0, smoothstep(0.0, 0.4, place.y)) * (chanceOf(4u) - 0.5) * aside + 0.4 * smoothstep(0.0, 0.3, place.y) * chanceOf(5u) * away);
  float loose = min(0.13 * length_ * metres, 0.011) * stray * place.y * place.y;
  spot += loose * ((0.3 + chanceOf(4u)) * away + 1.6 * (chance - 0.5) * aside);
#endif
  float end = place.y * place.y;
  thin *= 1.0 - 0.3 * end;
#ifdef DETAIL
  thin *= 1.0 - 0.6 * end * end; // fibres end one by one before
#else
  thin *= 1.0 - 0.85 * end * smoothstep(1.0, 0.6, grown); // hair that comes or goes ends in points: cut across it is slats
#endif
  float half_ = width * thin;
#ifdef DETAIL
  thin *= mix(0.45, 1.0, smoothstep(0.0, 0.2, place.y)); // out of the skin finely
#else
  thin *= mix(0.6, 1.0, smoothstep(0.0, 0.25, place.y));
#endif
  vec3 swung = HANGS * min(1.0, length_ * metres / LONG) * place.y * place.y * cross(swing, spot);
  swung -= 0.8 * min(dot(swung, away), 0.0) * away; // not into the head
  spot = length(spot) * normalize(spot + swung + 1e-7);
#ifdef FIGURE
  vec3 point = fetchRow(figurePositions) + headTurn * spot; // its root stays on a neck that bends
#else
  vec3 point = turned(fetchRow(positions) + spot, 1.0);
#endif
  along = headTurn * along;
  float open = facing.w * mix(0.45, 1.0, smoothstep(0.0, 0.22, place.y));
  vec3 view = viewPoint - point;
  vec3 beside = normalize(cross(along, view));
  aside = headTurn * aside;
  if (dot(aside, beside) < 0.0) aside = -aside; // a ribbon that shows its other side further on has no waist there
  vec3 normal = normalize(headTurn * away + 0.55 * place.x * aside);
  float wide = pixel * length(view);
  float pixels = width * thin * dot(aside, beside) / wide;
  point += place.x * (aside * width * thin + beside * wide * max(NARROWEST - pixels, OVERLAP));
  vec3 within = vec3(place.x * clamp(pixels / NARROWEST - 1.0, 0.0, 1.0), place.y, width * thin / FIBRE); // a line has no edges
#ifdef DETAIL
  float bare = 0.16 * end;
  bare += 0.3 * smoothstep(0.1, 0.0, place.y); // and come out of the skin one by one
  if (isDown) bare = 0.5; // half of it is seen through
#else
  float bare = 0.34 * end + 0.9 * smoothstep(0.86, 1.06, place.y + 0.12 * chance * end);
#endif
  float left = 4.0 * (half_ / (NARROWEST * wide) - SCARCE * chance);
  vec2 cover = vec2(min(left, 0.5 - bare), clamp(PARTED / wide - 1.0, 0.0, 1.0));
  vec2 chances = vec2(chance, chanceOf(6u));
#ifdef FAST
  HairFall light = hairFall(point, normal, along, open, 1.0);
  vec3 sheen, glow;
  sheens(light.rim, light.halves, light.facing, open, 0.2 * (chances.y - 0.5), sheen, glow);
  vFibre = vec4(chances.x * 7.3 + within.x * within.z / 256.0, chances.y + within.y * 0.0025, cover);
  vDiffuse = vec4((0.72 + 0.56 * chances.x) * (light.diffuse + 0.8 * glow), within.x);
  vSheen = sheen + 0.4 * glow;
#else
  vPlace = within;
  vCover = cover;
  vChance = chances;
  HairFall light = hairFall(point, normal, along, open, shadow(point, normal));
  vDiffuse = light.diffuse;
  vRim = light.rim;
  vHalves = light.halves;
  vFacing = vec2(light.facing, open);
#endif
#ifdef DETAIL
  vSway = 0.010 * (textureLod(grain, vChance.yx * vec2(1.0, 7.3) + vec2(0.0, place.y * 0.010), 0.0).b - 0.5);
#endif
  gl_Position = project(point);
}
`;

export const HAIR_FRAGMENT = `${FRAGMENT_HEAD}${HAIR_LIGHT}
uniform sampler2D grain;
uniform vec3 tint;
#ifdef FAST
in vec4 vFibre;
in vec4 vDiffuse;
in vec3 vSheen;
#else
in vec3 vPlace;
in vec2 vChance, vCover;
in vec3 vDiffuse;
in vec3 vRim;
in vec4 vHalves;
in vec2 vFacing;
#endif
#ifdef DETAIL
in float vSway;
#endif

#ifdef DETAIL
#define EDGE 0.22 // of the fibres, that the edges of a ribbon lack
#define SOFTEST 0.2 // of the fibres, over which what covers falls off at least
#else
#define EDGE 0.30
#define SOFTEST 0.1
#endif
#define FADES 0.34 // of a ribbon, along which a fibre ends

#ifdef FAST
void main() {
  vec4 fibre = texture(grain, vFibre.xy);
  float edge = vDiffuse.w * vDiffuse.w;
  if (vFibre.z + vFibre.w * (fibre.r - 0.5) - EDGE * edge * edge <= 0.0) discard;
  vec3 albedo = tint * (0.25 + 1.5 * fibre.r);
  colour = vec4(display(albedo * vDiffuse.rgb + (0.12 + 0.25 * albedo) * (0.4 + 1.2 * fibre.g) * vSheen), 1.0);
}
#else
void main() {
  // A ribbon is a bundle: fibres as wide on every ribbon, that sway along it, and single hairs within them.
  vec2 start = vec2(vChance.x * 7.3, vChance.y);
  float aside = vPlace.x * vPlace.z / 256.0; // the noise has so many cells
#ifdef DETAIL
  vec4 fibre = texture(grain, start + vec2(aside + vSway, vPlace.y * 0.008));
  fibre.rg = clamp(fibre.rg + 0.7 * (texture(grain, start.yx + vec2(2.8 * aside + vSway, vPlace.y * 0.012)).rg - 0.5), 0.0, 1.0);
#else
  vec4 fibre = texture(grain, start + vec2(aside, vPlace.y * 0.0025));
#endif
  // Fibres end one after the other, at the edges and at the tip; all at once where a pixel is wider than they are.
  float edge = vPlace.x * vPlace.x;
  float cover = vCover.x + vCover.y * (fibre.r - 0.5) - EDGE * edge * edge;
#ifdef SOFT
  cover -= 0.12 * vCover.y; // and leave gaps; with one sample a pixel those are dots of skin
  cover = clamp(cover / max(fwidth(cover), SOFTEST) + 0.5, 0.0, 1.0);
  cover *= 1.0 - smoothstep(0.0, FADES, vPlace.y - 0.62 - 0.5 * (fibre.r - 0.35)); // each fibre fades out by itself
#endif
  if (cover <= 0.0) discard;
  vec3 sheen, glow;
  sheens(vRim, vHalves, vFacing.x, vFacing.y, 0.5 * (fibre.g - 0.5) + 0.1 * (vChance.y - 0.5), sheen, glow);
#ifdef DETAIL
  vec3 albedo = tint * (0.88 + 0.3 * vChance.x) * (0.22 + 1.5 * fibre.r) * mix(0.62, 1.12, vPlace.y);
  albedo *= mix(vec3(1.10, 0.98, 0.86), vec3(0.92, 1.02, 1.12), fract(vChance.y * 0.35 + 0.8 * fibre.g)); // no two of one hue
#else
  vec3 albedo = tint * (0.72 + 0.56 * vChance.x) * (0.25 + 1.5 * fibre.r);
#endif
  vec3 seen = albedo * vDiffuse;
  seen += (0.12 + 0.25 * albedo) * sheen * (0.4 + 1.2 * fibre.g) + (0.02 + 0.9 * albedo) * glow;
#ifdef SOFT
  colour = vec4(display(seen), cover);
#else
  colour = vec4(display(seen), 1.0);
#endif
}
#endif
`;
