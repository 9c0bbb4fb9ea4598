/** One animation frame for the whole page: what moves at the display's rate is written to CSS transforms here, never rendered. */

export interface Paintable {
  paint(now: number): void;
}

export class FramePainter {
  readonly #painted = new Set<Paintable>();
  #running = false;

  add(paintable: Paintable): void {
    this.#painted.add(paintable);
  }

  delete(paintable: Paintable): void {
    this.#painted.delete(paintable);
  }

  start(): void {
    if (this.#running) return;
    this.#running = true;
    const frame = (now: number): void => {
      requestAnimationFrame(frame);
      this.paint(now);
    };
    requestAnimationFrame(frame);
  }

  paint(now: number): void {
    for (const paintable of this.#painted) {
      try {
        paintable.paint(now);
      } catch (error) {
        reportError(error); // one widget that fails must not stop the others
      }
    }
  }
}
