/** Three looks at a scan: where each lies on the canvas, which way it looks, and what of the scan a place of it shows. */

import { type Box, inBox } from "../../canvas/math/boxes";
import {
  type Bounds,
  bounded,
  boundsOf,
  Camera,
  FIRST_VIEW,
  VIEWS,
  type View,
  type ViewName,
} from "../../canvas/math/camera";
import { hit } from "../../canvas/math/hit_test";
import { minus, rowOf, size, type Triple } from "../../canvas/math/vectors";
import type { Drawable, ScanSurface } from "../data/scan_document";

const SIDES: readonly (readonly [ViewName, string])[] = [
  ["front", "Front"],
  ["three_quarter_left", "Three-quarter"],
  ["left", "Profile"],
];
export const SIDE_LABELS = SIDES.map(([, label]) => label);

/** Radians of a turn for each pixel of a drag. */
const TURN = 0.008;
/** Pixels within which a place of the canvas means a point where no surface faces it. */
const NEAR = 10;
/** A point is hidden where something of the scan lies so many metres before it. */
const HIDDEN = 0.012;

/** The three boxes on a canvas of this size: beside each other, on a high one the front over the other two. */
export function boxesOf(width: number, height: number): readonly Box[] {
  const gap = 2;
  if (width >= 1.1 * height) {
    const columnWidth = (width - 2 * gap) / 3;
    return [0, 1, 2].map((at) => ({ left: at * (columnWidth + gap), top: 0, width: columnWidth, height }));
  }
  const [upper, columnWidth] = [0.58 * height, (width - gap) / 2];
  const lower = { top: upper + gap, width: columnWidth, height: height - upper - gap };
  return [
    { left: 0, top: 0, width, height: upper },
    { left: 0, ...lower },
    { left: columnWidth + gap, ...lower },
  ];
}

export class ScanCameras {
  readonly #bounds: Bounds;
  #views: View[] = SIDES.map(([name]) => viewOf(name));
  #boxes: readonly Box[] = boxesOf(1, 1);

  constructor(scan: Pick<Drawable, "face" | "surface">) {
    this.#bounds = boundsOf(scan.face?.positions ?? scan.surface.positions);
  }

  resize(width: number, height: number): void {
    this.#boxes = boxesOf(width, height);
  }

  get boxes(): readonly Box[] {
    return this.#boxes;
  }

  camera(at: number): Camera {
    return new Camera(this.#views[at] as View, this.#boxes[at] as Box, this.#bounds);
  }

  /** The look that a place of the canvas lies in; -1: none. */
  at(x: number, y: number): number {
    return this.#boxes.findIndex((box) => inBox(box, x, y));
  }

  /** Turns a look by pixels to the right and down. */
  turn(at: number, dx: number, dy: number): void {
    this.#change(at, (view) => ({ ...view, yaw: view.yaw - TURN * dx, pitch: view.pitch + TURN * dy }));
  }

  /** Shifts a look by pixels to the right and down. */
  shift(at: number, dx: number, dy: number): void {
    const { metresPerPixel, middle } = this.#scale(at);
    const [right, up] = middle;
    this.#change(at, (view) => ({ ...view, pan: [right - dx * metresPerPixel, up + dy * metresPerPixel] }));
  }

  /** Brings a look closer, so that what lies at a place of the canvas stays there; without one, at its middle. */
  zoom(at: number, by: number, x?: number, y?: number): void {
    const { left, top, width, height } = this.#boxes[at] as Box;
    const [dx, dy] = [(x ?? left + width / 2) - left - width / 2, (y ?? top + height / 2) - top - height / 2];
    this.shift(at, -dx, -dy);
    this.#change(at, (view) => ({ ...view, zoom: view.zoom * by }));
    this.shift(at, dx, dy);
  }

  /** The looks as they were at first. */
  reset(): void {
    this.#views = SIDES.map(([name]) => viewOf(name));
  }

  #scale(at: number): { metresPerPixel: number; middle: readonly [number, number] } {
    const camera = this.camera(at);
    return { metresPerPixel: camera.metresPerPixel(camera.middle), middle: (this.#views[at] as View).pan };
  }

  #change(at: number, change: (view: View) => View): void {
    this.#views = this.#views.map((view, index) => (index === at ? bounded(change(view), this.#bounds.radius) : view));
  }
}

function viewOf(name: ViewName): View {
  const [yaw, pitch] = VIEWS[name];
  return { ...FIRST_VIEW, yaw, pitch, zoom: 1 };
}

/** What of a scan a place of the canvas shows, metres; undefined: nothing. */
export function pick({ positions, triangles }: ScanSurface, camera: Camera, x: number, y: number): Triple | undefined {
  const surfaceHit = hit(positions, triangles, camera.eye, camera.ray(x, y));
  return surfaceHit?.point ?? nearestPoint(positions, camera, x, y);
}

/** Clouds have no surface, and some scans are inside out: of the points under a finger the one nearest to the eye. */
function nearestPoint(positions: Float32Array, camera: Camera, x: number, y: number): Triple | undefined {
  const places = camera.projectAll(positions);
  let [best, least] = [-1, Infinity];
  for (let row = 0; 2 * row < places.length; row++) {
    if (Math.hypot((places[2 * row] as number) - x, (places[2 * row + 1] as number) - y) > NEAR) continue;
    const far = size(minus(rowOf(positions, row), camera.eye));
    if (far < least) [best, least] = [row, far];
  }
  return best < 0 ? undefined : rowOf(positions, best);
}

/** Whether something of the scan lies before a point. */
export function isHidden({ positions, triangles }: ScanSurface, camera: Camera, point: Readonly<Triple>): boolean {
  const way = minus(point, camera.eye);
  const far = size(way);
  const surfaceHit = hit(positions, triangles, camera.eye, way.map((part) => part / far) as Triple);
  return surfaceHit !== undefined && surfaceHit.distance < far - HIDDEN;
}
