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
