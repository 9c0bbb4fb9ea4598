/** One animation frame for the whole page: what moves at the display's rate is written to CSS transforms here, never rendered. */

export interface Paintable {
  paint(now: number): void;
}

export class FramePainter {
  readonly #painted = new Set<Paintable>();
  #running = false;

  add(one: Paintable): void {
    this.#painted.add(one);
  }

  delete(one: Paintable): void {
    this.#painted.delete(one);
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
    for (const one of this.#painted) {
      try {
        one.paint(now);
      } catch (error) {
        reportError(error); // one widget that fails must not stop the others
      }
    }
  }
}
