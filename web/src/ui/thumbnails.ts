/** Thumbnails: one picture at a time, in the order they were asked for, so that the page is usable at once. */

/** What a thumbnail shows. */
export interface ThumbnailSubject {
  readonly face: string;
  readonly expression: string;
  /** A hair style, "" none, that the face is to wear in place of its own: the picture shows the whole head. */
  readonly hair?: string;
  /** A pose that its figure is to do: the picture shows all of it. */
  readonly pose?: string;
}

/** The size of a thumbnail in pixels; sharp on a display of one and a half. */
export const THUMBNAIL_SIZE = { width: 130, height: 120 } as const;

/** Draws a subject as a picture of its own; may wait for its shapes to be loaded. Rejects when it cannot be drawn. */
export type DrawThumbnail = (subject: ThumbnailSubject) => Promise<CanvasImageSource>;

/** The expression of a face at rest. */
const NEUTRAL = "neutral";
/** Milliseconds between two pictures: the show goes first. */
const PAUSE = 40;
/** Attempts at one picture: a graphics context that is lost for a moment is there again soon. */
const TRIES = 5;
/** Milliseconds, doubled with each attempt that failed. */
const REST = 250;
const after = (milliseconds: number): Promise<void> => new Promise((done) => setTimeout(done, milliseconds));
/** Pictures kept, so that a palette opens at once the second time. */
const KEPT = 500;

export class Thumbnails {
  readonly #waiting = new Map<HTMLCanvasElement, ThumbnailSubject>();
  /** What was asked for last, by canvas: a picture of anything else comes too late. */
  readonly #wanted = new WeakMap<HTMLCanvasElement, string>();
  readonly #failures = new Map<string, number>();
  readonly #done = new WeakMap<HTMLCanvasElement, string>();
  readonly #cache = new Map<string, CanvasImageSource>();
  #drawer: DrawThumbnail | null = null;
  #working = false;

  /** `pause`: between two pictures; `rest`: before an attempt after so many that failed. */
  constructor(
    private readonly pause: () => Promise<void> = () => after(PAUSE),
    private readonly rest: (failures: number) => Promise<void> = (failures) => after(REST * 2 ** failures),
  ) {}

  /** Pictures can be drawn from now on; what was asked for before is drawn now. */
  open(draw: DrawThumbnail): void {
    this.#drawer = draw;
    void this.#work();
  }

  /** Takes pictures that are there already, and shows those that were asked for before. */
  give(pictures: Iterable<readonly [ThumbnailSubject, CanvasImageSource]>): void {
    for (const [subject, picture] of pictures) this.#keep(subject, picture);
    for (const [canvas, subject] of [...this.#waiting]) this.ask(canvas, subject);
  }

  /**
   * Asks for a picture on `canvas`; a newer wish for the same canvas replaces an older. Until the picture of another face is
   * there, that face at rest stands in for it; where that is not known, what hangs there fades at once.
   */
  ask(canvas: HTMLCanvasElement, subject: ThumbnailSubject): void {
    this.#wanted.set(canvas, keyOf(subject));
    if (this.#done.get(canvas) === keyOf(subject)) {
      this.#fade(canvas);
      this.#waiting.delete(canvas);
      return;
    }
    const cached = this.#cache.get(keyOf(subject));
    if (cached !== undefined) {
      this.#waiting.delete(canvas);
      this.#show(canvas, subject, cached);
      return;
    }
    if (subject.hair === undefined && subject.pose === undefined) this.#standIn(canvas, subject.face);
    else this.#fade(canvas);
    this.#waiting.set(canvas, subject);
    void this.#work();
  }

  #standIn(canvas: HTMLCanvasElement, face: string): void {
    const rest = { face, expression: NEUTRAL };
    const [picture, hangs] = [this.#cache.get(keyOf(rest)), this.#done.get(canvas)];
    if (picture !== undefined && hangs?.startsWith(`${face} `) !== true) this.#show(canvas, rest, picture);
    else this.#fade(canvas);
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
      if (this.#wanted.get(canvas) === keyOf(subject)) this.#show(canvas, subject, picture);
    } catch (error) {
      this.#retry(canvas, subject, error);
    }
  }

  /** Asks once more, later and later; what fails for good leaves a name, which is enough to play. */
  #retry(canvas: HTMLCanvasElement, subject: ThumbnailSubject, error: unknown): void {
    const key = keyOf(subject);
    const failures = (this.#failures.get(key) ?? 0) + 1;
    this.#failures.set(key, failures);
    if (failures >= TRIES) console.warn(`No thumbnail of ${key}:`, error);
    else
      void this.rest(failures).then(() => {
        if (this.#wanted.get(canvas) === key) this.ask(canvas, subject);
      });
  }

  /** A picture of what the canvas no longer stands for is seen to be old until the new one comes. */
  #fade(canvas: HTMLCanvasElement): void {
    const [drawn, wanted] = [this.#done.get(canvas), this.#wanted.get(canvas)];
    const stands = drawn === undefined || drawn === wanted || drawn === standInOf(wanted);
    canvas.style.opacity = stands ? "" : "0.25";
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
    this.#failures.delete(keyOf(subject));
    this.#fade(canvas);
  }
}

/** The picture that may stand in for one: the same face at rest. */
const standInOf = (wanted: string | undefined): string | undefined => wanted?.replace(/ .*$/, ` ${NEUTRAL}`);

function keyOf({ face, expression, hair, pose }: ThumbnailSubject): string {
  const worn = hair === undefined ? "" : ` with ${hair || "no hair"}`;
  return `${face} ${expression}${worn}${pose === undefined ? "" : ` posed ${pose}`}`;
}
