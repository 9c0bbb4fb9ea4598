/** A pose: what a stage draws of a state. */

import { FACES_OWN, FIRST_LIGHT } from "../../link/constants";
import type { CharacterState, FigureState, State, TrackedState } from "../../link/messages";
import { mixTracked, trackedKey } from "./tracked_mix";

/** What a figure does and wears: mixes of poses, of regions that go their own way, and of bodies; a performer's body that shows in place of the poses. */
export type FigureMix = Pick<FigureState, "poses" | "regions" | "bodies"> & {
  readonly tracked?: TrackedState | null | undefined;
};

/** What a stage draws of a character: its weights and angles in a state, nothing of its calls, and the light. */
export type Pose = Pick<CharacterState, "faces" | "expressions" | "regions" | "channels" | "added" | "head" | "eyes"> &
  Pick<State, "light"> & {
    /** Blood, tears, sweat and what these have run, as in a state; without it what the expressions bring, at once. */
    readonly complexion?: readonly number[] | undefined;
    /** How much of the skin's folds shows; all without it. */
    readonly folds?: number | undefined;
    /** What its figure does; without it, it stands with the bodies of its faces. */
    readonly figure?: FigureMix | null | undefined;
    /** How much of a breath is in its chest, how far its weight is on the left foot, how far its chest has followed the head; without it, it holds still. */
    readonly idle?: Idle | undefined;
  };

/** What a figure does by itself. */
export type Idle = CharacterState["idle"];

/** Of a figure that holds still. */
export const NO_IDLE: Idle = [0, 0, 0];

type Weights = Record<string, number>;
type Regions = Pose["regions"];

/** The same text for the same pose. */
export const poseKey = ({
  faces,
  expressions,
  regions,
  channels,
  added,
  head,
  eyes,
  light,
  complexion,
  folds,
  figure,
  idle,
}: Pose): string =>
  JSON.stringify([
    ...[faces, expressions, regions, channels, added, head, eyes, light, complexion, folds],
    figure && [figure.poses, figure.regions, figure.bodies, trackedKey(figure.tracked ?? undefined)],
    idle,
  ]);

/** The pose at rest: one face, neutral. */
export const restPose = (face: string, expression = "neutral"): Pose => ({
  faces: { [face]: 1 },
  expressions: { [expression]: 1 },
  regions: {},
  channels: {},
  added: {},
  head: [0, 0, 0],
  eyes: [0, 0, 0, 0],
  light: { [FIRST_LIGHT]: 1 },
});

/** Weights part of the way from `from` to `to`; a name that is missing weighs nothing. */
export function mixWeights(from: Weights, to: Weights, part: number): Weights {
  const mixed: Weights = {};
  for (const name in from) mixed[name] = (from[name] as number) * (1 - part);
  for (const name in to) mixed[name] = (mixed[name] ?? 0) + (to[name] as number) * part;
  return mixed;
}

/** The mixes of the regions that go their own way in either pose, part of the way; where one does not, it shows its whole face's. */
function mixRegions(from: Pose, to: Pose, part: number): Regions {
  const mixed: Regions = {};
  for (const region of Object.keys({ ...from.regions, ...to.regions }) as (keyof Regions)[])
    mixed[region] = mixWeights(from.regions[region] ?? from.expressions, to.regions[region] ?? to.expressions, part);
  return mixed;
}

function mixAngles<T extends number[]>(from: T, to: T, part: number): T {
  return from.map((angle, index) => angle + ((to[index] as number) - angle) * part) as T;
}

/** A complexion part of the way; numbers that are missing are 0. */
function mixComplexion(from: Pose["complexion"], to: Pose["complexion"], part: number): Pose["complexion"] {
  if (from === undefined || to === undefined) return to ?? from;
  return Array.from({ length: Math.max(from.length, to.length) }, (_, at) => {
    const [before, after] = [from[at] ?? 0, to[at] ?? 0];
    return before + (after - before) * part;
  });
}

function mixFolds(from: Pose["folds"], to: Pose["folds"], part: number): Pose["folds"] {
  return from === undefined && to === undefined ? undefined : (from ?? 1) + ((to ?? 1) - (from ?? 1)) * part;
}

/** What a figure does that nobody has told anything. */
export const STANDING: FigureMix = { poses: { stand: 1 }, regions: {}, bodies: { [FACES_OWN]: 1 } };

function mixIdle(from: Pose["idle"], to: Pose["idle"], part: number): Pose["idle"] {
  if (!from && !to) return to;
  const [before, after] = [from ?? NO_IDLE, to ?? NO_IDLE];
  return before.map((value, at) => value + part * ((after[at] as number) - value)) as typeof before;
}

function mixFigures(from: Pose["figure"], to: Pose["figure"], part: number): Pose["figure"] {
  if (!from && !to) return to;
  const [before, after] = [from ?? STANDING, to ?? STANDING];
  const regions: FigureMix["regions"] = {};
  for (const region of Object.keys({ ...before.regions, ...after.regions }) as (keyof FigureMix["regions"])[])
    regions[region] = mixWeights(before.regions[region] ?? before.poses, after.regions[region] ?? after.poses, part);
  return {
    poses: mixWeights(before.poses, after.poses, part),
    regions,
    bodies: mixWeights(before.bodies, after.bodies, part),
    tracked: mixTracked(before.tracked ?? undefined, after.tracked ?? undefined, part),
  };
}

/** The pose part of the way (0..1) from `from` to `to`; sums of weights stay what they are. */
export function mixPoses(from: Pose, to: Pose, part: number): Pose {
  return {
    faces: mixWeights(from.faces, to.faces, part),
    expressions: mixWeights(from.expressions, to.expressions, part),
    regions: mixRegions(from, to, part),
    channels: mixWeights(from.channels, to.channels, part),
    added: mixWeights(from.added, to.added, part),
    head: mixAngles(from.head, to.head, part),
    eyes: mixAngles(from.eyes, to.eyes, part),
    light: mixWeights(from.light, to.light, part),
    complexion: mixComplexion(from.complexion, to.complexion, part),
    folds: mixFolds(from.folds, to.folds, part),
    figure: mixFigures(from.figure, to.figure, part),
    idle: mixIdle(from.idle, to.idle, part),
  };
}

/** The rotation that turns a gaze straight ahead to yaw (+ = +x) and pitch (+ = up), column by column. */
export function writeTurn(yaw: number, pitch: number, into: Float32Array, at: number): void {
  const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
  into.set([cy, 0, -sy, -sy * sp, cp, -cy * sp, sy * cp, sp, cy * cp], at);
}
