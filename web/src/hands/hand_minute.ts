/** The guided minute as it runs: samples of the hand against its clock, which stands while no hand is seen. */

import { fitHand, type HandCalibration, type HandSample, handSample } from "./hand_calibration";
import { GUIDE_SECONDS, guideSection, guideTargets, type HandAxes } from "./hand_guide";
import type { Hands } from "./hand_messages";

/** Seconds to get ready; without a hand in the pictures, after which the clock stands; without a picture; after it came back, that are not taken. */
const [READY, LOST, STALLED, AGAIN] = [3, 0.5, 2, 0.6];

/** Where the minute is. */
export interface MinuteState {
  phase: "ready" | "moves" | "lost";
  /** Seconds of the minute, 0 while getting ready. */
  time: number;
  /** Seconds left, of getting ready or of the minute. */
  left: number;
  advice: string;
  targets: HandAxes;
  share: number;
}

/** A guided minute of one hand. begun: seconds of the page's clock. */
export class HandMinute {
  readonly #samples: HandSample[] = [];
  #time: number;
  #now: number;
  #seen: number;
  /** Whether the newest picture shows no hand. */
  #missed = false;
  #back: number;
  /** Seconds since the moves began, and the pictures in them. */
  #moved = 0;
  #pictures = 0;

  constructor(begun: number) {
    this.#time = -READY;
    this.#now = this.#seen = begun;
    this.#back = Number.NEGATIVE_INFINITY;
  }

  /** Passes the clock on. now: seconds of the page's clock. */
  pass(now: number): void {
    const gap = Math.max(0, now - this.#now);
    this.#now = Math.max(now, this.#now);
    if (this.#time >= 0 && !this.done) this.#moved += gap;
    if (this.#time < 0 || !this.#lost) this.#time += gap;
  }

  /** Takes a picture. playing: the place of the hand that is calibrated, -1 where it is not seen. */
  hear(hands: Hands, playing: number): void {
    const now = hands.time / 1000;
    this.pass(now);
    if (this.#time >= 0) this.#pictures += 1;
    const hand = hands.hands[playing];
    if (hand !== undefined && this.#lost) this.#back = now;
    this.#missed = hand === undefined;
    if (hand === undefined) return;
    this.#seen = now;
    const time = this.#time - (this.#now - now); // it was taken before it was looked at, by some other time for each
    const sample = handSample(hand, hands.width, hands.height, time);
    const taken = time >= 0 && !this.done && now - this.#back > AGAIN;
    if (sample !== null && taken) this.#samples.push(sample);
  }

  get #lost(): boolean {
    return this.#now - this.#seen >= (this.#missed ? LOST : STALLED);
  }

  /** Whether all moves have been shown. */
  get done(): boolean {
    return this.#time >= GUIDE_SECONDS;
  }

  /** Where it is now. */
  get state(): MinuteState {
    const time = Math.max(0, this.#time);
    const { advice } = guideSection(time);
    const lost = this.#time >= 0 && this.#lost;
    return {
      phase: this.#time < 0 ? "ready" : lost ? "lost" : "moves",
      time,
      left: this.#time < 0 ? -this.#time : GUIDE_SECONDS - time,
      advice,
      targets: guideTargets(time),
      share: time / GUIDE_SECONDS,
    };
  }

  /** The calibration by what was seen; an Error with what to do where that is too little. camera: its label; made: ms since 1970. */
  fit(camera: string, made: number): HandCalibration {
    return fitHand(this.#samples, this.#pictures / this.#moved, camera, made);
  }
}
