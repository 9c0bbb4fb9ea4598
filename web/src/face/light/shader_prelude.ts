/** What the shaders of the head begin with: transforms, light, tone. */

import { ROW_SHIFT, ROW_WIDTH } from "../gpu/pass_shaders";
import { NO_SHADOW, SHADOW } from "./shadow_shaders";
import { TONE } from "./tone";

/** What every vertex shader of the head shares: its row's blended position and normal, turned with the head. */
export const VERTEX_HEAD = `
precision highp float;
precision highp int;
precision highp sampler2D;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
uniform sampler2D positions;
uniform sampler2D normals;
uniform mat3 headTurn;
uniform vec3 pivot;
uniform vec3 headPlace; // where the pivot is: a body carries it
#ifdef FIGURE
uniform sampler2D figurePositions; // of skin and body, as the figure is posed
uniform sampler2D figureNormals;
#endif
in float source;

ivec2 texelOf(int row) { return ivec2(row & ${ROW_WIDTH - 1}, row >> ${ROW_SHIFT}); }
vec3 fetchRow(sampler2D rows) { return texelFetch(rows, texelOf(int(source + 0.5)), 0).xyz; }
vec3 rowAt(int row) { return texelFetch(positions, texelOf(row), 0).xyz; }
vec3 turned(vec3 point, float part) { return mix(point, headPlace + headTurn * (point - pivot), part); }
vec3 turnedNormal(vec3 normal, float part) { return normalize(mix(normal, headTurn * normal, part)); }
vec4 project(vec3 point) { return projectionMatrix * modelViewMatrix * vec4(point, 1.0); }
`;

/**
 * The light on stage, the same for every shader of the head (`light_uniforms.ts` writes it): a key, a fill, two rims,
 * and what comes from everywhere. SHADE: how much hollows count, 0 in even light; whoever darkens a hollow uses `shaded`.
 */
const LAMPS = `
uniform vec3 viewPoint; // the camera, in the head's own metres
uniform vec3 KEY;
uniform vec3 FILL;
uniform vec3 RIM_LEFT;
uniform vec3 RIM_RIGHT;
uniform vec3 KEY_LIGHT;
uniform vec3 FILL_LIGHT;
uniform vec3 RIM_LIGHT;
uniform vec3 SKY_LIGHT;
uniform vec3 GROUND_LIGHT;
uniform float SHADE;

/** Light from everywhere. */
vec3 ambient(vec3 normal) { return mix(GROUND_LIGHT, SKY_LIGHT, normal.y * 0.5 + 0.5); }

/** What a hollow leaves of the light (0..1), as much as this light counts it. */
float shaded(float open) { return mix(1.0, open, SHADE); }

/** A lobe of shine. */
float shine(vec3 normal, vec3 view, vec3 light, float sharpness) {
  return pow(max(dot(normal, normalize(light + view)), 0.0), sharpness);
}
`;

/** The light for vertex shaders: without cast shadows. */
export const LIGHTS = `${LAMPS}${NO_SHADOW}`;

/** The light for vertex shaders that find the cast shadow of each vertex; SPIN: how the samples are turned, 0..1. */
export const SHADED_LIGHTS = `${LAMPS}${SHADOW}`;

export const FRAGMENT_HEAD = `
precision highp float;
precision highp sampler2D;
${LAMPS}${SHADOW}
out vec4 colour;
${TONE}
vec4 premultiplied(vec3 light, float alpha) { return vec4(display(light) * alpha, alpha); }
`;
