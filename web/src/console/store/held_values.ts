/** Whose value a control shows: the hand's while it is touched and a moment after, then what the server says. */

interface Held<Value> {
  value: Value;
  until: number;
  /** A step that no message has said yet: on a page that draws slowly the next one must begin from it. */
  unsent?: boolean;
}

/** The steps of a key or wheel that follow each other. */
interface Steps<Value> {
  /** What the server said before the first, and what was asked for since: none of it is news. */
  known: unknown[];
  /** What was asked for last. */
  last: Value;
  until: number;
}

/** Milliseconds for which the hand's last value stands after it let go: longer than any echo on a local network takes. */
export const ECHO = 300;

/** Steps whose echo may still be on its way. */
const MOST_STEPS = 256;
/** Milliseconds after a step for which the next begins from what it asked for, however late the server's answer is. */
const LATE = 5000;

export class HeldValues<Value> {
  readonly #held = new Map<string, Held<Value>>();
  readonly #steps = new Map<string, Steps<Value>>();

  /** The hand is on `key`, and stays. */
  grip(key: string, value: Value): void {
    this.#steps.delete(key);
    this.#held.set(key, { value, until: Number.POSITIVE_INFINITY });
  }

  /** The hand leaves `key`. */
  leave(key: string, now: number): void {
    const held = this.#held.get(key);
    if (held) held.until = now + ECHO;
  }

  /**
   * The value that a step by key or wheel begins from: what was asked for last, as long as the server, which says `echo`,
   * has said nothing else since; however late its answer is.
   */
  stepFrom(key: string, echo: Value, now: number): Value {
    const steps = this.#steps.get(key);
    if (steps !== undefined && now < steps.until && steps.known.includes(echo)) return steps.last;
    const last = this.read(key, echo, now);
    this.#steps.set(key, { known: [echo, last], last, until: now + LATE });
    return last;
  }

  /** One step by key or wheel, which nobody keeps holding; a grip stays a grip. */
  nudge(key: string, value: Value, now: number): void {
    const gripped = this.gripped(key);
    const steps = this.#steps.get(key);
    if (steps !== undefined)
      this.#steps.set(key, { known: [...steps.known, value].slice(-MOST_STEPS), last: value, until: now + LATE });
    this.#held.set(key, { value, until: gripped ? Number.POSITIVE_INFINITY : now + ECHO, unsent: true });
  }

  /** What the hands changed has been sent at `now`: its echo is on its way from now on. */
  sent(now: number): void {
    for (const held of this.#held.values()) {
      if (held.unsent && held.until !== Number.POSITIVE_INFINITY) held.until = now + ECHO;
      held.unsent = false;
    }
  }

  /** The value to show for `key`: the hand's own while it counts, else `echo`. */
  read<Echo>(key: string, echo: Echo, now: number): Value | Echo {
    const held = this.#held.get(key);
    const steps = this.#steps.get(key);
    if (steps !== undefined && Object.is(steps.last, echo)) steps.known = [echo]; // all was answered: whatever else comes is news
    if (held === undefined) return echo;
    if (held.unsent || now < held.until) return held.value;
    this.#held.delete(key);
    return echo;
  }

  gripped(key: string): boolean {
    return this.#held.get(key)?.until === Number.POSITIVE_INFINITY;
  }

  /** The hand holds `key` or has just left it. */
  counts(key: string, now: number): boolean {
    const held = this.#held.get(key);
    return held !== undefined && (held.unsent === true || now < held.until);
  }

  /** All hands off: panic, or a link that is lost. */
  clear(): void {
    this.#held.clear();
    this.#steps.clear();
  }
}
