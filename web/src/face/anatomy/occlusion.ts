/** Ambient occlusion of the generic face, by depth maps from many directions. */

import { extent, type Fans, normals } from "./topology";

const DIRECTIONS = 64;
const SIZE = 112; // texels across a depth map
const BIAS = 0.0035; // metres a surface may lie behind itself, for the coarse map

type Vector = [number, number, number];

/** How much of the sky over each row is open, 0..1: the head's own shadow in light from everywhere. */
export function openness(around: Fans, positions: Float32Array, triangles: readonly Uint32Array[]): Float32Array {
  const rows = around.starts.length - 1;
  const facing = normals(around, positions);
  const [seen, total] = [new Float32Array(rows), new Float32Array(rows)];
  const view = new DepthView(positions);
  for (let index = 0; index < DIRECTIONS; index++) {
    const direction = onSphere(index);
    view.look(direction, triangles);
    for (let row = 0; row < rows; row++) {
      const cosine = dot(facing, row, direction);
      if (cosine <= 0.05) continue;
      total[row] = (total[row] as number) + cosine;
      if (view.sees(row)) seen[row] = (seen[row] as number) + cosine;
    }
  }
  return seen.map((value, row) => value / Math.max(total[row] as number, 1e-6));
}

/** Evenly spread directions (the golden spiral). */
function onSphere(index: number): Vector {
  const y = 1 - (2 * (index + 0.5)) / DIRECTIONS;
  const [radius, angle] = [Math.sqrt(1 - y * y), index * Math.PI * (3 - Math.sqrt(5))];
  return [Math.cos(angle) * radius, y, Math.sin(angle) * radius];
}

const dot = (values: Float32Array, row: number, direction: Vector): number =>
  (values[3 * row] as number) * direction[0] +
  (values[3 * row + 1] as number) * direction[1] +
  (values[3 * row + 2] as number) * direction[2];

/** What is nearest in parallel light: a small depth map of the whole mesh. */
class DepthView {
  private readonly map = new Float32Array(SIZE * SIZE);
  private readonly across: Float32Array;
  private readonly up: Float32Array;
  private readonly depth: Float32Array;
  private readonly centre: Vector;
  private readonly scale: number;

  constructor(private readonly positions: Float32Array) {
    const rows = positions.length / 3;
    [this.across, this.up, this.depth] = [new Float32Array(rows), new Float32Array(rows), new Float32Array(rows)];
    const ends = [0, 1, 2].map((axis) => extent(positions, axis));
    this.centre = ends.map(([low, high]) => (low + high) / 2) as Vector;
    const reach = Math.hypot(...ends.map(([low, high]) => (high - low) / 2));
    this.scale = (SIZE / 2 - 1) / reach;
  }

  /** Draws the depth towards `direction`. */
  look(direction: Vector, triangles: readonly Uint32Array[]): void {
    const side = unit(
      Math.abs(direction[1]) < 0.9 ? [direction[2], 0, -direction[0]] : [0, -direction[2], direction[1]],
    );
    const top = crossed(direction, side);
    const middle = (axis: Vector) => axis[0] * this.centre[0] + axis[1] * this.centre[1] + axis[2] * this.centre[2];
    const [s, t] = [middle(side), middle(top)];
    for (let row = 0; row < this.depth.length; row++) {
      this.across[row] = (dot(this.positions, row, side) - s) * this.scale + SIZE / 2;
      this.up[row] = (dot(this.positions, row, top) - t) * this.scale + SIZE / 2;
      this.depth[row] = dot(this.positions, row, direction);
    }
    this.map.fill(-Infinity);
    for (const list of triangles)
      for (let at = 0; at < list.length; at += 3)
        this.fill(list[at] as number, list[at + 1] as number, list[at + 2] as number);
  }

  sees(row: number): boolean {
    const texel = Math.floor(this.up[row] as number) * SIZE + Math.floor(this.across[row] as number);
    return (this.depth[row] as number) >= (this.map[texel] as number) - BIAS;
  }

  private fill(a: number, b: number, c: number): void {
    const { across, up, depth, map } = this;
    const [ax, ay, bx, by, cx, cy] = [across[a], up[a], across[b], up[b], across[c], up[c]] as [
      number,
      number,
      number,
      number,
      number,
      number,
    ];
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (Math.abs(area) < 1e-9) return;
    const [az, bz, cz] = [depth[a] as number, depth[b] as number, depth[c] as number];
    const lastX = Math.floor(Math.max(ax, bx, cx));
    const lastY = Math.floor(Math.max(ay, by, cy));
    for (let y = Math.floor(Math.min(ay, by, cy)); y <= lastY; y++)
      for (let x = Math.floor(Math.min(ax, bx, cx)); x <= lastX; x++) {
        const v = ((x + 0.5 - ax) * (cy - ay) - (cx - ax) * (y + 0.5 - ay)) / area;
        const w = ((bx - ax) * (y + 0.5 - ay) - (x + 0.5 - ax) * (by - ay)) / area;
        if (v < 0 || w < 0 || v + w > 1) continue;
        const near = az + v * (bz - az) + w * (cz - az);
        if (near > (map[y * SIZE + x] as number)) map[y * SIZE + x] = near;
      }
  }
}

const crossed = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

function unit(vector: Vector): Vector {
  const length = Math.hypot(...vector);
  return [vector[0] / length, vector[1] / length, vector[2] / length];
}
