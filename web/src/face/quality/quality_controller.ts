/** Chooses the level of quality from the frames that were late or early. */

import { LEVELS } from "../../link/constants";
import type { Level } from "./quality_levels";

/** Seconds of frames that are judged together, and how many they are at least. */
const WINDOW = 0.5;
const FEWEST = 8;
/** Seconds between frames, in the median, above which they are late: 50 a second. */
const LATE = 1 / 50;
/** A pause longer than this, in seconds, is a hidden page, not a slow one. */
const PAUSE = 0.5;
/** Seconds for which late frames are borne while something moves on air. */
const PATIENCE = 2;
/** Seconds of head-room at rest before the next level is tried. */
const TRIAL = 4;
/** Seconds after a change until a level has proved itself: whoever draws less from then on hides nothing. */
const PROVED = 8;
/** Seconds after a change in which frames are not judged: shaders are compiled, textures made. */
const UNJUDGED = 1;
/** How often a level may prove too much before it is not tried again. */
const CHANCES = 2;
/** Looks at the machine that are judged together, and how many of them must have found it done. */
const LOOKS = 8;
const CLEAR = 0.85;

/** What is known of one frame. */
export interface FrameReport {
  /** Seconds since the frame before. */
  interval: number;
  /** Whether the machine was done with its picture in half of the time it has; undefined: nobody looked. */
  early: boolean | undefined;
  /** Nothing moves on air, so that a change disturbs nobody. */
  calm: boolean;
}

/**
 * The level that a machine keeps up with: down within a second when frames are late, up only at rest and after seconds
 * of clear head-room, and no more than twice to a level that proved too much, so that it comes to rest.
 */
export class QualityController {
  private intervals: number[] = [];
  private looks: boolean[] = [];
  private lateFor = 0;
  private spareFor = 0;
  private unjudged = UNJUDGED;
  private unproved = PROVED;
  private readonly failures = new Map<Level, number>();

  constructor(public level: Level) {}

  /** The level after one more frame. */
  after({ interval, early, calm }: FrameReport): Level {
    if (interval > PAUSE) return this.level;
    this.unjudged -= interval;
    this.unproved -= interval;
    if (this.unjudged > 0) return this.level;
    this.keep(interval, early);
    if (this.intervals.length < FEWEST) return this.level;
    this.lateFor = median(this.intervals) > LATE && !this.waits ? this.lateFor + interval : 0;
    this.spareFor = this.waits && this.looks.length === LOOKS && calm ? this.spareFor + interval : 0;
    if (this.lateFor > (calm ? 0 : PATIENCE)) this.down();
    else if (this.spareFor > TRIAL) this.up();
    return this.level;
  }

  /** Whether the level has proved itself since it was chosen: frames need not be drawn only to judge it. */
  get proved(): boolean {
    return this.unproved <= 0;
  }

  /** Another size of picture: what proved too much may not be so now. */
  forget(): void {
    this.failures.clear();
    this.unproved = PROVED;
    this.rest();
  }

  /** The machine waits for its display; one of 30 Hz shows frames late, too. */
  private get waits(): boolean {
    return this.looks.length > 0 && this.looks.filter((early) => early).length >= CLEAR * this.looks.length;
  }

  private keep(interval: number, early: boolean | undefined): void {
    this.intervals.push(interval);
    let sum = this.intervals.reduce((total, interval) => total + interval, 0);
    while (sum > WINDOW && this.intervals.length > FEWEST) sum -= this.intervals.shift() as number;
    if (early === undefined) return;
    this.looks.push(early);
    if (this.looks.length > LOOKS) this.looks.shift();
  }

  private down(): void {
    this.failures.set(this.level, (this.failures.get(this.level) ?? 0) + 1);
    this.change(LEVELS[LEVELS.indexOf(this.level) - 1]);
  }

  private up(): void {
    const above = LEVELS[LEVELS.indexOf(this.level) + 1];
    if (above !== undefined && (this.failures.get(above) ?? 0) < CHANCES) this.change(above);
  }

  private change(level: Level | undefined): void {
    if (level !== undefined) this.unproved = PROVED;
    this.level = level ?? this.level;
    this.rest();
  }

  private rest(): void {
    this.intervals = [];
    this.looks = [];
    this.lateFor = 0;
    this.spareFor = 0;
    this.unjudged = UNJUDGED;
  }
}

const median = (values: readonly number[]): number => [...values].sort((a, b) => a - b)[values.length >> 1] as number;
