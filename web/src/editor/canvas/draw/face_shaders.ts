/** How the editor draws a face: clay in the face's own skin, lit from where one looks, cheap enough for eleven at once. */

import { ROW_SHIFT, ROW_WIDTH } from "../../../face/gpu/pass_shaders";

const ROWS = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D positions;
uniform sampler2D normals;
uniform mat4 matrix;
uniform int top; // the face's first line in the atlas
ivec2 texel(int row) { return ivec2(row & ${ROW_WIDTH - 1}, top + (row >> ${ROW_SHIFT})); }
`;

/** Light that goes with the camera: a key from the upper left, a soft fill, and an edge from behind. */
const LIGHT = `
precision highp float;
uniform vec3 right;
uniform vec3 up;
uniform vec3 back;

vec3 lit(vec3 albedo, vec3 normal, float gloss) {
  vec3 n = vec3(dot(normal, right), dot(normal, up), dot(normal, back)); // in the camera's axes
  const vec3 KEY = vec3(-0.46, 0.56, 0.69);
  const vec3 HALF = vec3(-0.25, 0.305, 0.919);
  vec3 key = clamp((vec3(dot(n, KEY)) + vec3(0.26, 0.16, 0.12)) / vec3(1.26, 1.16, 1.12), 0.0, 1.0);
  float fill = clamp(dot(n, vec3(0.78, 0.05, 0.62)), 0.0, 1.0);
  vec3 around = mix(vec3(0.17, 0.135, 0.12), vec3(0.27, 0.28, 0.31), n.y * 0.5 + 0.5);
  float edge = 1.0 - clamp(n.z, 0.0, 1.0);
  edge *= edge;
  vec3 light = key * vec3(1.10, 1.03, 0.95) + fill * vec3(0.20, 0.22, 0.26) + around;
  float shine = max(dot(n, HALF), 0.0);
  shine *= shine; shine *= shine; shine *= shine; shine *= shine; // 16
  return albedo * light + (0.04 + 0.10 * gloss) * shine * (1.0 + 2.0 * shine) + (0.10 + 0.5 * albedo) * edge * edge * vec3(0.42, 0.47, 0.55);
}

/** Linear light to the display: a shoulder, then square roots for the sRGB curve. */
vec3 shown(vec3 light) {
  vec3 x = light * (1.0 + light * 0.12) / (1.0 + light * 0.42);
  vec3 root = sqrt(clamp(x, 0.0, 1.0));
  return root * (0.94 + 0.06 * root);
}
`;

/**
 * Skin, teeth and tongue: \`tint\` paints what is no skin (its alpha: how much). What stands in the mouth is as light as
 * the lips before it are open (as on stage, by one place of them instead of all); between closed ones it is their wet dark red.
 */
export const SKIN_VERTEX = `${ROWS}
in uint row;
in uint upperRow; // of the lips before it
in uint lowerRow;
in vec2 uv;
in vec4 tint;
const vec3 SEAM = vec3(0.05, 0.012, 0.01);

vec3 inMouth(vec3 colour, vec3 here) {
  vec3 upper = texelFetch(positions, texel(int(upperRow)), 0).xyz;
  vec3 lower = texelFetch(positions, texel(int(lowerRow)), 0).xyz;
  float high = max(upper.y - lower.y, 0.0);
  float deep = max(0.5 * (upper.z + lower.z) - here.z, 0.0);
  float area = 0.06 * high; // metres times metres: mouths are some 5 cm wide
  float sky = area / (area + deep * deep + 1e-5); // lamps shine straight in too
  return mix(SEAM, colour * sky, smoothstep(0.0, 0.004, high));
}
out vec2 vUv;
out vec3 vNormal;
out vec4 vTint;
void main() {
  vUv = uv;
  ivec2 at = texel(int(row));
  vec3 place = texelFetch(positions, at, 0).xyz;
  vTint = tint;
  if (tint.a > 0.0) vTint.rgb = inMouth(tint.rgb, place);
  vNormal = texelFetch(normals, at, 0).xyz;
  gl_Position = matrix * vec4(place, 1.0);
}
`;

export const SKIN_FRAGMENT = `#version 300 es
${LIGHT}
uniform sampler2D skinTexture;
in vec2 vUv;
in vec3 vNormal;
in vec4 vTint;
out vec4 colour;
void main() {
  vec4 painted = texture(skinTexture, vUv);
  vec3 albedo = mix(painted.rgb * painted.rgb, vTint.rgb, vTint.a);
  colour = vec4(shown(lit(albedo, normalize(vNormal), painted.a)), 1.0);
}
`;

/** An eyeball on the axes of the cast's ball, turned by its angles about its centre. */
export const EYE_VERTEX = `#version 300 es
precision highp float;
uniform mat4 matrix;
uniform vec3 centre;
uniform mat3 axes;
in vec3 direction;
out vec3 vLocal;
out vec3 vNormal;
void main() {
  vLocal = direction;
  vNormal = axes * direction;
  gl_Position = matrix * vec4(centre + vNormal * 0.985, 1.0);
}
`;

export const EYE_FRAGMENT = `#version 300 es
${LIGHT}
uniform vec3 iris;
uniform vec3 white;
uniform float irisSize;
uniform float slit;
uniform float pupil;
in vec3 vLocal;
in vec3 vNormal;
out vec4 colour;

