/** What a hand does to the vectors of a net: which points go along and how far, and the vectors that put them there. */

import { distances, type Fans } from "../../../face/anatomy/topology";
import type { Net, Vector } from "../../session/control_net";
import { minus, solved, type Triple } from "../math/vectors";
import { type Lips, together } from "./lip_coupling";

/** The points of a drag: how much of the hand's move each takes, and the mirror images of those. */
export interface DragGroup {
  /** Places that take the whole move: they are to lie where the hand puts them. */
  led: readonly number[];
  /** All places that move on the hand's side, with their share of its move. */
  shares: ReadonlyMap<number, number>;
  /** From a place to its mirror image; empty without mirror. */
  mirrored: ReadonlyMap<number, number>;
}

/** What says who goes along. */
export interface DragOptions {
  falloff: number; // millimetres on the skin
  mirror: boolean;
  /** How much the region moves of each vertex, 255 all; null: everything. */
  mask: Uint8Array | null;
}

/** A smooth bell: 1 in the middle, 0 from 1 on, level at both ends. */
export const bell = (x: number): number => (x >= 1 ? 0 : (1 - x * x) ** 2 * (1 - 0.25 * x * x));

/** A face that is dragged: what joins its rows, its lips (null: none), and where it is, (rows, 3) metres. */
export interface DraggedSkin {
  fans: Fans;
  lips: Lips | null;
  positions: Float32Array;
}

/** Who moves when a hand takes `led`. */
export function dragGroup(net: Net, led: readonly number[], dragOptions: DragOptions, skin: DraggedSkin): DragGroup {
  const shares = new Map(led.map((place) => [place, 1]));
  if (dragOptions.falloff > 0) addNeighbours(shares, net, led, dragOptions.falloff / 1000, skin);
  if (dragOptions.mask !== null)
    for (const [place, share] of shares) {
      const owned = (dragOptions.mask[net.rows[place] as number] as number) / 255;
      shares.set(place, led.includes(place) && owned > 0 ? 1 : share * owned);
    }
  for (const [place, share] of shares) if (share < 1e-3) shares.delete(place);
  return {
    led: led.filter((place) => shares.has(place)),
    shares,
    mirrored: dragOptions.mirror ? images(net, shares) : new Map(),
  };
}

function addNeighbours(
  shares: Map<number, number>,
  net: Net,
  led: readonly number[],
  radius: number,
  { fans, lips, positions }: DraggedSkin,
): void {
  const far = distances(
    fans,
    positions,
    led.map((place) => net.rows[place] as number),
  );
  if (lips !== null) together(lips, far, positions);
  net.rows.forEach((row, place) => {
    const share = bell((far[row] as number) / radius);
    if (share > 0 && !shares.has(place)) shares.set(place, share);
  });
}

/** The mirror images of all that move; a point that both sides move follows the side that moves it more. */
function images(net: Net, shares: ReadonlyMap<number, number>): Map<number, number> {
  const mirrored = new Map<number, number>();
  for (const [place, share] of shares) {
    const image = net.mirror[place] ?? -1;
    if (image < 0 || (shares.get(image) ?? 0) > share) continue;
    if (image !== place && shares.get(image) === share && mirrored.has(image)) continue; // one of two leads
    mirrored.set(place, image);
  }
  return mirrored;
}

/** The vectors when the hand has moved by `move` (dtheta, dh, R) since `before`; both (n, 3). */
export function moved(before: Float64Array, { shares, mirrored }: DragGroup, move: Readonly<Vector>): Float64Array {
  const out = before.slice();
  for (const [place, share] of shares) {
    const own = mirrored.get(place) === place; // on the midline: nothing to a side
    write(out, place, before, [own ? 0 : share * move[0], share * move[1], share * move[2]]);
  }
  for (const [place, image] of mirrored) {
    if (image === place) continue;
    const share = shares.get(place) as number;
    write(out, image, before, [-share * move[0], share * move[1], share * move[2]]);
  }
  return out;
}

const LEAST_RATIO = 0.2;

function write(into: Float64Array, place: number, before: Float64Array, more: Readonly<Vector>): void {
  into[3 * place] = (before[3 * place] as number) + more[0];
  into[3 * place + 1] = (before[3 * place + 1] as number) + more[1];
  into[3 * place + 2] = Math.max(LEAST_RATIO, (before[3 * place + 2] as number) + more[2]);
}

/** What must be added to a vector so that a point that lies at `from` comes to lie at `to`; undefined: nothing does. */
export function answered(
  answer: readonly [Triple, Triple, Triple] | undefined,
  from: Readonly<Triple>,
  to: Readonly<Triple>,
): Vector | undefined {
  return answer === undefined ? undefined : solved(...answer, minus(to, from));
}

/** The places that a drag is answered for: those led by the hand, and their images. */
export function answeredPlaces({ led, mirrored }: DragGroup): number[] {
  return [...new Set([...led, ...led.flatMap((place) => mirrored.get(place) ?? [])])];
}
