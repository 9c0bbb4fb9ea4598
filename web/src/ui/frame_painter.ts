/** One animation frame for the whole page: what moves at the display's rate is written to CSS transforms here, never rendered. */

export interface Painted {
  paint(now: number): void;
}

export class Painter {
  readonly #painted = new Set<Painted>();
  #running = false;

  add(one: Painted): void {
    this.#painted.add(one);
  }

  delete(one: Painted): void {
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
