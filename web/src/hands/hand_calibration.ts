/** What is known of one performer's hand before one camera: how its shape is read, its delay, its side, how it rests. */

import { GUIDE_SECONDS, guideTargets, HAND_AXES, REST_SECONDS } from "./hand_guide";
import type { FoundHand } from "./hand_messages";
import { applyKernel, fitKernel, type KernelMap } from "./kernel_ridge";
import { type Axes, handShape, palmOf, palmTurn, SHAPE_SIZE, squarePoints } from "./palm";
import { applyRidge, correlation, RidgeFit } from "./ridge";

/** A hand in one picture of the guided minute. time: seconds of the minute. */
export interface HandSample {
  time: number;
  shape: Float64Array;
  /** Of the palm in the picture, and in the model's own space. */
  palms: readonly [Axes, Axes];
  side: "left" | "right";
  /** Where the wrist is: fractions of the picture. */
  place: readonly [number, number];
}

/** What is kept. */
export interface HandCalibration {
  version: 2;
  /** When it was made, ms since 1970, and before which camera, by its label. */
  made: number;
  camera: string;
  side: "left" | "right";
  place: [number, number];
  /** Seconds by which the performer follows the drawn hand. */
  delay: number;
  /** The palms at rest, as of a sample. */
  palms: [number[], number[]];
  /** From the shape and the turns of both palms to the axes. */
  map: KernelMap;
  /** How well each axis was followed, a correlation: what it is read as from the rest of the minute, with what was asked. */
  fit: number[];
  /** Pictures a second that were looked at in the minute. */
  rate: number;
}

/** Samples that a minute has at least: five a second. */
export const FEWEST_SAMPLES = 250;
/** Of the count of samples: added to the diagonal of the regression by which the delay is found. */
const SHRINK = 0.01;
/** Seconds of the minute that are held out together. */
const STRETCH = 3;
/** Numbers that the map reads: the shape, and two turns. */
const INPUT_SIZE = SHAPE_SIZE + 6;
/** Seconds by which people follow what they see: looked for up to here, by this step. */
const LONGEST_DELAY = 0.7;
const DELAY_STEP = 0.02;

/** The sample of a hand; null where its points give no palm. width, height: of the picture; time: of the minute, seconds. */
export function handSample(hand: FoundHand, width: number, height: number, time: number): HandSample | null {
  const shape = handShape(hand, width, height);
  const seen = palmOf(squarePoints(hand.image, width, height));
  const own = palmOf(hand.world);
  if (shape === null || seen === null || own === null) return null;
  const place = [hand.image[0] ?? 0, hand.image[1] ?? 0] as const;
  return { time, shape, palms: [seen.axes, own.axes], side: hand.side, place };
}

/** The calibration by a guided minute; an Error with what to do where the samples give none. rate: pictures a second that were looked at; made: ms since 1970. */
export function fitHand(samples: readonly HandSample[], rate: number, camera: string, made: number): HandCalibration {
  const rests = samples.filter(({ time }) => time > REST_SECONDS / 4 && time < REST_SECONDS);
  if (samples.length < FEWEST_SAMPLES || rests.length < FEWEST_SAMPLES / 25) {
    throw new Error(
      `the hand was seen in ${samples.length} pictures; ${FEWEST_SAMPLES} are needed, some of them at the beginning. More light, a plain background, less on this machine; then again.`,
    );
  }
  const middle = (set: 0 | 1): number[] => middlePalm(rests.map(({ palms }) => palms[set]));
  const palms: [number[], number[]] = [middle(0), middle(1)];
  const inputs = samples.map((sample) => mapInput(sample, palms));
  const delay = findDelay(samples, inputs);
  const stretches = samples.map(({ time }) => Math.floor(time / STRETCH));
  const { map, foretold } = fitKernel(inputs, stretches, targetsOf(samples, delay));
  const right = samples.filter(({ side }) => side === "right").length;
  return {
    version: 2,
    made,
    camera,
    side: 2 * right > samples.length ? "right" : "left",
    place: [median(samples.map(({ place }) => place[0])), median(samples.map(({ place }) => place[1]))],
    delay,
    palms,
    map,
    fit: foretold,
    rate,
  };
}

/** What a hand does by a calibration, unfiltered: axes of `HAND_AXES`. */
export function readHand(calibration: HandCalibration, sample: Pick<HandSample, "shape" | "palms">): number[] {
  const values = applyKernel(calibration.map, mapInput(sample, calibration.palms));
  return values.map((value, axis) => Math.min(1, Math.max(axis === 0 ? 0 : -1, value)));
}

