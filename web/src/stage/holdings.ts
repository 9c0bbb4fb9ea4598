import type { Library } from "../link/assets";
import type { Blender, Entry } from "./blender";
import type { Pose } from "./pose";
import { expressionWeights, type Term, terms } from "./weights";

/** A layer's values: (x, y, z, unused) per texel, and how far it moves the two eyeballs' centres. */
interface Sheet {
  fill: (into: Float32Array) => void;
  centres: Float32Array;
}

const CATCH_UP = 0.25; // seconds in which a term that came late grows to its weight
const UPLOADS = 8; // layers uploaded in one frame, so that no frame is late for them

const keyOf = (face: string, expression: string | undefined): string => (expression === undefined ? face : `${face}\n${expression}`);

/** What a stage holds of the cast: fetched lazily, uploaded a few per frame, held back until then and never popped. */
export class Holdings {
  private readonly sheets = new Map<string, Sheet>();
  private readonly asked = new Set<string>();
  private readonly shares = new Map<string, number>();
  private readonly lost = new Set<string>();
  private scratch: Float32Array | undefined;

  constructor(
    private readonly library: Library,
    private readonly eyeRows: Int32Array,
  ) {}

  /** Fetches what a pose needs; true when all of it (or its refusal) is here. */
  want(faces: Iterable<string>, expressions: Iterable<string>): void {
    const names = [...expressions].filter((name) => name !== "neutral" && this.library.hasExpression(name));
    for (const face of faces) {
      if (!this.library.hasFace(face)) continue;
      this.fetchFace(face);
      for (const name of names) this.fetchCompound(face, name);
    }
  }

  /** Waits until everything that `want` asked for has come. */
  async complete(faces: readonly string[], expressions: readonly string[]): Promise<void> {
    this.want(faces, expressions);
    for (const face of faces) {
      await this.library.positions(face);
      for (const name of expressions) if (name !== "neutral") await this.library.compound(face, name);
    }
  }

  /** The pose's terms as layers of the blender, after `seconds` more; `atOnce`: everything that is here, in full. */
  entries(pose: Pose, blender: Blender, seconds: number, atOnce: boolean): { entries: Entry[]; held: Term[] } {
    this.upload(pose, blender, atOnce);
    for (const [key, share] of this.shares) if (share < 1) this.shares.set(key, atOnce ? 1 : Math.min(1, share + seconds / CATCH_UP));
    const held = terms(pose, (face, expression) => this.share(face, expression, blender));
    const entries = held.map(({ face, expression, weight }) => ({ layer: blender.layers.use(keyOf(face, expression)) as number, weight }));
    return { entries, held };
  }

  /** The eyeballs' centres (6) under these terms. */
  centres(held: readonly Term[], into: Float32Array): void {
    into.fill(0);
    for (const { face, expression, weight } of held) {
      const centres = (this.sheets.get(keyOf(face, expression)) as Sheet).centres;
      for (let part = 0; part < 6; part++) into[part] = (into[part] as number) + weight * (centres[part] as number);
    }
  }

  /** Whether every term of the pose shows in full. */
  settled(pose: Pose, blender: Blender): boolean {
    return terms(pose, () => 1).every(({ face, expression }) => {
      const key = keyOf(face, expression);
      return this.lost.has(key) || (blender.layers.has(key) && this.shares.get(key) === 1);
    });
  }

  private share(face: string, expression: string | undefined, blender: Blender): number {
    const key = keyOf(face, expression);
    return blender.layers.has(key) ? smoothShare(this.shares.get(key) ?? 0) : 0;
  }

  private upload(pose: Pose, blender: Blender, atOnce: boolean): void {
    const wanted = terms(pose, () => 1);
    const keep = new Set(wanted.map(({ face, expression }) => keyOf(face, expression)));
    const bare = !wanted.some(({ face }) => blender.layers.has(face)); // nothing shows yet: no need to ease
    let left = atOnce ? Infinity : UPLOADS;
    for (const { face, expression, weight } of wanted) {
      const key = keyOf(face, expression);
      const sheet = this.sheets.get(key);
      if (blender.layers.has(key) || sheet === undefined || left <= 0) continue;
      const layer = blender.layers.take(key, keep);
      if (layer === undefined) return; // more than the GPU has layers for: held back
      left -= 1;
      this.scratch ??= blender.blankLayer();
      sheet.fill(this.scratch.fill(0));
      blender.upload(layer, this.scratch);
      this.shares.set(key, atOnce || bare || Math.abs(weight) < 0.01 ? 1 : 0);
    }
  }

  private fetchFace(face: string): void {
    this.ask(keyOf(face, undefined), async () => {
      const positions = await this.library.positions(face);
      const fill = (into: Float32Array) => {
        for (let row = 0; 3 * row < positions.length; row++) into.set(positions.subarray(3 * row, 3 * row + 3), 4 * row);
      };
      return { fill, centres: this.means((row, axis) => positions[3 * row + axis] as number) };
    });
  }

  private fetchCompound(face: string, expression: string): void {
    this.ask(keyOf(face, expression), async () => {
      const { scale, indices, deltas } = await this.library.compound(face, expression);
      const fill = (into: Float32Array) => {
        for (let n = 0; n < indices.length; n++)
          for (let axis = 0; axis < 3; axis++) into[4 * (indices[n] as number) + axis] = (deltas[3 * n + axis] as number) * scale;
      };
      const place = new Map(Array.from(indices, (row, n) => [row, n] as const));
      const delta = (row: number, axis: number) => {
        const n = place.get(row);
        return n === undefined ? 0 : (deltas[3 * n + axis] as number) * scale;
      };
      return { fill, centres: this.means(delta) };
    });
  }

  private ask(key: string, read: () => Promise<Sheet>): void {
    if (this.asked.has(key)) return;
    this.asked.add(key);
    read().then(
      (sheet) => this.sheets.set(key, sheet),
      (error: unknown) => {
        this.lost.add(key);
        console.warn(String(error));
      },
    );
  }

  /** The mean of the two eyeballs' rows, 2 x 3. */
  private means(value: (row: number, axis: number) => number): Float32Array {
    const out = new Float32Array(6);
    for (const side of [0, 1]) {
      const [first, end] = [this.eyeRows[2 * side] as number, this.eyeRows[2 * side + 1] as number];
      for (let axis = 0; axis < 3; axis++) {
        let sum = 0;
        for (let row = first; row < end; row++) sum += value(row, axis);
        out[3 * side + axis] = end > first ? sum / (end - first) : 0;
      }
    }
    return out;
  }
}

const smoothShare = (share: number): number => share * share * (3 - 2 * share);

/** Names that a pose puts weight on. */
export const namesOf = (pose: Pose): { faces: string[]; expressions: string[] } => ({
  faces: Object.keys(pose.faces),
  expressions: Object.keys(expressionWeights(pose)),
});
