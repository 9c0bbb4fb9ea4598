/** Thumbnails: one picture at a time, in the order they were asked for, so that the page is usable at once. */

/** What a thumbnail shows. */
export interface ThumbnailSubject {
  readonly face: string;
  readonly expression: string;
}

/** The size of a thumbnail in pixels; sharp on a display of one and a half. */
export const THUMBNAIL_SIZE = { width: 130, height: 120 } as const;

/** Draws a subject as a picture of its own; may wait for its shapes to be loaded. Rejects when it cannot be drawn. */
export type DrawThumbnail = (subject: ThumbnailSubject) => Promise<CanvasImageSource>;

/** Milliseconds between two pictures: the show goes first. */
const PAUSE = 40;
/** Pictures kept, so that a palette opens at once the second time. */
const KEPT = 500;

export class Thumbnails {
  readonly #waiting = new Map<HTMLCanvasElement, ThumbnailSubject>();
  readonly #done = new WeakMap<HTMLCanvasElement, string>();
  readonly #cache = new Map<string, CanvasImageSource>();
  #drawer: DrawThumbnail | null = null;
  #working = false;

  constructor(private readonly pause: () => Promise<void> = () => new Promise((done) => setTimeout(done, PAUSE))) {}

  /** Pictures can be drawn from now on; what was asked for before is drawn now. */
  open(draw: DrawThumbnail): void {
    this.#drawer = draw;
    void this.#work();
  }

  /** Asks for a picture on `canvas`; a newer wish for the same canvas replaces an older. */
  ask(canvas: HTMLCanvasElement, subject: ThumbnailSubject): void {
    if (this.#done.get(canvas) === keyOf(subject)) {
      this.#waiting.delete(canvas);
      return;
    }
    const known = this.#cache.get(keyOf(subject));
    if (known !== undefined) {
      this.#waiting.delete(canvas);
      this.#show(canvas, subject, known);
      return;
    }
    this.#waiting.set(canvas, subject);
    void this.#work();
  }

  async #work(): Promise<void> {
    if (this.#working || this.#drawer === null) return;
    this.#working = true;
    for (let next = this.#next(); next !== null; next = this.#next()) {
      const [canvas, subject] = next;
      await this.#draw(canvas, subject, this.#drawer);
      await this.pause();
    }
    this.#working = false;
  }

  /** The first wish whose canvas still is on the page. */
  #next(): [HTMLCanvasElement, ThumbnailSubject] | null {
    for (const [canvas, subject] of this.#waiting) {
      this.#waiting.delete(canvas);
      if (canvas.isConnected) return [canvas, subject];
    }
    return null;
  }

  async #draw(canvas: HTMLCanvasElement, subject: ThumbnailSubject, draw: DrawThumbnail): Promise<void> {
    try {
      const picture = this.#cache.get(keyOf(subject)) ?? (await draw(subject));
      this.#keep(subject, picture);
      if (!this.#waiting.has(canvas)) this.#show(canvas, subject, picture); // else something newer is wished for
    } catch (error) {
      console.warn(`No portrait of ${keyOf(subject)}:`, error); // the tile keeps its name, which is enough to play
    }
  }

  #keep(subject: ThumbnailSubject, picture: CanvasImageSource): void {
    this.#cache.set(keyOf(subject), picture);
    const [oldest] = this.#cache.keys();
    if (this.#cache.size > KEPT && oldest !== undefined) this.#cache.delete(oldest);
  }

  #show(canvas: HTMLCanvasElement, subject: ThumbnailSubject, picture: CanvasImageSource): void {
    const context = canvas.getContext("2d");
    if (context === null) return;
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(picture, 0, 0, canvas.width, canvas.height);
    canvas.dataset.drawn = keyOf(subject);
    this.#done.set(canvas, keyOf(subject));
  }
}

const keyOf = ({ face, expression }: ThumbnailSubject): string => `${face} ${expression}`;