/** What the map reads: the shape, and how both palms have turned since they rested. */
function mapInput({ shape, palms }: Pick<HandSample, "shape" | "palms">, rest: readonly [Axes, Axes]): Float64Array {
  const input = new Float64Array(INPUT_SIZE);
  input.set(shape);
  input.set(palmTurn(palms[0], rest[0]), shape.length);
  input.set(palmTurn(palms[1], rest[1]), shape.length + 3);
  return input;
}

/** The delay at which the moves asked for explain best what was seen: straight, since a map that bends explains any. */
function findDelay(samples: readonly HandSample[], inputs: readonly Float64Array[]): number {
  const ridge = new RidgeFit(inputs, SHRINK);
  let [best, delay] = [Number.NEGATIVE_INFINITY, 0];
  for (let tried = 0; tried <= LONGEST_DELAY; tried += DELAY_STEP) {
    const [wanted = []] = targetsOf(samples, tried);
    const map = ridge.solve([wanted]);
    const found = correlation(
      wanted,
      inputs.map((input) => applyRidge(map, input)[0] ?? 0),
    );
    if (found > best) [best, delay] = [found, tried];
  }
  return delay;
}

/** What was asked of each axis when each sample was seen, `delay` seconds before it. */
function targetsOf(samples: readonly HandSample[], delay: number): number[][] {
  const targets = samples.map(({ time }) => guideTargets(Math.min(GUIDE_SECONDS, Math.max(0, time - delay))));
  return HAND_AXES.map((axis) => targets.map((target) => target[axis]));
}

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? 0;
}

/** The palm that lies in the middle of some: the mean of their axes, made square again. */
function middlePalm(palms: readonly Axes[]): number[] {
  const sums = Array.from({ length: 9 }, (_, place) => median(palms.map((palm) => palm[place] ?? 0)));
  const points = new Float64Array(63);
  const [across, along] = [sums.slice(0, 3), sums.slice(3, 6)];
  points.set(along, 3 * 9);
  points.set(across, 3 * 5);
  return [...(palmOf(points)?.axes ?? sums)];
}

/** The calibration in a text that was kept; null where there is none of this version. */
export function readCalibration(text: string | null): HandCalibration | null {
  if (text === null) return null;
  try {
    const kept: HandCalibration = JSON.parse(text);
    const { means, scales, supports, offsets, weights } = kept.map;
    const palms = kept.palms.flat();
    const numbers = [
      kept.made,
      kept.delay,
      kept.rate,
      ...kept.place,
      ...palms,
      ...kept.fit,
      ...means,
      ...scales,
      ...offsets,
      ...supports.flat(),
      ...weights.flat(),
    ];
    const whole =
      kept.version === 2 &&
      palms.length === 18 &&
      weights.length === HAND_AXES.length &&
      [means, scales, ...supports].every((row) => row.length === INPUT_SIZE) &&
      weights.every((row) => row.length === supports.length);
    return whole && numbers.every(Number.isFinite) ? kept : null;
  } catch {
    return null;
  }
}

/** Days after which a calibration is called old: a camera is seldom put down twice at the same place. */
const OLD_DAYS = 7;
const DAY_MS = 86_400_000;
/** A correlation below which an axis was not followed well. */
const FOLLOWED = 0.9;
/** Pictures a second below which a hand lags, and too little is seen of what it does. */
export const FEW_PICTURES = 12;

/** Whether the opening was followed: else neither it nor the delay is known. */
const isFollowed = ({ fit }: HandCalibration): boolean => (fit[0] ?? 0) >= FOLLOWED;

/** How far behind the drawn hand the performer was, in words behind a comma; "" where that is not known. */
export const sayDelay = (calibration: HandCalibration): string =>
  isFollowed(calibration) ? `, ${Math.round(1000 * calibration.delay)} ms behind the drawn one` : "";

/** What is to be said of a calibration: its age, another camera, an opening that was not followed; "" for nothing. now: ms since 1970; camera: the label of the one that is open. */
export function adviseOnCalibration(calibration: HandCalibration, camera: string, now: number): string {
  const days = Math.floor((now - calibration.made) / DAY_MS);
  if (camera !== "" && calibration.camera !== "" && camera !== calibration.camera) {
    return `It was made before another camera (${calibration.camera}): make the guided minute again.`;
  }
  if (days >= OLD_DAYS) return `It is ${days} days old: make the guided minute again where the hand is read badly.`;
  if (isFollowed(calibration)) return "";
  return calibration.rate < FEW_PICTURES
    ? `The opening could not be followed: only ${calibration.rate.toFixed(0)} pictures a second were looked at. Close other pages and programs on this machine, look for one hand, not two, and make it again.`
    : "The opening was not followed well: hand in profile, fingertips to the side, and make it again.";
}
