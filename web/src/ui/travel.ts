/** Where a control's travel meets its value: ranges, detents and steps. */

import { CHANNEL_RANGE } from "../link/constants";

export interface Range {
  readonly low: number;
  readonly high: number;
}

/** A channel's weight, as the engine takes it. */
export const CHANNEL: Range = { low: CHANNEL_RANGE[0], high: CHANNEL_RANGE[1] };
export const UNIT: Range = { low: 0, high: 1 };
/** Radians. A head turns further than it nods or tilts; eyes turn less than a head. */
export const HEAD_YAW: Range = { low: -0.8, high: 0.8 };
export const HEAD_PITCH: Range = { low: -0.5, high: 0.5 };
export const HEAD_ROLL: Range = { low: -0.5, high: 0.5 };
export const GAZE_YAW: Range = { low: -0.6, high: 0.6 };
export const GAZE_PITCH: Range = { low: -0.45, high: 0.45 };

/** Shift makes a drag, a wheel notch or a key this much finer. */
export const FINE = 0.1;

/** Half the width of the plateau of travel on which a channel stays at 0 and at 1. */
const DETENT = 0.04;

/** `value` held inside `range`; for a hand's travel only, never for a message. */
export function within(value: number, range: Range): number {
  return value < range.low ? range.low : value > range.high ? range.high : value;
}

/** The place of a value on its range: 0 at the low end, 1 at the high end. */
export function fractionOf(value: number, range: Range): number {
  return (value - range.low) / (range.high - range.low);
}

/** The value at a place of the range; the inverse of `fractionOf`. */
export function valueAt(fraction: number, range: Range): number {
  return range.low + fraction * (range.high - range.low);
}

/** The channel weight at a place of travel: continuous and rising, with plateaus at 0 and 1. */
export function weightAt(travel: number): number {
  if (travel < -DETENT) return CHANNEL.low + ((travel - CHANNEL.low) * -CHANNEL.low) / (-DETENT - CHANNEL.low);
  if (travel <= DETENT) return 0;
  if (travel < 1 - DETENT) return (travel - DETENT) / (1 - 2 * DETENT);
  if (travel <= 1 + DETENT) return 1;
  return 1 + ((travel - 1 - DETENT) * (CHANNEL.high - 1)) / (CHANNEL.high - 1 - DETENT);
}

/** The place of travel that gives a weight; in the middle of the plateau at 0 and 1. */
export function travelOf(weight: number): number {
  if (weight < 0) return CHANNEL.low + ((weight - CHANNEL.low) * (-DETENT - CHANNEL.low)) / -CHANNEL.low;
  if (weight === 0) return 0;
  if (weight < 1) return DETENT + weight * (1 - 2 * DETENT);
  if (weight === 1) return 1;
  return 1 + DETENT + ((weight - 1) * (CHANNEL.high - 1 - DETENT)) / (CHANNEL.high - 1);
}

/** The value one key press or wheel notch away; a step that crosses a stop (0, 1) rests on it once. */
export function stepped(value: number, step: number, range: Range, stops: readonly number[] = []): number {
  const next = value + step;
  for (const stop of stops) {
    if ((value < stop && next > stop) || (value > stop && next < stop)) return stop;
  }
  const rounded = Math.round(within(next, range) * 1e4) / 1e4;
  return rounded === 0 ? 0 : rounded; // no minus zero on the wire
}

/** A pad's rest, on its way back to the centre: what is left of `value` after `elapsed` milliseconds. */
export function sprung(value: number, elapsed: number): number {
  const left = value * Math.exp(-elapsed / SPRING);
  return Math.abs(left) < 0.002 ? 0 : left;
}

const SPRING = 70;

/**
 * Milliseconds after a panic until a spring moves: the panic has settled the face by then, and what the hand sent before
 * has arrived. A server that took over meanwhile cannot know that from a new play.
 */
export const LATE = 400;

/** What a spring moves: one number of a control. */
export interface Sprung {
  value(now: number): number;
  nudge(value: number): void;
}

/** Who else plays the control: `era` rises with each panic, `theirs`: a hand at another console is on it. */
export interface Others {
  readonly era: number;
  readonly theirs: boolean;
}

/**
 * Brings what was let go back to the centre. After a panic it does so where nobody else has been on the control since:
 * moves of the hand may have come after the panic. Times in milliseconds.
 */
export class Spring {
  #parts: readonly Sprung[] = [];
  #start = 0;
  #last = 0;
  /** The era in which the hand came, and the one heard last. */
  #begun = 0;
  #era = 0;
  /** Somebody else has been on the control since the last panic. */
  #taken = false;

  /** A hand comes; false in `held` once there has been a panic since. */
  grip(era: number): void {
    this.stop();
    this.#begun = era;
  }

  /** Whether the hand came after the last panic, so that what it does counts. */
  held(era: number): boolean {
    return this.#begun === era;
  }

  /** The hand lets go of some parts. */
  release(parts: readonly Sprung[], now: number, { era, theirs }: Others): void {
    const late = !this.held(era);
    if (late ? this.#taken || theirs : theirs) return;
    this.#parts = parts;
    this.wait(late ? now + LATE : now);
  }

  /** What is on its way stays where it is. */
  stop(): void {
    this.#parts = [];
  }

  /** Nothing moves before `start`. */
  wait(start: number): void {
    this.#start = Math.max(this.#start, start);
  }

  /** One step of the way, each frame. Nothing is sent of a part that is at rest: that would count as played. */
  move(now: number, others: Others): void {
    this.#listen(now, others);
    const elapsed = now - Math.max(this.#last, this.#start);
    this.#last = now;
    if (elapsed < 0) return;
    this.#parts = this.#parts.filter((part) => {
      const value = part.value(now);
      if (value === 0) return false;
      const rest = sprung(value, elapsed);
      part.nudge(rest);
      return rest !== 0;
    });
  }

  #listen(now: number, { era, theirs }: Others): void {
    if (era !== this.#era) {
      [this.#era, this.#taken] = [era, false];
      this.wait(now + LATE);
    }
    if (!theirs) return;
    this.#taken = true;
    if (!this.held(era)) this.stop();
  }
}
