/** Thumbnails: one picture at a time, in the order they were asked for, so that the page is usable at once. */

/** What a thumbnail shows. */
export interface Sitting {
  readonly face: string;
  readonly expression: string;
}

/** The size of a thumbnail in pixels; sharp on a display of one and a half. */
export const PICTURE = { width: 130, height: 120 } as const;

/** Draws a sitting as a picture of its own; may wait for its shapes to be loaded. Rejects when it cannot be drawn. */
export type Studio = (sitting: Sitting) => Promise<CanvasImageSource>;

/** Milliseconds between two pictures: the show goes first. */
const PAUSE = 40;
/** Pictures kept, so that a palette opens at once the second time. */
const KEPT = 500;

export class Portraits {
  readonly #waiting = new Map<HTMLCanvasElement, Sitting>();
  readonly #done = new WeakMap<HTMLCanvasElement, string>();
  readonly #album = new Map<string, CanvasImageSource>();
  #studio: Studio | null = null;
  #working = false;

  constructor(private readonly pause: () => Promise<void> = () => new Promise((done) => setTimeout(done, PAUSE))) {}

  /** The studio is ready; what was asked for before is drawn now. */
  open(studio: Studio): void {
    this.#studio = studio;
    void this.#work();
  }

  /** Asks for a picture on `canvas`; a newer wish for the same canvas replaces an older. */
  ask(canvas: HTMLCanvasElement, sitting: Sitting): void {
    if (this.#done.get(canvas) === keyOf(sitting)) {
      this.#waiting.delete(canvas);
      return;
    }
    const known = this.#album.get(keyOf(sitting));
    if (known !== undefined) {
      this.#waiting.delete(canvas);
      this.#hang(canvas, sitting, known);
      return;
    }
    this.#waiting.set(canvas, sitting);
    void this.#work();
  }

  async #work(): Promise<void> {
    if (this.#working || this.#studio === null) return;
    this.#working = true;
    for (let next = this.#next(); next !== null; next = this.#next()) {
      const [canvas, sitting] = next;
      await this.#draw(canvas, sitting, this.#studio);
      await this.pause();
    }
    this.#working = false;
  }

  /** The first wish whose canvas still is on the page. */
  #next(): [HTMLCanvasElement, Sitting] | null {
    for (const [canvas, sitting] of this.#waiting) {
      this.#waiting.delete(canvas);
      if (canvas.isConnected) return [canvas, sitting];
    }
    return null;
  }

  async #draw(canvas: HTMLCanvasElement, sitting: Sitting, studio: Studio): Promise<void> {
    try {
      const picture = this.#album.get(keyOf(sitting)) ?? (await studio(sitting));
      this.#keep(sitting, picture);
      if (!this.#waiting.has(canvas)) this.#hang(canvas, sitting, picture); // else something newer is wished for
    } catch (error) {
      console.warn(`No portrait of ${keyOf(sitting)}:`, error); // the tile keeps its name, which is enough to play
    }
  }

  #keep(sitting: Sitting, picture: CanvasImageSource): void {
    this.#album.set(keyOf(sitting), picture);
    const [oldest] = this.#album.keys();
    if (this.#album.size > KEPT && oldest !== undefined) this.#album.delete(oldest);
  }

  #hang(canvas: HTMLCanvasElement, sitting: Sitting, picture: CanvasImageSource): void {
    const context = canvas.getContext("2d");
    if (context === null) return;
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(picture, 0, 0, canvas.width, canvas.height);
    canvas.dataset.drawn = keyOf(sitting);
    this.#done.set(canvas, keyOf(sitting));
  }
}

const keyOf = ({ face, expression }: Sitting): string => `${face} ${expression}`;
