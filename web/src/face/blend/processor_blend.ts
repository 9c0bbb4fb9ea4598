/** Blends faces and expressions on the processor, and hands the graphics context what comes of it. */

import type { CorrectivesData } from "../anatomy/correctives_data";
import type { Fans } from "../anatomy/topology";
import { ROW_WIDTH } from "../gpu/pass_shaders";
import type { Sockets } from "./corrective_passes";
import { ProcessorCorrectives, type Rested } from "./processor_correctives";
import type { CompoundSum, Entry, Eyeballs, RegionalEntry, Sum } from "./sum_pass";

const NOTHING = new Float32Array();

/** Numbers of a block of rows, in which a layer may hold nothing but zeros: most expressions move a part of the face. */
const BLOCK = 3 * 32;

/**
 * Weighted sums, correctives and normals on the processor, as the shaders of this folder do it. Where the processor draws
 * everything anyway, they cost 1.27 to 1.80 of a whole frame that is blended so (docs/decisions/stage-quality-and-cost.md):
 * nothing is left out there that a sum does not need.
 */
export class ProcessorBlend {
  private readonly layers: Float32Array[] = [];
  private readonly filled: Uint8Array[] = []; // by layer: whether a block holds anything
  private readonly here: Entry[] = []; // what is added up in the present block
  private readonly triangles: Uint32Array;
  private readonly sum: Float64Array;
  private readonly facing: Float64Array;
  private readonly correctives: ProcessorCorrectives | undefined;
  private restings = new WeakMap<object, { faces: string; rested: Rested }>();
  /** What was blended last, four numbers a texel: positions, metres, and normals. */
  readonly positions: Float32Array;
  readonly normals: Float32Array;

  /** `masks`: how much of each row belongs to each region, (rows, 4). */
  constructor(
    private readonly rows: number,
    fan: Fans,
    correctives?: CorrectivesData,
    private readonly masks?: Float32Array,
  ) {
    const texels = ROW_WIDTH * Math.ceil(rows / ROW_WIDTH);
    this.triangles = trianglesOf(fan);
    this.sum = new Float64Array(3 * rows);
    this.facing = new Float64Array(3 * rows);
    this.positions = new Float32Array(4 * texels).fill(1);
    this.normals = new Float32Array(4 * texels).fill(1);
    this.correctives = correctives && new ProcessorCorrectives(correctives);
  }

  /** Keeps `rows` times (x, y, z, unused) as a layer. */
  keep(layer: number, values: Float32Array): void {
    const own = this.layers[layer] ?? new Float32Array(3 * this.rows);
    for (let row = 0; row < this.rows; row++)
      for (let axis = 0; axis < 3; axis++) own[3 * row + axis] = values[4 * row + axis] as number;
    this.layers[layer] = own;
    this.filled[layer] = Uint8Array.from({ length: Math.ceil(own.length / BLOCK) }, (_, block) =>
      own.subarray(BLOCK * block, BLOCK * (block + 1)).some((value) => value !== 0) ? 1 : 0,
    );
    this.restings = new WeakMap(); // a layer holds something else now
  }

  /** Blends a sum into `positions` and `normals`; `target`: for whom, as mixed faces without expression are remembered. */
  blend(mix: CompoundSum, eyes: Eyeballs, target: object): void {
    const rested = mix.allowed && this.rested(mix.rest, eyes, target);
    this.add(mix, eyes);
    if (rested !== undefined) this.correctives?.correct(this.sum, rested, mix.allowed ?? NOTHING, socketsOf(eyes));
    const { sum, positions } = this;
    for (let row = 0; row < this.rows; row++) {
      positions[4 * row] = sum[3 * row] as number;
      positions[4 * row + 1] = sum[3 * row + 1] as number;
      positions[4 * row + 2] = sum[3 * row + 2] as number;
    }
    this.deriveNormals();
  }

  private rested(rest: readonly Entry[], eyes: Eyeballs, target: object): Rested | undefined {
    const faces = JSON.stringify(rest);
    const cached = this.restings.get(target);
    if (this.correctives === undefined || cached?.faces === faces) return cached?.rested;
    this.add({ entries: rest, regional: [] }, eyes);
    const rested = this.correctives.rested(this.sum);
    this.restings.set(target, { faces, rested });
    return rested;
  }

  /** The weighted sum of layers, with turned eyeballs. */
  private add({ entries, regional }: Sum, eyes: Eyeballs): void {
    this.sum.fill(0);
    const loaded = entries.filter(({ layer }) => this.layers[layer] !== undefined);
    for (let block = 0; BLOCK * block < this.sum.length; block++) this.addBlock(loaded, block);
    for (const entry of regional) this.addRegional(entry);
    for (const side of [0, 1]) this.turn(eyes, side);
  }

  /** Adds up a block of those layers that hold anything there; four at once: memory is what limits a sum. */
  private addBlock(entries: readonly Entry[], block: number): void {
    const { filled, here } = this;
    here.length = 0;
    for (const entry of entries) if ((filled[entry.layer] as Uint8Array)[block] === 1) here.push(entry);
    while (here.length % 4 !== 0) here.push({ layer: (here[0] as Entry).layer, weight: 0 });
    const [from, to] = [BLOCK * block, Math.min(BLOCK * (block + 1), this.sum.length)];
    for (let n = 0; n < here.length; n += 4) this.addFour(n, from, to);
  }

