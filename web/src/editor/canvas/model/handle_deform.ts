/** A face under its handles, as the server makes it (omote.model.recipes.face_handles.drag_handles): warped, eyeballs round, lids on them. */

import { SOCKET_FAR, SOCKET_NEAR } from "../../../link/constants";
import { Warp } from "../math/warp";

const EXACT = 1e-6; // metres
const ROUNDS = 12; // of looking for the face at rest: each brings it nearer by a few times

/** What of the rows belongs together. */
export interface Rows {
  /** How many are skin; they come first. */
  skin: number;
  /** The rows of each eyeball. */
  balls: readonly Uint32Array[];
}

/** A lid's row: which ball it lies over, how high (radii), and how much of that it keeps. */
interface Lid {
  row: number;
  ball: number;
  height: number;
  hold: number;
}

/** So many handles moved since the last time are followed one by one; more of them all together. */
const FEW = 4;

export class HandleDeform {
  private readonly warp: Warp;
  private readonly lids: Lid[];
  private readonly columns = new Map<number, Float64Array>();
  private readonly out: Float32Array;
  /** Where the warp alone has led, and by which moves. */
  private from: { moves: Float64Array; positions: Float32Array };

  /** rest (rows, 3): where everything lies with all handles (rows of the skin) at rest, metres. */
  constructor(
    readonly rest: Float32Array,
    private readonly rows: Rows,
    handles: readonly number[],
  ) {
    this.warp = new Warp(handles.flatMap((row) => [...rest.subarray(3 * row, 3 * row + 3)]));
    this.lids = rows.balls.flatMap((ball, n) => lidsOver(rest, rows.skin, ball, n));
    this.out = new Float32Array(rest.length);
    this.from = { moves: new Float64Array(3 * handles.length), positions: rest.slice() };
  }

  /** The face with its handles moved by `moves` (n, 3); the same array each time. */
  at(moves: Float64Array): Float32Array {
    const { out } = this;
    out.set(this.warped(moves));
    for (const ball of this.rows.balls) rolled(out, this.rest, ball);
    this.seat(out);
    return out;
  }

  private warped(moves: Float64Array): Float32Array {
    const { from } = this;
    const changed = [...moves.keys()].filter((at) => moves[at] !== from.moves[at]);
    const places = new Set(changed.map((at) => Math.floor(at / 3)));
    if (places.size === 0) return from.positions;
    if (places.size > FEW) {
      this.from = { moves: moves.slice(), positions: this.rest.slice() };
      this.warp.add(this.from.positions, this.rest, moves);
      return this.from.positions;
    }
    const positions = from.positions.slice();
    for (const place of places) addMove(positions, this.column(place), moves, from.moves, place);
    return positions;
  }

  /** Begins again from these moves: what a hand changes from now on is followed quickly. */
  hold(moves: Float64Array): void {
    this.from = { moves: moves.slice(), positions: this.warped(moves).slice() };
  }

  /** How far each row follows a handle; worked out when it is first moved. */
  private column(place: number): Float64Array {
    const column = this.columns.get(place) ?? this.warp.follows(this.rest, place);
    this.columns.set(place, column);
    return column;
  }

  private seat(out: Float32Array): void {
    const balls = this.rows.balls.map((ball) => sphereOf(out, ball));
    for (const { row, ball, height, hold } of this.lids) {
      const { middle, radius } = balls[ball] as Sphere;
      const now = distance(out, row, middle) / radius;
      const share = (hold * (height - now)) / Math.max(now, 1e-9);
      for (let axis = 0; axis < 3; axis++) {
        const value = out[3 * row + axis] as number;
        out[3 * row + axis] = value + share * (value - (middle[axis] as number));
      }
    }
  }
}

/** The shape of a face that the server made: positions (rows, 3) with its handles moved by `moves` (n, 3). */
export function handleDeform(
  positions: Float32Array,
  rows: Rows,
  handles: readonly number[],
  moves: Float64Array,
): HandleDeform {
  let shape = new HandleDeform(positions, rows, handles);
  if (moves.every((move) => move === 0)) return shape;
  let rest = positions;
  for (let round = 0; round < ROUNDS; round++) {
    const there = shape.at(moves);
    const missing = positions.map((value, at) => value - (there[at] as number));
    if (missing.every((part) => Math.abs(part) < EXACT)) break;
    rest = rest.map((value, at) => value + (missing[at] as number));
    shape = new HandleDeform(rest, rows, handles);
  }
  shape.hold(moves);
  return shape;
}

interface Sphere {
  middle: [number, number, number];
  radius: number;
}

/** Middle of an eyeball and the root mean square distance of its rows from it. */
function sphereOf(positions: Float32Array, ball: Uint32Array): Sphere {
  const middle: [number, number, number] = [0, 0, 0];
  for (const row of ball)
    for (const axis of [0, 1, 2] as const) middle[axis] += (positions[3 * row + axis] as number) / ball.length;
  let square = 0;
  for (const row of ball) square += distance(positions, row, middle) ** 2 / ball.length;
  return { middle, radius: Math.sqrt(square) };
}

function lidsOver(positions: Float32Array, skin: number, ball: Uint32Array, n: number): Lid[] {
  const { middle, radius } = sphereOf(positions, ball);
  const lids: Lid[] = [];
  for (let row = 0; row < skin; row++) {
    const height = distance(positions, row, middle) / radius;
    const hold = falling((height - SOCKET_NEAR) / (SOCKET_FAR - SOCKET_NEAR));
    if (hold > 0) lids.push({ row, ball: n, height, hold });
  }
  return lids;
}

/** Makes an eyeball round again: as at rest, where and as large as it has become. */
function rolled(out: Float32Array, rest: Float32Array, ball: Uint32Array): void {
  const [before, after] = [sphereOf(rest, ball), sphereOf(out, ball)];
  const larger = after.radius / before.radius;
  for (const row of ball)
    for (const axis of [0, 1, 2] as const)
      out[3 * row + axis] = after.middle[axis] + larger * ((rest[3 * row + axis] as number) - before.middle[axis]);
}

function addMove(out: Float32Array, column: Float64Array, to: Float64Array, from: Float64Array, place: number): void {
  const more = [0, 1, 2].map((axis) => (to[3 * place + axis] as number) - (from[3 * place + axis] as number));
  for (let row = 0; row < column.length; row++)
    for (const axis of [0, 1, 2] as const)
      out[3 * row + axis] = (out[3 * row + axis] as number) + (column[row] as number) * (more[axis] as number);
}

/** 1 up to zero, 0 from one on, with a soft step between. */
const falling = (share: number): number => {
  const inside = Math.max(0, Math.min(1, share));
  return 1 - inside * inside * (3 - 2 * inside);
};

const distance = (positions: Float32Array, row: number, from: readonly [number, number, number]): number =>
  Math.hypot(
    (positions[3 * row] as number) - from[0],
    (positions[3 * row + 1] as number) - from[1],
    (positions[3 * row + 2] as number) - from[2],
  );
