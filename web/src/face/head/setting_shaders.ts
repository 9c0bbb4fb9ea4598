import { FRAGMENT_HEAD, VERTEX_HEAD } from "./shader_prelude";

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
  vec3 light = cloth * (KEY_LIGHT * max(dot(normal, KEY), 0.0) * shadow(vPoint, normal) + FILL_LIGHT + ambient(normal));
  light += RIM_LIGHT * edge * 0.06 * (max(dot(normal, RIM_LEFT), 0.0) + max(dot(normal, RIM_RIGHT), 0.0));
  colour = premultiplied(light * vFade, 1.0);
}
`;

/** The stage behind the head: one colour at the edge, one around the head, so that the silhouette reads. */
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
uniform vec3 edge;
uniform vec3 glow;
in vec2 vPlace;
out vec4 colour;
void main() {
  vec2 from = (vPlace - vec2(0.5, 0.58)) * vec2(aspect, 1.0);
  vec3 light = mix(edge, glow, exp(-dot(from, from) * 3.2));
  float dither = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  colour = vec4(light + 0.98 * dither / 255.0, 1.0);
}
`;
