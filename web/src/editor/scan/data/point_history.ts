/** Points that people set step by step: what can be undone and done again, and by which of them a face was fitted. */
export class PointHistory<Points> {
  protected now: Points;
  /** The points by which the face that is shown was fitted. */
  protected fittedBy: Points;
  protected readonly past: Points[] = [];
  #future: Points[] = [];

  constructor(first: Points) {
    [this.now, this.fittedBy] = [first, first];
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  undo(): void {
    this.#step(this.past, this.#future);
  }

  redo(): void {
    this.#step(this.#future, this.past);
  }

  /** What is set now has been fitted. */
  fitted(): void {
    this.fittedBy = this.now;
  }

  /** Sets other points; what follows within one drag is one step: `same`. */
  protected put(points: Points, same: boolean): void {
    if (!same) this.past.push(this.now);
    this.#future = [];
    this.now = points;
  }

  #step(from: Points[], to: Points[]): void {
    const points = from.pop();
    if (points === undefined) return;
    const before = this.now;
    to.push(before);
    this.now = points;
    this.stepped(before);
  }

  /** A step was taken back or done again. */
  protected stepped(_before: Points): void {}
}
