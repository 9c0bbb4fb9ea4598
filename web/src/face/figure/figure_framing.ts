/** Shots of figures: how much of one is seen, the points that a picture has to hold, and how it stands on the floor. */

import { Box3, type Matrix3, Vector3 } from "three";
import type { ShotSize } from "../../link/framings";
import type { Vector } from "./rotations";

/** What a figure with its arms spread lies in, metres. */
export const FIGURE_BOUNDS = new Box3(new Vector3(-1.4, -2.4, -1.4), new Vector3(1.4, 1, 1.4));

/** The height of the floor, metres below the eyes of a head that stands alone. */
export const FLOOR = -1.5;

/** Hair over the highest point of a head, and air above and below a figure, metres. */
const [OVER, BELOW] = [0.07, 0.06];

/** How far a limb's skin lies around its joints at most, metres. */
const AROUND = 0.08;

/** A figure as far as a camera must know it; a joint is undefined while the figure is not here. */
export interface FramedFigure {
  joint(name: string): Vector | undefined;
  standing(name: string): Vector | undefined;
  readonly soles: number;
  readonly size: number;
}

/** What a picture shows of a head (`face/framing.ts`). */
interface Shot {
  centre: [number, number, number];
  height: number;
  width: number;
}

/** The shot of a figure that stands; undefined for those of its head, and while it is not here. */
export function figureShot(figure: FramedFigure, size: ShotSize, head: readonly Vector[]): Shot | undefined {
  const [shoulder, hip] = [figure.standing("upperarm01.L"), figure.standing("upperleg01.L")];
  if (size === "portrait" || size === "head" || shoulder === undefined || hip === undefined) return undefined;
  const top = Math.max(...head.map(([, y]) => y)) + OVER;
  const chest = shoulder[1] - 0.3 * (shoulder[1] - hip[1]);
  const bottom = { bust: chest, half: hip[1] - 0.05, full: figure.soles - BELOW }[size];
  return { centre: [0, (top + bottom) / 2, 0.05], height: top - bottom, width: 3 * Math.abs(shoulder[0]) };
}

const SHOULDERS = ["upperarm01"];
const ARMS = ["lowerarm01", "wrist", "finger1-3", "finger2-3", "finger3-3", "finger5-3"];
const LEGS = ["upperleg01", "lowerleg01", "foot", "toes"];
const HELD: Readonly<Record<ShotSize, readonly string[]>> = {
  portrait: [],
  head: [],
  bust: SHOULDERS,
  half: [...SHOULDERS, ...ARMS],
  full: [...SHOULDERS, ...ARMS, ...LEGS],
};

/** The points of a figure that a picture of this size has to hold, as it is posed, metres. */
export function figurePoints(figure: FramedFigure, size: ShotSize): Vector[] {
  return HELD[size].flatMap((name) =>
    ["L", "R"].flatMap((side): Vector[] => {
      const at = figure.joint(`${name}.${side}`);
      return at === undefined
        ? []
        : [
            [at[0] - AROUND, at[1] + AROUND, at[2]],
            [at[0] + AROUND, at[1] + AROUND, at[2]],
          ];
    }),
  );
}

/** How a head is carried (`HeadUniforms`). */
interface CarriedHead {
  readonly pivot: { readonly value: Vector3 };
  readonly headPlace: { readonly value: Vector3 };
  readonly headTurn: { readonly value: Matrix3 };
}

/** How a figure is moved, in its own metres, and enlarged. */
export interface Ground {
  readonly offset: readonly [number, number, number];
  readonly size: number;
}

/** What stands as it was modelled. */
export const UNMOVED: Ground = { offset: [0, 0, 0], size: 1 };

/** The mean of how a figure stands in several shots, by their weights. */
export function meanGround(grounds: readonly (readonly [Ground, number])[]): Ground {
  const mean = (read: (ground: Ground) => number): number =>
    grounds.reduce((sum, [ground, weight]) => sum + weight * read(ground), 0);
  return {
    offset: [mean(({ offset }) => offset[0]), mean(({ offset }) => offset[1]), mean(({ offset }) => offset[2])],
    size: mean(({ size }) => size),
  };
}

/**
 * How a figure is moved, in its own metres, and enlarged to stand where it is seen: a head stays where heads are framed;
 * where a floor is seen all stand on it, as large as their people are. `size`: of its place.
 */
export function groundOf(
  figure: FramedFigure,
  shot: ShotSize,
  size: number,
  { pivot, headPlace }: CarriedHead,
): Ground {
  if (shot === "portrait" || shot === "head")
    return { offset: pivot.value.clone().sub(headPlace.value).toArray(), size: 1 };
  if (shot === "bust") return UNMOVED;
  const own = 1 / figure.size;
  return { offset: [0, FLOOR / (size * own) - figure.soles, 0], size: own };
}
