/** The collar around the neck, which stays when the head turns. */

import * as THREE from "three";
import type { Anatomy } from "../anatomy/anatomy";
import { FRAGMENT_HEAD, VERTEX_HEAD } from "../light/shader_prelude";

/** How far down the black figure below a collar reaches, metres: below the picture of a whole row of characters. */
export const FEET = -3;

/** The collar's profile from the neck outwards and down: metres out, metres up, light. */
const PROFILE: readonly (readonly [number, number, number])[] = [
  [-0.009, 0.004, 0.2],
  [-0.003, 0.014, 0.6],
  [0.002, 0.018, 0.9],
  [0.006, 0.016, 1],
  [0.009, 0.008, 1],
  [0.01, -0.012, 1],
  [0.014, -0.03, 0.9],
  [0.04, -0.045, 0.7],
  [0.09, -0.06, 0.45],
  [0.16, -0.1, 0.15],
  [0.2, -0.18, 0],
  [0.212, -0.24, 0],
  [0.216, -0.32, 0],
  [0.216, FEET, 0],
];
/** Places around the neck, near and far from what the machine can do. */
const [FINE, COARSE] = [48, 32];
/** How far along the rim its radius is averaged: the concentration of a von Mises distribution. */
const CONCENTRATION = 8;

/** A point (metres), in polar coordinates about the neck's middle: 0 straight ahead, then to the left. */
interface Polar {
  readonly angle: number;
  readonly radius: number;
}

/** The neck's rim as a ring: its middle (metres), and its rows in polar coordinates. */
interface Neck {
  readonly middle: readonly [number, number, number];
  readonly polar: readonly Polar[];
}

/**
 * A turtleneck around the neck, as rings of points. The rim of a scanned neck is ragged, so no ring follows it row by row:
 * four of its rows (front, left, back, right) carry an ellipse (an affine map of the circle), which is smooth on every
 * face, and `offset` leads from that of the generic face to its averaged rim.
 */
export function collar(anatomy: Anatomy, fast = false): THREE.BufferGeometry {
  const columns = fast ? COARSE : FINE;
  const { rim, positions } = anatomy;
  const neck = measureNeck(rim, positions);
  const anchors = [0, 1, 2, 3].map((quarter) => rim[nearest(neck, (quarter * Math.PI) / 2)] as number);
  const [points, offset, shares, fade]: [number[], number[], number[], number[]] = [[], [], [], []];
  for (const [out, up, light] of PROFILE)
    for (let column = 0; column < columns; column++) {
      const angle = (2 * Math.PI * column) / columns;
      const weights = anchors.map((_, quarter) => 0.25 + 0.5 * Math.cos(angle - (quarter * Math.PI) / 2));
      const point = pointOf(neck, angle, out, up);
      points.push(...point);
      offset.push(...point.map((value, axis) => value - carried(anchors, weights, positions, axis)));
      shares.push(...weights);
      fade.push(light);
    }
  return assemble({ points, offset, shares, fade }, anchors, columns);
}

function measureNeck(rim: readonly number[], positions: Float32Array): Neck {
  const values = (axis: number) => rim.map((row) => positions[3 * row + axis] as number);
  const [x, y, z] = [values(0), values(1), values(2)];
  const depth = (Math.min(...z) + Math.max(...z)) / 2;
  const polar = x.map((across, at) => {
    const ahead = (z[at] as number) - depth;
    return { angle: Math.atan2(across, ahead), radius: Math.hypot(across, ahead) };
  });
  return { middle: [0, y.reduce((sum, value) => sum + value, 0) / y.length, depth], polar };
}

/** The place in the rim that lies nearest to an angle. */
function nearest({ polar }: Neck, angle: number): number {
  const near = polar.map((at) => Math.cos(at.angle - angle));
  return near.indexOf(Math.max(...near));
}

