/** The playout clock of a stage: how far behind the server's clock it draws (the delay of a jitter buffer). */

/** Waits for a new state that count: two seconds of them. */
const KEPT = 120;
/** The share of the waits that the delay covers: nearly all, not the odd one. */
const COVERED = 0.95;
/** Seconds more than that. */
const SPARE = 0.001;
/** Seconds in which the delay goes most of the way to what is wanted. */
const GLIDE = 0.1;
/** Seconds per second by which playout is at most slower, and faster, while something moves. */
const SLOWER = 0.5;
const FASTER = 0.1;
/** Seconds per second by which it is at most faster after a pause of the link, until it is no later than allowed. */
const CATCHING_UP = 1;
/** Seconds without a change from which on a rest is skipped; a source of 30 Hz, which changes every other state, has none. */
const REST = 0.1;
/** Seconds behind from which on playout begins anew. */
const LOST = 0.5;

/** Server time in which all states show the same. */
interface Rest {
  from: number;
  to: number;
}

/**
 * Which server time a stage draws. While something moves it is as far behind as states are usually late when a frame
 * wants them, and time runs on evenly; where a state is later than that it stands still, and is later from then on.
 * A rest takes no time: whether its states are drawn cannot be seen, so that what comes after it is drawn at once. (The
 * playout of speech over a network adapts in its silences for the same reason: Ramjee et al., Adaptive Playout Mechanisms
 * for Packetized Audio Applications in Wide-Area Networks, 1994.)
 */
export class PlayoutClock {
  #waits: number[] = [];
  #rests: Rest[] = [];
  #due: number | undefined;
  #fresh = false;

  /** `longest`: seconds of delay at most. */
  constructor(private readonly longest: number) {}

  /** A state of server time `time`, in seconds, arrived; `same`: it shows what the one before shows. */
  arrived(time: number, same: boolean): void {
    const last = this.#rests.at(-1);
    if (last !== undefined && time <= last.to) this.#rests = []; // another clock
    if (time <= (this.#due ?? -Infinity)) this.#due = undefined;
    this.#fresh = true;
    if (same && last !== undefined && this.#rests.length > 0) last.to = time;
    else this.#rests = [...this.#rests.filter(isRest), { from: time, to: time }];
  }

  /** The server time to draw, `seconds` after the last frame, when the server's clock shows `server`. */
  at(server: number, seconds: number): number {
    const newest = this.#rests.at(-1)?.to ?? server;
    this.#note(server - newest);
    const due = this.#due === undefined || server - this.#due > LOST ? -Infinity : this.#afterRest(this.#due);
    const aim = server - this.delay;
    this.#due = Math.min(newest, due === -Infinity ? aim : due + seconds * this.#speed(aim, due + seconds, seconds));
    return this.#due;
  }

  /** A frame finds the newest state `wait` seconds old; frames that find no newer one are the same wait. */
  #note(wait: number): void {
    if (!this.#fresh) this.#waits.pop();
    this.#waits.push(wait);
    if (this.#waits.length > KEPT) this.#waits.shift();
    this.#fresh = false;
  }

  /** The delay that is wanted, seconds: how far behind the server what moves is drawn. */
  get delay(): number {
    const waits = [...this.#waits].sort((a, b) => a - b);
    const usual = waits[Math.floor(COVERED * waits.length)] ?? this.longest;
    return Math.min(this.longest, Math.max(0, usual) + SPARE);
  }

  /** The time after the rest in which `due` lies. */
  #afterRest(due: number): number {
    const currentRest = this.#rests.find((rest) => isRest(rest) && rest.from <= due && due < rest.to);
    this.#rests = this.#rests.filter((rest, at) => rest.to > due || at === this.#rests.length - 1);
    return currentRest?.to ?? due;
  }

  /** How fast time runs, so that from `next` on, where a second a second would lead, it glides to `aim`. */
  #speed(aim: number, next: number, seconds: number): number {
    if (seconds <= 0) return 1;
    const wanted = ((aim - next) * -Math.expm1(-seconds / GLIDE)) / seconds;
    const late = aim - next + this.delay - this.longest;
    const faster = Math.min(CATCHING_UP, Math.max(FASTER, late / GLIDE));
    return 1 + Math.min(faster, Math.max(-SLOWER, wanted));
  }
}

const isRest = ({ from, to }: Rest): boolean => to - from >= REST;
