/** The server's clock, estimated from round trips. */

/** Seconds on this browser's monotonic clock. */
export const now = (): number => performance.now() / 1000;

interface Sample {
  offset: number;
  trip: number;
}

const KEPT = 16;

/** The server's clock as this browser knows it: of the last pings, the one with the shortest round trip counts. */
export class ServerClock {
  private samples: Sample[] = [];
  private guess: number | undefined;

  /** A pong: `time` is the server's, `sent` and `received` are ours, all in seconds. */
  measure(sent: number, time: number, received: number): void {
    const trip = received - sent;
    if (!Number.isFinite(trip) || !Number.isFinite(time) || trip < 0) return;
    this.samples = [...this.samples, { offset: time - (sent + received) / 2, trip }].slice(-KEPT);
  }

  /** A state that arrived: until the first pong, the freshest one bounds the offset from below. */
  arrived(time: number, received: number): void {
    if (Number.isFinite(time)) this.guess = Math.max(this.guess ?? -Infinity, time - received);
  }

  /** Forgets everything; a restarted server has another clock. */
  reset(): void {
    this.samples = [];
    this.guess = undefined;
  }

  /** Server time in seconds at our time `local`; undefined until something was heard. */
  at(local: number): number | undefined {
    const offset = this.offset();
    return offset === undefined ? undefined : local + offset;
  }

  private offset(): number | undefined {
    const [first, ...rest] = this.samples;
    if (first === undefined) return this.guess;
    return rest.reduce((best, sample) => (sample.trip < best.trip ? sample : best), first).offset;
  }
}
