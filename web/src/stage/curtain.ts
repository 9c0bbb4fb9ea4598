/** How much of a stage's picture its audience sees: it comes up from black when it opens, and goes to black with the show. */

/** Seconds in which a stage comes up. */
const RISE = 0.5;
/** Seconds of a frame that count at most: the first frames of a page may take long, and then nobody has seen the way. */
const LONGEST_FRAME = 0.1;
/** Seconds after which a picture is shown of which something never comes. */
const PATIENCE = 10;

/**
 * A stage is black until its first picture is whole, comes up within half a second, and is as black as the show says.
 * What is behind the picture stays: black, or what a transparent stage lies over.
 */
export class Curtain {
  #waited = 0;
  #risen = 0;
  #shown: number | undefined;

  /** `show` takes how much of the picture is seen, 0..1. */
  constructor(private readonly show: (share: number) => void) {}

  /** Whether the stage has come up. */
  get open(): boolean {
    return this.#risen === 1;
  }

  /** The next frame, `seconds` after the last: how `black` the show is, 0..1; whether the picture is `whole`. */
  frame(black: number, seconds: number, whole: boolean): void {
    this.#waited += seconds;
    if (this.#risen > 0 || whole || this.#waited > PATIENCE)
      this.#risen = Math.min(1, this.#risen + Math.min(seconds, LONGEST_FRAME) / RISE);
    this.#show(black);
  }

  /** Is up at once: something is shown that is no show. */
  raise(black = 0): void {
    this.#risen = 1;
    this.#show(black);
  }

  #show(black: number): void {
    const eased = this.#risen * this.#risen * (3 - 2 * this.#risen);
    const share = eased * (1 - black);
    if (share !== this.#shown) this.show(share);
    this.#shown = share;
  }
}
