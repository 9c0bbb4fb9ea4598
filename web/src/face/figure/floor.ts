/** The floor under a figure: a pool of the key's light, and the soft shadow where its feet touch. */

import * as THREE from "three";
import { LAID_OVER, material, type Uniforms } from "../gpu/renderer";
import { FRAGMENT_HEAD } from "../light/shader_prelude";

/** Half a side of the floor that is drawn, metres. */
const WIDE = 1.6;

/** The feet that a shadow lies under: left heel and toe, then right ones, and the middle of the hips. */
export const CONTACTS = ["foot.L", "toes.L", "foot.R", "toes.R", "root"] as const;

/** What the floor's shader reads. */
export const floorUniforms = () => ({
  contacts: { value: CONTACTS.map(() => new THREE.Vector3()) },
  soles: { value: 0 },
  floorSeen: { value: 1 },
});

const FLOOR_VERTEX = `
precision highp float;
uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
uniform vec3 contacts[${CONTACTS.length}];
uniform float soles;
in vec3 position;
out vec3 vPoint;
void main() {
  vPoint = vec3(contacts[4].x + position.x, soles, contacts[4].z + position.z);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(vPoint, 1.0);
}
`;

const FLOOR_FRAGMENT = `${FRAGMENT_HEAD}
uniform vec3 contacts[${CONTACTS.length}];
uniform float soles;
uniform float floorSeen;
in vec3 vPoint;

/** How much of the sky a foot hides: less the higher it is. */
float hidden(vec3 heel, vec3 toe) {
  vec2 along = toe.xz - heel.xz + vec2(0.0, 1e-4);
  vec2 from = vPoint.xz - heel.xz;
  float part = clamp(dot(from, along) / dot(along, along), -0.25, 1.4);
  float wide = 0.055 + 0.8 * max(mix(heel.y, toe.y, clamp(part, 0.0, 1.0)) - soles - 0.09, 0.0);
  float far = length(from - part * along) / wide;
  return exp(-far * far) * 0.055 / wide;
}

void main() {
  vec2 from = vPoint.xz - contacts[4].xz;
  float pool = exp(-dot(from, from) * 1.6) * smoothstep(${WIDE.toFixed(1)}, 0.9, length(from));
  vec3 light = 0.018 * (KEY_LIGHT * max(KEY.y, 0.0) + ambient(vec3(0.0, 1.0, 0.0)));
  float dark = max(hidden(contacts[0], contacts[1]), hidden(contacts[2], contacts[3]));
  float body = 0.35 * exp(-dot(from, from) * 14.0);
  float open = (1.0 - 0.85 * dark) * (1.0 - body);
  colour = floorSeen * vec4(display(light) * pool * open, 1.0 - open);
}
`;

/** The floor under one figure; drawn when all else is. */
export function floor(uniforms: Uniforms): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  const corners = [-WIDE, 0, -WIDE, WIDE, 0, -WIDE, WIDE, 0, WIDE, -WIDE, 0, WIDE];
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
  geometry.setIndex([0, 2, 1, 0, 3, 2]);
  const look = Object.assign(material(FLOOR_VERTEX, FLOOR_FRAGMENT, uniforms), LAID_OVER, { depthWrite: false });
  const mesh = new THREE.Mesh(geometry, look);
  mesh.renderOrder = 0.6; // after the backdrop
  return mesh;
}