/** A point of the profile at an angle, on the generic face, metres. */
function pointOf({ middle, polar }: Neck, angle: number, out: number, up: number): [number, number, number] {
  let [sum, whole] = [0, 0];
  for (const at of polar) {
    const near = Math.exp(CONCENTRATION * (Math.cos(at.angle - angle) - 1));
    sum += near * at.radius;
    whole += near;
  }
  const [across, ahead] = [Math.sin(angle), Math.cos(angle)];
  const radius = sum / whole;
  return [across * (radius + 1.15 * out), middle[1] + up, middle[2] + ahead * (radius + 0.8 * out)];
}

/** What the anchors carry to a place of the ring, on the generic face. */
function carried(
  anchors: readonly number[],
  weights: readonly number[],
  positions: Float32Array,
  axis: number,
): number {
  return weights.reduce(
    (sum, weight, at) => sum + weight * (positions[3 * (anchors[at] as number) + axis] as number),
    0,
  );
}

/** Quads between neighbouring rings, as triangles that face outwards. */
function ringTriangles(columns: number): number[] {
  return Array.from({ length: (PROFILE.length - 1) * columns }, (_, at) => {
    const [inner, column] = [Math.floor(at / columns) * columns, at % columns];
    const [a, b] = [inner + column, inner + ((column + 1) % columns)];
    return [a + columns, b, a, a + columns, b + columns, b];
  }).flat();
}

interface Rings {
  readonly points: number[];
  readonly offset: number[];
  readonly shares: number[];
  readonly fade: number[];
}

function assemble(
  { points, offset, shares, fade }: Rings,
  anchors: readonly number[],
  columns: number,
): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(ringTriangles(columns));
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
  geometry.computeVertexNormals();
  const facing = geometry.getAttribute("normal") as THREE.BufferAttribute;
  geometry.deleteAttribute("position").deleteAttribute("normal");
  const rows = fade.flatMap(() => anchors);
  geometry.setAttribute("anchors", new THREE.Float32BufferAttribute(rows, 4));
  geometry.setAttribute("shares", new THREE.Float32BufferAttribute(shares, 4));
  geometry.setAttribute("offset", new THREE.Float32BufferAttribute(offset, 3));
  geometry.setAttribute("fade", new THREE.Float32BufferAttribute(fade, 1));
  geometry.setAttribute("facing", facing);
  return geometry;
}

/** How far in front of it skin is covered, metres: a throat that turns swings its rim out over the cloth. */
const COVERS = 0.02;

/**
 * The collar: a roll of dark cloth around the neck that widens into shoulders; it stays when the head turns. It has the
 * depth of what lies before it, towards the eye, so that a rim that swings out stays under it; at the shoulders less.
 */
export const COLLAR_VERTEX = `${VERTEX_HEAD}
in vec4 anchors; // rows of the neck's rim: front, left, back, right
in vec4 shares;
in vec3 offset;
in vec3 facing;
in float fade;
out vec3 vPoint;
out vec3 vNormal;
out float vFade;

void main() {
  ivec4 rows = ivec4(anchors + 0.5);
  vPoint = offset + shares.x * rowAt(rows.x) + shares.y * rowAt(rows.y) + shares.z * rowAt(rows.z) + shares.w * rowAt(rows.w);
  vNormal = facing;
  vFade = fade;
  vec4 seen = modelViewMatrix * vec4(vPoint, 1.0);
  seen.xyz *= 1.0 - ${COVERS} * fade / length(seen.xyz); // along its ray: it is seen where it is
  gl_Position = projectionMatrix * seen;
}
`;

export const COLLAR_FRAGMENT = `${FRAGMENT_HEAD}
in vec3 vPoint;
in vec3 vNormal;
in float vFade;

void main() {
  vec3 view = normalize(viewPoint - vPoint);
  vec3 normal = normalize(vNormal);
  float edge = pow(1.0 - max(dot(normal, view), 0.0), 2.5);
  vec3 cloth = vec3(0.0055, 0.0055, 0.0075);
  vec3 light = cloth * (KEY_LIGHT * max(dot(normal, KEY), 0.0) * shadow(vPoint, normal) + FILL_LIGHT + ambient(normal));
  light += RIM_LIGHT * edge * 0.06 * (max(dot(normal, RIM_LEFT), 0.0) + max(dot(normal, RIM_RIGHT), 0.0));
  colour = premultiplied(light * vFade, 1.0);
}
`;
