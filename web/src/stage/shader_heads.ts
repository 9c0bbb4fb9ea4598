import { ROW_SHIFT, ROW_WIDTH } from "./pass_shaders";

/** What every vertex shader of the head shares: its row's blended position and normal, turned with the head. */
export const VERTEX_HEAD = `
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
export const LIGHTS = `
uniform vec3 cameraPosition;

const vec3 KEY = normalize(vec3(-0.68, 0.62, 0.66));
const vec3 FILL = normalize(vec3(0.85, 0.0, 0.5));
const vec3 RIM_LEFT = normalize(vec3(-0.9, 0.25, -0.45));
const vec3 RIM_RIGHT = normalize(vec3(0.9, 0.35, -0.5));
const vec3 KEY_LIGHT = vec3(1.72, 1.52, 1.34);
const vec3 FILL_LIGHT = vec3(0.25, 0.24, 0.27);
const vec3 RIM_LIGHT = vec3(0.62, 0.70, 0.90);

/** A lobe of shine. */
float shine(vec3 normal, vec3 view, vec3 light, float sharpness) {
  return pow(max(dot(normal, normalize(light + view)), 0.0), sharpness);
}
`;

export const FRAGMENT_HEAD = `
precision highp float;
precision highp sampler2D;
${LIGHTS}
out vec4 colour;

/** Linear light to the display, with a shoulder for the highlights. */
vec3 display(vec3 light) {
  vec3 x = max(light, 0.0);
  x = x * (1.0 + x * 0.12) / (1.0 + x * 0.72);
  vec3 root = sqrt(x); // the sRGB curve by square roots: no logarithms on a software renderer
  vec3 fourth = sqrt(root);
  return 0.585122381 * root + 0.783140355 * fourth - 0.368262736 * sqrt(fourth);
}
vec4 premultiplied(vec3 light, float alpha) { return vec4(display(light) * alpha, alpha); }
`;
