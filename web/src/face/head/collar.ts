/** The collar around the neck, which stays when the head turns. */

import * as THREE from "three";
import type { Anatomy } from "../anatomy/anatomy";
import { FRAGMENT_HEAD, VERTEX_HEAD } from "../light/shader_prelude";

/** The collar's profile from the neck outwards: metres out, metres up, light. */
const PROFILE: readonly (readonly [number, number, number])[] = [
  [-0.004, 0.002, 0.3],
  [0.001, 0.009, 0.8],
  [0.005, 0.009, 1],
  [0.008, 0.004, 1],
  [0.009, -0.012, 1],
  [0.013, -0.03, 0.9],
  [0.04, -0.045, 0.7],
  [0.09, -0.06, 0.45],
  [0.16, -0.1, 0.15],
  [0.2, -0.18, 0],
];

/** A turtleneck around the neck's rim, as rings of offsets from the rim's rows; it follows every neck. */
export function collar(anatomy: Anatomy): THREE.BufferGeometry {
  const { rim, positions } = anatomy;
  const outwards = rim.map((row) => outward(anatomy, row));
  const [source, offset, fade, index]: [number[], number[], number[], number[]] = [[], [], [], []];
  PROFILE.forEach(([out, up, light], ring) => {
    rim.forEach((row, place) => {
      const [ox, oz] = outwards[place] as [number, number];
      const level = levelOfRim(rim, positions) - (positions[3 * row + 1] as number);
      source.push(row);
      offset.push(ox * out * 1.15, up + level * Math.min(1, ring / 6), oz * out * 0.8);
      fade.push(light);
      if (ring === 0) return;
      const [a, b] = [ring * rim.length + place, ring * rim.length + ((place + 1) % rim.length)];
      index.push(a, b - rim.length, a - rim.length, a, b, b - rim.length);
    });
  });
  return assemble(source, offset, fade, index, positions);
}

function levelOfRim(rim: readonly number[], positions: Float32Array): number {
  return rim.reduce((sum, row) => sum + (positions[3 * row + 1] as number), 0) / rim.length;
}

/** The horizontal direction away from the middle of the rim. */
function outward(anatomy: Anatomy, row: number): [number, number] {
  const { rim, positions } = anatomy;
  const mean = (axis: number) =>
    rim.reduce((sum, other) => sum + (positions[3 * other + axis] as number), 0) / rim.length;
  const [x, z] = [(positions[3 * row] as number) - mean(0), (positions[3 * row + 2] as number) - mean(2)];
  const length = Math.hypot(x, z);
  return [x / length, z / length];
}

function assemble(
  source: number[],
  offset: number[],
  fade: number[],
  index: number[],
  positions: Float32Array,
): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  const points = source.flatMap((row, at) =>
    [0, 1, 2].map((axis) => (positions[3 * row + axis] as number) + (offset[3 * at + axis] as number)),
  );
  geometry.setIndex(index);
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
  geometry.computeVertexNormals();
  const facing = geometry.getAttribute("normal") as THREE.BufferAttribute;
  geometry.deleteAttribute("position").deleteAttribute("normal");
  geometry.setAttribute("source", new THREE.Float32BufferAttribute(source, 1));
  geometry.setAttribute("offset", new THREE.Float32BufferAttribute(offset, 3));
  geometry.setAttribute("fade", new THREE.Float32BufferAttribute(fade, 1));
  geometry.setAttribute("facing", facing);
  return geometry;
}

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
