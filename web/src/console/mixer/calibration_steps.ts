/** The faces that a performer is asked to make one after the other, and the channels that each measures. */

/** One face to make: what people read, and its channels, by how their names begin; none: the face at rest. */
export interface CalibrationStep {
  readonly label: string;
  readonly asks: string;
  readonly of: readonly string[];
}

export const CALIBRATION_STEPS: readonly CalibrationStep[] = [
  { label: "At rest", asks: "Look ahead, lips together, and hold still.", of: [] },
  { label: "Eyes shut", asks: "Close both eyes, as in sleep.", of: ["eyeBlink"] },
  { label: "Eyes wide", asks: "Open your eyes as wide as you can.", of: ["eyeWide"] },
  { label: "Brows up", asks: "Raise your brows as far as they go.", of: ["browInnerUp", "browOuterUp"] },
  { label: "Brows down", asks: "Frown: pull your brows down and squint.", of: ["browDown", "eyeSquint", "noseSneer"] },
  {
    label: "Mouth open",
    asks: "Open your mouth as wide as you can.",
    of: ["jawOpen", "mouthLowerDown", "mouthUpperUp"],
  },
  { label: "Smile", asks: "Smile as broadly as you can.", of: ["mouthSmile", "mouthDimple", "cheekSquint"] },
  { label: "Sad mouth", asks: "Pull the corners of your mouth down.", of: ["mouthFrown", "mouthStretch"] },
  {
    label: "Kiss",
    asks: "Purse your lips as for a kiss, then round them to an O.",
    of: ["mouthPucker", "mouthFunnel"],
  },
  { label: "Cheeks", asks: "Puff your cheeks out.", of: ["cheekPuff"] },
  { label: "Tongue", asks: "Put your tongue out.", of: ["tongueOut"] },
];

/** The channels of a source that a step measures. */
export const channelsOf = ({ of }: CalibrationStep, names: readonly string[]): string[] =>
  names.filter((name) => of.some((start) => name.startsWith(start)));

/** The steps for which a source has any channel, and that of rest. */
export const stepsFor = (names: readonly string[]): readonly CalibrationStep[] =>
  CALIBRATION_STEPS.filter((step) => step.of.length === 0 || channelsOf(step, names).length > 0);

/** What a face at rest does not do: how it is called, its channels by how their names begin, and from which value of the larger side on it does. */
const UNREST = [
  ["a smile", "mouthSmile", 0.35],
  ["the mouth open", "jawOpen", 0.25],
  ["the eyes shut", "eyeBlink", 0.5],
  ["pursed lips", "mouthPucker", 0.6],
] as const;

/** Of a face that was measured as one at rest and is none, a sentence with what to do; "" of one that is. */
export function adviceOnRest(neutral: Readonly<Record<string, number>>): string {
  const most = (start: string): number =>
    Math.max(0, ...Object.entries(neutral).flatMap(([name, value]) => (name.startsWith(start) ? [value] : [])));
  const does = UNREST.filter(([, start, from]) => most(start) > from).map(([called]) => called);
  return does.length === 0
    ? ""
    : `The face that was taken as at rest has ${does.join(" and ")}; only more than that counts now. Take At rest again: lips together, eyes open, no smile. Who always looks so leaves it.`;
}
