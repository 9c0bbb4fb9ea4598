/** Counts frames: how many in the last second, and how long the last ones took. */
export class Rate {
  private times: number[] = [];

  tick(time: number): void {
    this.times.push(time);
    while ((this.times[0] as number) <= time - 1) this.times.shift();
  }

  /** Frames in the second before `time`. */
  at(time: number): number {
    return this.times.filter((drawn) => drawn > time - 1).length;
  }
}
