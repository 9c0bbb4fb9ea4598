/** Chooses the best picture of each direction from all that pass by. */

import { DIRECTIONS, type Direction, type DirectionName, directionAt } from "./turn_directions";

/** Good pictures of a direction after which it is not waited for: the best of so many. */
export const ENOUGH = 3;

/** What is known of a picture without a fault. */
export interface FrameQuality {
  readonly yaw: number;
  /** 0..1, how sharp its face is. */
  readonly sharpness: number;
  /** 0..1, how still; 0 moves as fast as is taken at all. */
  readonly stillness: number;
}

interface Kept<Picture> {
  readonly picture: Picture;
  readonly score: number;
  readonly seen: number;
}

/** Keeps one picture of each direction, and lets go of all others. */
export class FrameChoice<Picture> {
  readonly #kept = new Map<DirectionName, Kept<Picture>>();

  /** let: what is done with a picture that is not kept, or not any more. */
  constructor(private readonly release: (picture: Picture) => void) {}

  /** Offers a picture without a fault; the direction whose picture it is now, null where it is not kept. */
  offer(picture: Picture, quality: FrameQuality): DirectionName | null {
    const direction = directionAt(quality.yaw);
    const before = direction === null ? undefined : this.#kept.get(direction.name);
    const score = direction === null ? 0 : scoreOf(quality, direction);
    const better = direction !== null && (before === undefined || score > before.score);
    if (direction !== null) {
      const best = better ? { picture, score } : (before as Kept<Picture>);
      this.#kept.set(direction.name, { ...best, seen: (before?.seen ?? 0) + 1 });
    }
    if (!better) this.release(picture);
    else if (before !== undefined) this.release(before.picture);
    return better ? direction.name : null;
  }

  /** How far a direction is, 0..1; 1: it is not waited for any more. */
  share(name: DirectionName): number {
    return Math.min(1, (this.#kept.get(name)?.seen ?? 0) / ENOUGH);
  }

  /** The directions that are still waited for. */
  get wanted(): ReadonlySet<DirectionName> {
    return new Set(DIRECTIONS.map(({ name }) => name).filter((name) => this.share(name) < 1));
  }

  /** What is kept, in the order of the directions. */
  get all(): readonly (readonly [DirectionName, Picture])[] {
    return DIRECTIONS.flatMap(({ name }) => {
      const kept = this.#kept.get(name);
      return kept === undefined ? [] : [[name, kept.picture] as const];
    });
  }

  /** Lets go of all. */
  clear(): void {
    for (const { picture } of this.#kept.values()) this.release(picture);
    this.#kept.clear();
  }
}

/** Sharp before all; of pictures as sharp, the stiller one and the one that is turned as it should be. */
const scoreOf = ({ yaw, sharpness, stillness }: FrameQuality, direction: Direction): number =>
  sharpness * (0.7 + 0.3 * stillness) * (1 - (0.25 * Math.abs(yaw - direction.yaw)) / direction.reach);
