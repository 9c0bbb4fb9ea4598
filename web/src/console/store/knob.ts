/** A value that a hand can hold. */

/** One number under a hand. */
export interface Knob {
  readonly key: string;
  /** The value to show at `now`: the hand's own while it counts, else the server's. */
  value(now: number): number;
  /** The hand holds the knob at `value`. */
  grip(value: number): void;
  /** One step by key or wheel. */
  nudge(value: number): void;
  leave(): void;
}
