/** Lets only the newest state through. */

/** What orders states: the server's start, then the count since. */
export interface Stamp {
  epoch: number;
  number: number;
}

/** Lets only states through that are newer than all before: a lower (epoch, number) is ignored. */
export class Newest {
  private last: Stamp = { epoch: -Infinity, number: -Infinity };
  /** How many states came too late. */
  ignored = 0;

  accept(stamp: Stamp): boolean {
    const { epoch, number } = this.last;
    const newer = stamp.epoch > epoch || (stamp.epoch === epoch && stamp.number > number);
    if (newer) this.last = { epoch: stamp.epoch, number: stamp.number };
    else this.ignored += 1;
    return newer;
  }
}
