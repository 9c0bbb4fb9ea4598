/** Counts frames: how many in the last second, and how long the last ones took. */
export class FrameRate {
  private times: number[] = [];

  tick(time: number): void {
    this.times.push(time);
    while (this.times.length > 2 && (this.times[0] as number) <= time - 1) this.times.shift();
  }

  /** Seconds between two frames, in the mean of the last ones: so long after it is drawn a picture is seen, too. */
  get interval(): number {
    const [first, last] = [this.times[0], this.times.at(-1)];
    return first === undefined || last === undefined ? 0 : (last - first) / Math.max(this.times.length - 1, 1);
  }

  /** Frames in the second before `time`; a part of one where frames take longer than that. */
  at(time: number): number {
    const [last, before] = [this.times.at(-1), this.times.at(-2)];
    const interval = last === undefined || before === undefined ? 0 : Math.max(last - before, time - last);
    return interval > 1 ? 1 / interval : this.times.filter((drawn) => drawn > time - 1).length;
  }
}
