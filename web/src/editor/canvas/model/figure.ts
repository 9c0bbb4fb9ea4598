/** One face as the page computes it: what it wears, and where the hand's linearisation puts it. */

import type { Followers, Net } from "../../session/control_net";
import { rowOf, type Triple } from "../math/vectors";
import type { Moves } from "./influence_field";

/** What a face last got from the server: the compound of a content, and what of it hand and muscles had made. */
export interface Worn {
  source: string;
  /** undefined: an expression whose making is not known here (an old revision); nothing can be added to it. */
  moves: Moves | undefined;
  net: Net | null;
}

/** How long a face takes from the linearised to the true shape, seconds. */
export const EASE = 0.12;

/** How far the linearised shape was from the true one when that came, metres, over the rows that moved. */
export interface Difference {
  greatest: number;
  mean: number;
  /** How far the drag moved what it moved most. */
  move: number;
}

/** A face of the canvas. All arrays have rows (skin, then parts) as the manifest has them; metres. */
export class Figure {
  worn: Worn = { source: "neutral", moves: undefined, net: null };
  /** The face with the server's compound, (rows, 3). */
  readonly base: Float32Array;
  /** `base` and what the live field adds, (rows, 3): what is drawn once easing has ended. */
  readonly live: Float32Array;
  /** What the picture still lacks to `live` when easing begins, (rows, 3). */
  readonly offset: Float32Array;
  /** When easing began, seconds; -Infinity: nothing to ease. */
  easedFrom = -Infinity;

  constructor(
    readonly name: string,
    readonly rest: Float32Array,
    /** (3, V, 3): metres per radian, metre and unit of R - 1 (`TangentsAsset`). */
    public tangents: Float32Array | undefined,
  ) {
    [this.base, this.live, this.offset] = [rest.slice(), rest.slice(), new Float32Array(rest.length)];
  }

  /** How a vertex of the sheet answers to dtheta, dh and R; undefined where it does not. */
  answer(vertex: number): [Triple, Triple, Triple] | undefined {
    if (this.tangents === undefined) return undefined;
    const size = this.tangents.length / 9;
    const at = (part: number): Triple => rowOf(this.tangents as Float32Array, part * size + vertex);
    return [at(0), at(1), at(2)];
  }

  /** What the picture lacks to `live` at a time, 1 (all of `offset`) to 0. */
  lag(time: number): number {
    const part = (time - this.easedFrom) / EASE;
    if (!(part < 1)) return 0;
    const left = 1 - Math.max(0, part);
    return left * left * (3 - 2 * left);
  }

  /** Puts on what the server computed; the picture eases from what it shows at `time`. `field`: that of the new content. */
  wear(
    worn: Worn,
    base: Float32Array,
    field: Float32Array | undefined,
    followers: Followers | null,
    time: number,
  ): Difference {
    const lag = this.lag(time);
    const shown = this.live.map((value, at) => value + lag * (this.offset[at] as number));
    const move = farthest(this.base, this.live);
    this.worn = worn;
    this.base.set(base);
    this.move(field, followers);
    const linear = this.offset.map((_, at) => (shown[at] as number) - (this.live[at] as number));
    this.offset.set(linear);
    this.easedFrom = settleSmall(this.offset) ? time : -Infinity;
    return { ...lengths(linear), move };
  }

  /** Puts `live` where a field (V, 4) leads; undefined: no field. */
  move(field: Float32Array | undefined, followers: Followers | null): void {
    this.live.set(this.base);
    if (field === undefined || this.tangents === undefined) return;
    addDisplacement(this.live, this.tangents, field);
    if (followers !== null) follow(this.live, this.base, followers);
  }
}

const NOTHING = 2e-6; // metres that no picture shows

/** Clears offsets nobody would see; whether any are left. */
function settleSmall(offset: Float32Array): boolean {
  let any = false;
  for (let at = 0; at < offset.length; at += 3)
    if (Math.hypot(offset[at] as number, offset[at + 1] as number, offset[at + 2] as number) < NOTHING)
      offset.fill(0, at, at + 3);
    else any = true;
  return any;
}

/** The greatest length of the rows (n, 3), and the mean over those that are not still. */
export function lengths(rows: Float32Array): { greatest: number; mean: number } {
  let [greatest, sum, count] = [0, 0, 0];
  for (let at = 0; at < rows.length; at += 3) {
    const length = Math.hypot(rows[at] as number, rows[at + 1] as number, rows[at + 2] as number);
    if (length < NOTHING) continue;
    [greatest, sum, count] = [Math.max(greatest, length), sum + length, count + 1];
  }
  return { greatest, mean: count === 0 ? 0 : sum / count };
}

export const farthest = (from: Float32Array, to: Float32Array): number =>
  lengths(from.map((value, at) => (to[at] as number) - value)).greatest;

/** Adds tangents (3, V, 3) times field (V, 4) to the first V rows of positions. */
export function addDisplacement(positions: Float32Array, tangents: Float32Array, field: Float32Array): void {
  const size = tangents.length / 3;
  for (let vertex = 0; 3 * vertex < size; vertex++) {
    const [a, b, c] = [field[4 * vertex] as number, field[4 * vertex + 1] as number, field[4 * vertex + 2] as number];
    if (a === 0 && b === 0 && c === 0) continue;
    for (let at = 3 * vertex; at < 3 * vertex + 3; at++)
      positions[at] =
        (positions[at] as number) +
        (tangents[at] as number) * a +
        (tangents[size + at] as number) * b +
        (tangents[2 * size + at] as number) * c;
  }
}

/** Moves rows that follow the sheet by the weighted moves of their anchors (model.md: inner skin, parts). */
export function follow(positions: Float32Array, base: Float32Array, followers: Followers): void {
  const { rows, anchors, shares, links } = followers;
  rows.forEach((row, place) => {
    for (let link = place * links; link < (place + 1) * links; link++) {
      const share = shares[link] as number;
      const anchor = 3 * (anchors[link] as number);
      if (share === 0) continue;
      for (let axis = 0; axis < 3; axis++)
        positions[3 * row + axis] =
          (positions[3 * row + axis] as number) +
          share * ((positions[anchor + axis] as number) - (base[anchor + axis] as number));
    }
  });
}
