/** Decides which blendshapes are on the GPU, and eases in those that arrive late. */

import type { Compound, Library } from "../../link/assets";
import { LID_UNITS } from "../../link/constants";
import { expressionNames, faceWeights, type Term, terms } from "../pose/mix_terms";
import type { Pose } from "../pose/pose";
import type { Blender } from "./blender";
import type { CompoundSum } from "./sum_pass";

/** Writes a layer's values, (x, y, z, unused) per texel. */
type Fill = (into: Float32Array) => void;

const LIDS: ReadonlySet<string> = new Set(LID_UNITS);
const CATCH_UP = 0.25; // seconds in which a term that came late grows to its weight
const UPLOADS = 8; // layers uploaded in one frame, so that no frame is late for them

const keyOf = (face: string, expression: string | undefined): string =>
  expression === undefined ? face : `${face}\n${expression}`;

/** From this weight on one compound alone is put right: rounding does not count. */
const BEYOND = 1 + 1e-6;

/** What a stage holds of the cast, by source: fetched lazily, uploaded a few per frame, held back until then and never popped. */
export class AssetResidency {
  private readonly sheets = new Map<string, Fill>();
  private readonly asked = new Map<string, Promise<unknown>>();
  private readonly shares = new Map<string, number>();
  private readonly lost = new Set<string>();
  private readonly allowances = new Map<string, NonNullable<Compound["allowed"]>>();
  private scratch: Float32Array | undefined;

  /** `masks`: how much of each number of an allowance belongs to each region, four to a number. */
  constructor(
    private readonly library: Library,
    private readonly masks?: Float32Array,
  ) {}

  /** Fetches these faces wearing these expressions; what is not in the cast is passed over. */
  want(faces: Iterable<string>, expressions: Iterable<string>): void {
    const names = [...expressions].filter((name) => name !== "neutral" && this.library.hasExpression(name));
    for (const face of faces) {
      if (!this.library.hasFace(face)) continue;
      this.fetchFace(face);
      for (const name of names) this.fetchCompound(face, name);
    }
  }

  /** How far faces wearing expressions are here; what was refused counts as shown. */
  arrival(faces: readonly string[], expressions: readonly string[], blender: Blender): "away" | "here" | "shown" {
    const worn = expressions.filter((name) => name !== "neutral" && this.library.hasExpression(name));
    const keys = faces
      .filter((face) => this.library.hasFace(face))
      .flatMap((face) => [undefined, ...worn].map((name) => keyOf(face, name)));
    const all = (test: (key: string) => boolean): boolean => keys.every((key) => this.lost.has(key) || test(key));
    if (!all((key) => this.sheets.has(key))) return "away";
    return all((key) => blender.layers.has(key) && this.shares.get(key) === 1) ? "shown" : "here";
  }

  /** Waits until everything that was ever wanted has come, or was refused. */
  async complete(): Promise<void> {
    await Promise.all(this.asked.values());
  }

  /** Puts what the poses of a frame need on the GPU, `seconds` after the last; `atOnce`: everything that is here, in full. */
  advance(poses: readonly Pose[], blender: Blender, seconds: number, atOnce: boolean): void {
    this.upload(poses, blender, atOnce);
    for (const [key, share] of this.shares)
      if (share < 1) this.shares.set(key, atOnce ? 1 : Math.min(1, share + seconds / CATCH_UP));
  }

  /** A pose's terms as layers of the blender; `allowed`: what is written with the compounds' allowances. */
  mix(pose: Pose, blender: Blender, allowed: Float32Array): CompoundSum {
    const shown = this.masks === undefined ? { ...pose, regions: {} } : pose; // a head without eyes has no regions
    const held = terms(shown, (face, expression) => this.share(face, expression, blender));
    const layer = ({ face, expression }: Term): number => blender.layers.use(keyOf(face, expression)) as number;
    const plain = held.filter(({ regions }) => regions === undefined);
    const entries = plain.map((term) => ({ layer: layer(term), weight: term.weight }));
    const regional = held.flatMap((term) =>
      term.regions === undefined ? [] : [{ layer: layer(term), weights: term.regions }],
    );
    const rest = entries.filter((_, at) => plain[at]?.expression === undefined);
    const beyond = held.some(({ expression, weight, most }) => expression && Math.abs(weight) > BEYOND * most);
    const lids = entries.filter((_, at) => LIDS.has(plain[at]?.expression ?? ""));
    const several = rest.length > 1 || held.length > rest.length + 1 || regional.length > 0 || beyond;
    return {
      entries,
      regional,
      rest,
      lids,
      allowed: several ? this.allow(held, allowed) : undefined,
    };
  }

