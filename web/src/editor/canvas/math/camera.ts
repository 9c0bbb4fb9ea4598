/** The camera that goes around a head: where it stands, what a pixel sees. */

import { Matrix4, Vector3 } from "three";
import type { Box } from "./boxes";
import { add, cross, minus, type Pair, rowOf, type Triple, times, unit } from "./vectors";

/** Where the camera stands: yaw (+: over the character's left) and pitch (+: from above) in radians, `zoom` 1 shows the
 * whole head, `pan` metres to the right and up. */
export interface View {
  yaw: number;
  pitch: number;
  zoom: number;
  pan: Pair;
}

/** A ball that holds a head. */
export interface Bounds {
  centre: Triple;
  radius: number;
}

export type ViewName = "front" | "left" | "right" | "three_quarter_left" | "three_quarter_right";

/** The views that keys and buttons call; left is the character's left side. */
export const VIEWS: Readonly<Record<ViewName, Pair>> = {
  front: [0, 0],
  left: [Math.PI / 2, 0],
  right: [-Math.PI / 2, 0],
  three_quarter_left: [0.65, 0.06],
  three_quarter_right: [-0.65, 0.06],
};

export const FIRST_VIEW: Readonly<View> = { yaw: 0, pitch: 0, zoom: 1, pan: [0, 0] };

const LENS = Math.tan((9 * Math.PI) / 180); // half of a portrait's long lens, as on stage
const STEEPEST = 1.35;
const NEAREST_ZOOM = 14;
const ZOOM_OUT = 0.5;

/** A view within bounds: the head never stands upside down, and never leaves. */
export function bounded(view: View, reach: number): View {
  const aside = (part: number) => Math.max(-reach, Math.min(reach, part));
  return {
    yaw: Math.atan2(Math.sin(view.yaw), Math.cos(view.yaw)),
    pitch: Math.max(-STEEPEST, Math.min(STEEPEST, view.pitch)),
    zoom: Math.max(ZOOM_OUT, Math.min(NEAREST_ZOOM, view.zoom)),
    pan: [aside(view.pan[0]), aside(view.pan[1])],
  };
}

/** The ball around the points (n, 3). */
export function boundsOf(points: Float32Array): Bounds {
  const low: Triple = [Infinity, Infinity, Infinity];
  const high: Triple = [-Infinity, -Infinity, -Infinity];
  for (let row = 0; 3 * row < points.length; row++)
    rowOf(points, row).forEach((part, axis) => {
      low[axis] = Math.min(low[axis] as number, part);
      high[axis] = Math.max(high[axis] as number, part);
    });
  const centre = times(add(low, high), 0.5);
  return { centre, radius: Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2 };
}

/** A camera that shows a head in a box of the canvas. */
export class Camera {
  readonly eye: Triple;
  readonly right: Triple;
  readonly up: Triple;
  /** Towards the camera. */
  readonly back: Triple;
  /** From world to clip space, column by column. */
  readonly matrix: Float32Array;
  /** The same in two steps: from the world to the camera, from there to clip space. */
  readonly view: Matrix4;
  readonly projection: Matrix4;
  /** What the camera looks at. */
  readonly middle: Triple;
  private readonly far: number;

  constructor(
    view: View,
    readonly box: Box,
    bounds: Bounds,
  ) {
    const [cy, sy, cp, sp] = [Math.cos(view.yaw), Math.sin(view.yaw), Math.cos(view.pitch), Math.sin(view.pitch)];
    this.back = [sy * cp, sp, cy * cp];
    this.right = [cy, 0, -sy];
    this.up = cross(this.back, this.right);
    const aspect = box.width / Math.max(box.height, 1);
    this.far = (1.06 * bounds.radius) / (LENS * Math.min(1, aspect * 1.12) * view.zoom) + 0.4 * bounds.radius;
    this.middle = add(bounds.centre, add(times(this.right, view.pan[0]), times(this.up, view.pan[1])));
    this.eye = add(this.middle, times(this.back, this.far));
    this.projection = this.perspective(aspect, bounds.radius);
    this.view = this.viewMatrix();
    this.matrix = Float32Array.from(this.projection.clone().multiply(this.view).elements);
  }

  /** Where a point is on the canvas, CSS pixels, and how far in front of the camera, metres. */
  project(point: Readonly<Triple>): Triple {
    const m = this.matrix;
    const row = (n: number): number =>
      (m[n] as number) * point[0] +
      (m[4 + n] as number) * point[1] +
      (m[8 + n] as number) * point[2] +
      (m[12 + n] as number);
    const depth = row(3);
    const { left, top, width, height } = this.box;
    return [left + ((row(0) / depth + 1) / 2) * width, top + ((1 - row(1) / depth) / 2) * height, depth];
  }

  /** Where points (n, 3) are on the canvas, (n, 2) CSS pixels. */
  projectAll(points: Float32Array): Float32Array {
    const [m, { left, top, width, height }] = [this.matrix, this.box];
    const out = new Float32Array((points.length / 3) * 2);
    for (let at = 0, to = 0; at < points.length; at += 3, to += 2) {
      const [x, y, z] = [points[at] as number, points[at + 1] as number, points[at + 2] as number];
      const row = (n: number): number =>
        (m[n] as number) * x + (m[4 + n] as number) * y + (m[8 + n] as number) * z + (m[12 + n] as number);
      const depth = row(3);
      out[to] = left + ((row(0) / depth + 1) / 2) * width;
      out[to + 1] = top + ((1 - row(1) / depth) / 2) * height;
    }
    return out;
  }

  /** The direction in which a pixel of the canvas looks. */
  ray(x: number, y: number): Triple {
    const { left, top, width, height } = this.box;
    const across = ((2 * (x - left)) / width - 1) * LENS * (width / height);
    const upward = (1 - (2 * (y - top)) / height) * LENS;
    return unit(add(add(times(this.right, across), times(this.up, upward)), times(this.back, -1)));
  }

  /** Metres that a CSS pixel covers at a point. */
  metresPerPixel(point: Readonly<Triple>): number {
    return (2 * LENS * this.project(point)[2]) / this.box.height;
  }

  private viewMatrix(): Matrix4 {
    const [right, up, back] = [this.right, this.up, this.back].map((axis) => new Vector3(...axis));
    const world = new Matrix4().makeBasis(right as Vector3, up as Vector3, back as Vector3);
    return world.setPosition(...this.eye).invert();
  }

  private perspective(aspect: number, radius: number): Matrix4 {
    const near = Math.max(0.02 * radius, this.far - 3 * radius);
    const top = LENS * near;
    return new Matrix4().makePerspective(-top * aspect, top * aspect, top, -top, near, this.far + 3 * radius);
  }
}

/** The direction from the camera to a point. */
export const towards = (camera: Camera, point: Readonly<Triple>): Triple => unit(minus(point, camera.eye));
