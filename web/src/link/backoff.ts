/** The pauses between attempts to reconnect. */

/** Waits between attempts: 50 ms at first, doubling up to half a second, each jittered by half, for ever. */
export class Backoff {
  private attempt = 0;

  constructor(
    private readonly first = 0.05,
    private readonly longest = 0.5,
    private readonly random: () => number = Math.random,
  ) {}

  /** Seconds to wait before the next attempt. */
  next(): number {
    const wait = Math.min(this.longest, this.first * 2 ** this.attempt);
    this.attempt = Math.min(this.attempt + 1, 30);
    return wait * (0.5 + this.random());
  }

  /** After a success. */
  reset(): void {
    this.attempt = 0;
  }
}