/** 1 at the pupil's edge, less inside: a circle, an upright lens, or what lies between (as on stage). */
float pupilAt(vec2 place, float size) {
  float across = mix(size, 0.07 + 0.22 * size + 1.5 * max(size - 0.36, 0.0), slit);
  float along = mix(size, max(0.86, size), slit);
  vec2 share = place / vec2(across, along);
  return mix(length(share), abs(share.x) + share.y * share.y, slit);
}

void main() {
  vec3 local = normalize(vLocal);
  vec2 place = local.xy / (0.42 * irisSize);
  float off = local.z > 0.0 ? length(place) : 9.0;
  float blur = fwidth(off);
  float hole = pupilAt(place, clamp(0.38 + (pupil > 0.0 ? 0.27 : 0.19) * pupil, 0.15, 0.68));
  vec3 tone = iris * mix(1.35, 0.7, smoothstep(0.3, 1.0, off)) + 0.012;
  tone *= 1.0 - 0.8 * smoothstep(0.74, 1.0, off);
  tone *= smoothstep(1.0 - blur - 0.06, 1.0 + blur + 0.06, hole);
  vec3 albedo = mix(tone, white * (1.0 - 0.35 * smoothstep(1.2, 2.6, off)), smoothstep(1.0 - blur, 1.0 + blur, off));
  vec3 normal = normalize(vNormal);
  vec3 light = lit(albedo, normal, 0.0) * mix(1.0, 0.72, smoothstep(-0.05, 0.6, local.y)); // the lid's shade
  vec3 n = vec3(dot(normal, right), dot(normal, up), dot(normal, back));
  float glint = max(dot(n, normalize(vec3(-0.25, 0.33, 0.91))), 0.0);
  colour = vec4(shown(light) + vec3(0.9) * smoothstep(0.985, 0.993, glint), 1.0);
}
`;

/** Lines over the skin: edges of the mesh, muscles. \`lift\`: metres off the skin. */
export const LINE_VERTEX = `${ROWS}
uniform float lift;
in uint row;
in vec4 colour;
out vec4 vColour;
void main() {
  ivec2 at = texel(int(row));
  vColour = colour;
  gl_Position = matrix * vec4(texelFetch(positions, at, 0).xyz + lift * texelFetch(normals, at, 0).xyz, 1.0);
}
`;

export const LINE_FRAGMENT = `#version 300 es
precision highp float;
in vec4 vColour;
out vec4 colour;
void main() { colour = vColour; }
`;

/** A needle: a shaft out of the skin and a head on it; corners 0..3 the shaft's, 4..7 the head's. */
export const NEEDLE_VERTEX = `${ROWS}
uniform vec2 box; // of the picture, pixels
uniform float long_; // metres
uniform float wide; // pixels of a head's radius
uniform float slack; // metres by which skin may lie before a needle
uniform vec3 back;
in uint row;
in vec3 outward; // zero: as the skin points
in vec4 colour;
in float scale;
out vec4 vColour;
out vec2 vDisc;
void main() {
  ivec2 at = texel(int(row));
  vec3 foot = texelFetch(positions, at, 0).xyz;
  vec3 way = dot(outward, outward) > 0.0 ? outward : texelFetch(normals, at, 0).xyz;
  vec3 tip = foot + long_ * way;
  vec4 a = matrix * vec4(foot, 1.0), b = matrix * vec4(tip, 1.0);
  int corner = gl_VertexID;
  vec2 side = vec2((corner & 1) * 2 - 1, ((corner >> 1) & 1) * 2 - 1);
  vColour = colour;
  if (corner < 4) {
    vec2 along = (b.xy / b.w - a.xy / a.w) * box;
    vec2 across = normalize(vec2(-along.y, along.x) + vec2(1e-6, 0.0));
    gl_Position = side.y < 0.0 ? a : b;
    gl_Position.xy += across * side.x * 1.6 * gl_Position.w / box;
    vColour.rgb *= 0.7;
    vDisc = vec2(0.0);
  } else {
    gl_Position = b;
    gl_Position.xy += side * 2.0 * wide * scale * b.w / box;
    vDisc = side;
  }
  vec4 nearer = matrix * vec4((corner < 4 && side.y < 0.0 ? foot : tip) + slack * back, 1.0);
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
}
`;

export const NEEDLE_FRAGMENT = `#version 300 es
precision highp float;
in vec4 vColour;
in vec2 vDisc;
out vec4 colour;
void main() {
  float out_ = dot(vDisc, vDisc);
  if (out_ > 1.0) discard;
  float glance = max(0.0, 1.0 - 1.3 * dot(vDisc - vec2(-0.35, 0.4), vDisc - vec2(-0.35, 0.4)));
  vec3 seen = vColour.rgb * (1.0 - 0.45 * out_) + 0.35 * glance * glance;
  colour = vec4(mix(seen, seen * 0.25, smoothstep(0.62, 0.95, out_)), vColour.a);
}
`;
