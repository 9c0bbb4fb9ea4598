/** Reads the playing hand of each picture by its calibration; the other hand is a point. */

import { type HandCalibration, handSample, readHand } from "./hand_calibration";
import { HAND_AXES, type HandAxes } from "./hand_guide";
import type { FoundHand, Hands } from "./hand_messages";
import { OneEuroFilter } from "./one_euro";
import { widthAngle } from "./palm";

/** What a picture shows of the playing hand. */
export interface HandReading {
  /** Seconds of the page's clock. */
  time: number;
  /** Its place among the hands of the picture, -1 where it is not seen. */
  playing: number;
  /** What it does; null where it is not seen, or not calibrated. */
  axes: HandAxes | null;
  /** Where its wrist is, -1 to 1, right and up as in a mirror. */
  place: readonly [number, number] | null;
  /** Where the other hand is, the same. */
  other: readonly [number, number] | null;
  /** Whether the fingers of the playing hand point left in a mirror; null where it is not seen. */
  leftward: boolean | null;
  /** Whether it has been turned to the lens, or from it, for some seconds. */
  turned: boolean;
  /** Seconds for which it has not been seen, 0 where it is. */
  away: number;
}

/** Seconds without a hand after which somebody is told what to do. */
const LONG_AWAY = 3;

/** What is to be done where no hand has been seen for so many seconds; "" where that is not long. */
export const adviseOnAbsence = (away: number): string =>
  away < LONG_AWAY
    ? ""
    : "Hold the whole hand, wrist too, in the middle of the picture, in profile, an arm's length from the camera. If it is there: more light from the front, a plain background, nothing else that is skin.";

/** The point of a hand at which its middle finger begins. */
const KNUCKLE = 9;
/** Radians between the palms' widths at which a hand counts as turned: its opening is then read with r .83 in place of .97. */
export const TURNED = (20 * Math.PI) / 180;
/** Seconds in which a lasting turn counts; the turns of play come and go. */
const TURN_SECONDS = 4;
/** Of the picture: how far a hand goes from one picture to the next, before another that is nearer is taken for it. */
const NEAR = 0.25;
/** Seconds after which a hand that is gone may come back anywhere. */
const FORGET_SECONDS = 1.5;

type Place = readonly [number, number];

const wristOf = ({ image }: FoundHand): Place => [image[0] ?? 0, image[1] ?? 0];
const apart = (a: Place, b: Place): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** The playing hand from picture to picture. */
export class HandTracker {
  #place: Place | null = null;
  #seen = Number.NEGATIVE_INFINITY;
  /** When it was seen last, or else the first picture came. */
  #here = Number.NaN;
  #turn = 0;
  #turnTime = Number.NaN;
  readonly #filter = new OneEuroFilter();
  readonly #otherFilter = new OneEuroFilter();

  constructor(readonly calibration: HandCalibration | null) {}

  /** What a picture shows. */
  read(hands: Hands): HandReading {
    const time = hands.time / 1000;
    const playing = this.#choose(hands.hands, time);
    const hand = hands.hands[playing];
    if (hand !== undefined) [this.#place, this.#seen] = [wristOf(hand), time];
    if (hand !== undefined || Number.isNaN(this.#here)) this.#here = time;
    const other = hands.hands.find((_, place) => place !== playing);
    return {
      time,
      playing,
      axes: hand === undefined ? null : this.#axes(hand, hands, time),
      place: hand === undefined ? null : mirrored(wristOf(hand)),
      leftward: hand === undefined ? null : (hand.image[3 * KNUCKLE] ?? 0) > (hand.image[0] ?? 0),
      other: other === undefined || playing < 0 ? null : this.#point(other, time),
      turned: hand !== undefined && this.#turn > TURNED,
      away: time - this.#here,
    };
  }

  /** Which hand plays: the one that is nearest to where it was; of hands that come anew the calibrated one by its side, else by its place. */
  #choose(hands: readonly FoundHand[], time: number): number {
    if (hands.length === 0) return -1;
    const before = time - this.#seen < FORGET_SECONDS ? this.#place : null;
    if (before !== null) {
      const nearest = nearestTo(hands, before);
      const hand = hands[nearest];
      return hand !== undefined && apart(wristOf(hand), before) < NEAR * Math.max(1, 8 * (time - this.#seen))
        ? nearest
        : -1;
    }
    if (this.calibration === null || hands.length === 1) return 0;
    const { side, place } = this.calibration;
    const alike = hands.filter((hand) => hand.side === side);
    return alike.length === 1 ? hands.indexOf(alike[0] as FoundHand) : nearestTo(hands, place);
  }

  #axes(hand: FoundHand, { width, height }: Hands, time: number): HandAxes | null {
    const sample = handSample(hand, width, height, time);
    if (this.calibration === null || sample === null) return null;
    this.#watchTurn(widthAngle(sample.palms[1], this.calibration.palms[1]), time);
    const values = this.#filter.follow(readHand(this.calibration, sample), time);
    return Object.fromEntries(HAND_AXES.map((axis, place) => [axis, values[place] ?? 0])) as HandAxes;
  }

  /** Follows how far the hand is turned, so slowly that only what lasts counts. */
  #watchTurn(angle: number, time: number): void {
    const gap = time - this.#turnTime;
    this.#turnTime = time;
    if (gap > 0 && gap < 1) this.#turn += (gap / (TURN_SECONDS + gap)) * (angle - this.#turn);
  }

  #point(hand: FoundHand, time: number): Place {
    const [x = 0, y = 0] = this.#otherFilter.follow(mirrored(wristOf(hand)), time);
    return [x, y];
  }
}

/** A place of a picture as a point of a pad, -1 to 1: right as in a mirror, up. The outer fifth is no way: hands leave the picture there. */
const mirrored = ([x, y]: Place): Place => [inside(-(x - 0.5) * 2.5), inside(-(y - 0.5) * 2.5)];
const inside = (value: number): number => Math.min(1, Math.max(-1, value));

const nearestTo = (hands: readonly FoundHand[], place: Place): number =>
  hands.reduce((best, hand, index) => {
    const other = hands[best];
    return other !== undefined && apart(wristOf(other), place) <= apart(wristOf(hand), place) ? best : index;
  }, 0);