  /** What the compounds together are allowed. */
  private allow(held: readonly Term[], allowed: Float32Array): Float32Array {
    allowed.fill(0);
    for (const term of held) {
      const { face, expression } = term;
      const own = expression === undefined ? undefined : this.allowances.get(keyOf(face, expression));
      own?.places.forEach((place, n) => {
        allowed[place] = (allowed[place] as number) + this.size(term, place) * (own.values[n] as number);
      });
    }
    return allowed;
  }

  /** How much of a term there is at a place of the allowances. */
  private size({ weight, most, regions }: Term, place: number): number {
    const own = (weight: number) => Math.min(Math.abs(weight), most);
    if (regions === undefined) return own(weight);
    const share = (region: number) => this.masks?.[regions.length * place + region] ?? 0;
    return regions.reduce((sum, weight, region) => sum + share(region) * own(weight), 0);
  }

  /** The weights of the faces on air, as far as they are here. */
  faces(pose: Pose, blender: Blender): Map<string, number> {
    return faceWeights(pose, (face) => this.share(face, undefined, blender));
  }

  /** Whether every term of the pose shows in full. */
  shownInFull(pose: Pose, blender: Blender): boolean {
    return terms(pose, () => 1).every(({ face, expression }) => {
      const key = keyOf(face, expression);
      return this.lost.has(key) || (blender.layers.has(key) && this.shares.get(key) === 1);
    });
  }

  private share(face: string, expression: string | undefined, blender: Blender): number {
    const key = keyOf(face, expression);
    return blender.layers.has(key) ? smoothShare(this.shares.get(key) ?? 0) : 0;
  }

  /** What is on air for any character gives way to none; all of them share what may be uploaded in one frame. */
  private upload(poses: readonly Pose[], blender: Blender, atOnce: boolean): void {
    const wanted = poses.map((pose) => terms(pose, () => 1));
    const keep = new Set(wanted.flat().map(({ face, expression }) => keyOf(face, expression)));
    let left = atOnce ? Infinity : UPLOADS;
    for (const summands of wanted) {
      const bare = !summands.some(({ face }) => blender.layers.has(face)); // nothing shows yet: no need to ease
      for (const { face, expression, weight } of summands) {
        const key = keyOf(face, expression);
        const fill = this.sheets.get(key);
        if (blender.layers.has(key) || fill === undefined || left <= 0) continue;
        const layer = blender.layers.take(key, keep);
        if (layer === undefined) return; // more than the GPU has layers for: held back
        left -= 1;
        this.scratch ??= blender.blankLayer();
        fill(this.scratch.fill(0));
        blender.upload(layer, this.scratch);
        this.shares.set(key, atOnce || bare || Math.abs(weight) < 0.01 ? 1 : 0);
      }
    }
  }

  private fetchFace(face: string): void {
    this.ask(keyOf(face, undefined), async () => {
      const positions = await this.library.positions(face);
      return (into) => {
        for (let row = 0; 3 * row < positions.length; row++)
          into.set(positions.subarray(3 * row, 3 * row + 3), 4 * row);
      };
    });
  }

  private fetchCompound(face: string, expression: string): void {
    if (this.library.expressions.get(expression)?.kind === "limb") {
      this.lost.add(keyOf(face, expression)); // it leaves heads alone
      return;
    }
    this.ask(keyOf(face, expression), async () => {
      const { scale, indices, deltas, allowed } = await this.library.compound(face, expression);
      if (allowed !== undefined) this.allowances.set(keyOf(face, expression), allowed);
      return (into) => {
        for (let n = 0; n < indices.length; n++)
          for (let axis = 0; axis < 3; axis++)
            into[4 * (indices[n] as number) + axis] = (deltas[3 * n + axis] as number) * scale;
      };
    });
  }

  private ask(key: string, read: () => Promise<Fill>): void {
    if (this.asked.has(key)) return;
    const came = read().then(
      (fill) => this.sheets.set(key, fill),
      (error: unknown) => {
        this.lost.add(key);
        console.warn(String(error));
      },
    );
    this.asked.set(key, came);
  }
}

const smoothShare = (share: number): number => share * share * (3 - 2 * share);

/** Names that a pose puts weight on. */
export const namesOf = (pose: Pose): { faces: string[]; expressions: string[] } => ({
  faces: Object.keys(pose.faces),
  expressions: expressionNames(pose),
});
