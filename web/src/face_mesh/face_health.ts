/** What is good and what is not of the picture, and what the performer can do about it. */

import { LANDMARK_COUNT } from "./face_mesh";
import type { Landmarks } from "./landmark_messages";

/** One thing that is looked at. */
export interface HealthLine {
  what: string;
  good: boolean;
  /** What to do, "" where it is good. */
  advice: string;
}

/** Points of the face mesh: the tip of the nose, and the edge of the face at its sides. */
const NOSE = 1;
const EDGES = [234, 454] as const;
/** Pictures a second below which a mouth is seen to lag. */
const SLOW = 12;
/** Of light, 0..1: below, the model guesses. */
const DARK = 0.16;
const BRIGHT = 0.93;
/** Of the picture's height: a smaller face has too few pixels. */
const SMALL = 0.22;
const LARGE = 0.95;
/** Of the picture: how near the edge a face may be. */
const MARGIN = 0.015;
/** How far the nose may be from the middle of the face, of its half width: about 40 degrees. */
const TURNED = 0.62;

/** The lines of health for the newest picture. rate: pictures a second. */
export function judgeFace(landmarks: Landmarks | null, rate: number): HealthLine[] {
  const speed = {
    what: `${Math.round(rate)} ${Math.round(rate) === 1 ? "picture" : "pictures"} a second`,
    good: rate >= SLOW,
    advice: rate >= SLOW ? "" : SLOWLY,
  };
  return [speed, ...judgePicture(landmarks), ...(isFace(landmarks) ? [judgeTurn(landmarks)] : [])];
}

/** Those of the lines that count for a face that is turned, too. */
export function judgePicture(landmarks: Landmarks | null): HealthLine[] {
  if (!isFace(landmarks)) return [{ what: "No face", good: false, advice: noFaceAdvice(landmarks) }];
  const face = { what: "Face found", good: true, advice: "" };
  return [face, judgeLight(landmarks.light), judgePlace(landmarks.points)];
}

const isFace = (landmarks: Landmarks | null): landmarks is Landmarks =>
  landmarks !== null && landmarks.points.length === 3 * LANDMARK_COUNT;

const SLOWLY = "Close other programs and tabs; on a laptop, plug the power in.";

function noFaceAdvice(landmarks: Landmarks | null): string {
  if (landmarks !== null && landmarks.light < DARK) return "It is dark: put a light in front of you, not behind.";
  return "Sit before the camera, at an arm's length, and look into it.";
}

function judgeLight(light: number): HealthLine {
  if (light < DARK) return { what: "Too dark", good: false, advice: "Put a light in front of you, not behind." };
  if (light > BRIGHT) return { what: "Too bright", good: false, advice: "Less light on your face." };
  return { what: "Light", good: true, advice: "" };
}

function judgePlace(points: Float32Array): HealthLine {
  const [left, right] = range(points, 0);
  const [top, bottom] = range(points, 1);
  if (left < MARGIN || top < MARGIN || right > 1 - MARGIN || bottom > 1 - MARGIN) {
    const near = bottom - top > LARGE;
    return { what: near ? "Too near" : "At the edge", good: false, advice: near ? "Sit back." : "Move to the middle." };
  }
  if (bottom - top < SMALL) return { what: "Too small", good: false, advice: "Come nearer to the camera." };
  return { what: "Place", good: true, advice: "" };
}

function judgeTurn({ points }: Landmarks): HealthLine {
  const [start, end] = EDGES.map((edge) => points[3 * edge] ?? 0) as [number, number];
  const nose = points[3 * NOSE] ?? 0;
  const half = Math.abs(end - start) / 2;
  const turned = half === 0 || Math.abs(nose - (start + end) / 2) / half > TURNED;
  return { what: turned ? "Turned away" : "Facing", good: !turned, advice: turned ? "Turn to the camera." : "" };
}

function range(points: Float32Array, axis: number): [number, number] {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let place = axis; place < points.length; place += 3) {
    low = Math.min(low, points[place] ?? low);
    high = Math.max(high, points[place] ?? high);
  }
  return [low, high];
}

/** Events a second over the last two seconds; times in ms. */
export class Rate {
  #times: number[] = [];

  /** Counts one; returns the rate. */
  count(time: number): number {
    this.#times = [...this.#times.filter((earlier) => time - earlier < 2000), time];
    const first = this.#times[0] ?? time;
    return time > first ? (1000 * (this.#times.length - 1)) / (time - first) : 0;
  }
}