  /** Adds four layers of those that are here, beginning with the `first`. */
  private addFour(first: number, from: number, to: number): void {
    const { sum, layers, here } = this;
    const [one, two] = [here[first] as Entry, here[first + 1] as Entry];
    const [three, four] = [here[first + 2] as Entry, here[first + 3] as Entry];
    const [a, b] = [layers[one.layer] as Float32Array, layers[two.layer] as Float32Array];
    const [c, d] = [layers[three.layer] as Float32Array, layers[four.layer] as Float32Array];
    const [p, q, r, s] = [one.weight, two.weight, three.weight, four.weight];
    for (let n = from; n < to; n++)
      sum[n] =
        (sum[n] as number) + p * (a[n] as number) + q * (b[n] as number) + r * (c[n] as number) + s * (d[n] as number);
  }

  private addRegional({ layer, weights }: RegionalEntry): void {
    const { sum, masks } = this;
    const own = this.layers[layer];
    if (masks === undefined || own === undefined) return;
    for (let row = 0; row < this.rows; row++) {
      let weight = 0;
      for (let region = 0; region < 4; region++)
        weight += (masks[4 * row + region] as number) * (weights[region] as number);
      for (let n = 3 * row; n < 3 * row + 3; n++) sum[n] = (sum[n] as number) + weight * (own[n] as number);
    }
  }

  private turn({ rows, centres, turns }: Eyeballs, side: number): void {
    const { sum } = this;
    for (let n = 3 * (rows[2 * side] as number); n < 3 * (rows[2 * side + 1] as number); n += 3) {
      const x = (sum[n] as number) - (centres[3 * side] as number);
      const y = (sum[n + 1] as number) - (centres[3 * side + 1] as number);
      const z = (sum[n + 2] as number) - (centres[3 * side + 2] as number);
      for (let axis = 0; axis < 3; axis++) {
        const turn = 9 * side + axis;
        sum[n + axis] =
          (centres[3 * side + axis] as number) +
          (turns[turn] as number) * x +
          (turns[turn + 3] as number) * y +
          (turns[turn + 6] as number) * z;
      }
    }
  }

  /** Area-weighted normals from the triangles around each row. */
  private deriveNormals(): void {
    const { sum, facing, normals, triangles } = this;
    facing.fill(0);
    for (let t = 0; t < triangles.length; t += 3) {
      const i = 3 * (triangles[t] as number);
      const j = 3 * (triangles[t + 1] as number);
      const k = 3 * (triangles[t + 2] as number);
      const bx = (sum[j] as number) - (sum[i] as number);
      const by = (sum[j + 1] as number) - (sum[i + 1] as number);
      const bz = (sum[j + 2] as number) - (sum[i + 2] as number);
      const cx = (sum[k] as number) - (sum[i] as number);
      const cy = (sum[k + 1] as number) - (sum[i + 1] as number);
      const cz = (sum[k + 2] as number) - (sum[i + 2] as number);
      this.face(i, j, k, by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx);
    }
    for (let row = 0; row < this.rows; row++) {
      const x = facing[3 * row] as number;
      const y = facing[3 * row + 1] as number;
      const z = facing[3 * row + 2] as number;
      const size = Math.sqrt(x * x + y * y + z * z);
      normals[4 * row] = size > 0 ? x / size : 0;
      normals[4 * row + 1] = size > 0 ? y / size : 0;
      normals[4 * row + 2] = size > 0 ? z / size : 1;
    }
  }

  /** Adds a triangle's normal, twice its area long, at its corners (places in `facing`). */
  private face(i: number, j: number, k: number, x: number, y: number, z: number): void {
    const { facing } = this;
    facing[i] = (facing[i] as number) + x;
    facing[i + 1] = (facing[i + 1] as number) + y;
    facing[i + 2] = (facing[i + 2] as number) + z;
    facing[j] = (facing[j] as number) + x;
    facing[j + 1] = (facing[j + 1] as number) + y;
    facing[j + 2] = (facing[j + 2] as number) + z;
    facing[k] = (facing[k] as number) + x;
    facing[k + 1] = (facing[k + 1] as number) + y;
    facing[k + 2] = (facing[k + 2] as number) + z;
  }
}

/** The triangles of fans, each once: three rows. */
function trianglesOf({ starts, pairs }: Fans): Uint32Array {
  const corners: number[] = [];
  for (let row = 0; row + 1 < starts.length; row++)
    for (let slot = starts[row] as number; slot < (starts[row + 1] as number); slot++) {
      const [second, third] = [pairs[2 * slot] as number, pairs[2 * slot + 1] as number];
      if (row < second && row < third) corners.push(row, second, third);
    }
  return Uint32Array.from(corners);
}

/** The eyeballs as lids meet them. */
export const socketsOf = (eyes: Eyeballs): Sockets => ({
  centres: eyes.centres,
  radii: eyes.radii,
  sights: Float32Array.from([6, 7, 8, 15, 16, 17], (turn) => eyes.turns[turn] as number),
});
