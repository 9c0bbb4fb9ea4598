/** A jitter buffer: how far behind the server a stage draws. */

const KEPT = 90; // states, a second and a half
const SPARE = 0.001; // seconds
const SLEW = 0.02; // seconds per second: the delay glides, so that the picture never jerks

/** How far behind the server to draw: one state interval, and as late as nearly all states come. */
export class JitterBuffer {
  private late: number[] = [];
  private delay: number;

  constructor(
    private readonly interval: number,
    private readonly longest: number,
  ) {
    this.delay = Math.min(longest, 1.5 * interval);
  }

  /** A state arrived `late` seconds after its own time. */
  arrived(late: number): void {
    this.late.push(late);
    if (this.late.length > KEPT) this.late.shift();
  }

  /** The delay in seconds, `seconds` after it was last asked for. */
  after(seconds: number): number {
    if (this.late.length < 10) return this.delay;
    const usual = [...this.late].sort((a, b) => a - b)[Math.floor(0.95 * this.late.length)] as number;
    const wanted = Math.min(this.longest, this.interval + Math.max(0, usual) + SPARE);
    this.delay += Math.min(SLEW * seconds, Math.max(-SLEW * seconds, wanted - this.delay));
    return this.delay;
  }
}
