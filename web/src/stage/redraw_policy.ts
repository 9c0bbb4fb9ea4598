/** Decides which frames of a stage are drawn: those that show another picture than the last. */

/** Frames between two pictures of a scene that stands still: half a second at 60 Hz. */
const REFRESH = 30;
/** How often the same picture is drawn before it counts as standing still. */
const SURE = 3;

/**
 * A picture that stands still is not drawn again, but now and then. A software renderer has some frames queued at any
 * time; without those the first picture of what moves next is drawn at once.
 */
export class RedrawPolicy {
  #key = "";
  #same = 0;

  /** Whether to draw a frame that shows what `key` says; `settled`: nothing in the picture is coming or fading. */
  needed(key: string, settled: boolean): boolean {
    this.#same = settled && key === this.#key ? this.#same + 1 : 0;
    this.#key = key;
    return !this.still || (this.#same - SURE) % REFRESH === 0;
  }

  /** Whether the picture stands still. */
  get still(): boolean {
    return this.#same > SURE;
  }

  /** The picture is another one for another reason: its size, its context. */
  forget(): void {
    this.#same = 0;
    this.#key = "";
  }
}
