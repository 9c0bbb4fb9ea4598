/** The points that a person sets on a scan: which is next, undo and redo. It touches neither page nor server. */

import { LANDMARKS } from "../../../link/constants";
import type { Triple } from "../../canvas/math/vectors";
import type { LandmarkName, Points } from "./scan_document";

/** What people call the points; left is the character's own. */
export const POINT_LABELS: Readonly<Record<LandmarkName, string>> = {
  left_eye_outer: "Left eye, outer corner",
  left_eye_inner: "Left eye, inner corner",
  right_eye_inner: "Right eye, inner corner",
  right_eye_outer: "Right eye, outer corner",
  nose_tip: "Tip of the nose",
  mouth_left: "Left corner of the mouth",
  mouth_right: "Right corner of the mouth",
};

export class ScanPoints {
  /** The point that the next click sets. */
  chosen: LandmarkName = LANDMARKS[0];
  #given: Points = {};
  #past: Points[] = [];
  #future: Points[] = [];
  /** The points by which the face that is shown was fitted. */
  #fitted: Points = {};

  get given(): Points {
    return this.#given;
  }

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  /** Whether a fit would now be by other points than that which is shown. */
  get changed(): boolean {
    return LANDMARKS.some((name) => this.#given[name] !== this.#fitted[name]);
  }

  /** Sets a point; `goes`: and goes on to the next that is not set. A point that is set again within one drag is one step: `same`. */
  set(name: LandmarkName, point: Triple, { goes = false, same = false } = {}): void {
    if (!same) this.#remember();
    this.#given = { ...this.#given, [name]: point };
    this.chosen = goes ? this.#following(name) : name;
  }

  /** Takes a point back: it is found by Omote again. */
  remove(name: LandmarkName): void {
    if (this.#given[name] === undefined) return;
    this.#remember();
    this.#given = Object.fromEntries(Object.entries(this.#given).filter(([one]) => one !== name));
    this.chosen = name;
  }

  undo(): void {
    this.#step(this.#past, this.#future);
  }

  redo(): void {
    this.#step(this.#future, this.#past);
  }

  /** What is set now has been fitted. */
  fitted(): void {
    this.#fitted = this.#given;
  }

  #remember(): void {
    this.#past.push(this.#given);
    this.#future = [];
  }

  #step(from: Points[], to: Points[]): void {
    const points = from.pop();
    if (points === undefined) return;
    to.push(this.#given);
    const before = this.#given;
    this.#given = points;
    this.chosen = LANDMARKS.find((name) => before[name] !== points[name]) ?? this.chosen;
  }

  /** The next point after one that is not set, around at the end; where all are set, the one itself. */
  #following(name: LandmarkName): LandmarkName {
    const at = LANDMARKS.indexOf(name);
    const round = [...LANDMARKS.slice(at + 1), ...LANDMARKS.slice(0, at)];
    return round.find((one) => this.#given[one] === undefined) ?? name;
  }
}
