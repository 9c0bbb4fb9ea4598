/** The points that a person sets on a scan: which is next, undo and redo. It touches neither page nor server. */

import { LANDMARKS } from "../../../link/constants";
import type { Triple } from "../../canvas/math/vectors";
import { PointHistory } from "./point_history";
import type { LandmarkName, LandmarkPoints } from "./scan_document";

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

export class ScanPoints extends PointHistory<LandmarkPoints> {
  /** The point that the next click sets. */
  chosen: LandmarkName = LANDMARKS[0];

  constructor() {
    super({});
  }

  get given(): LandmarkPoints {
    return this.now;
  }

  /** Whether a fit would now be by other points than that which is shown. */
  get changed(): boolean {
    return LANDMARKS.some((name) => this.now[name] !== this.fittedBy[name]);
  }

  /** Sets a point; `goes`: and goes on to the next that is not set. A point that is set again within one drag is one step: `same`. */
  set(name: LandmarkName, point: Triple, { goes = false, same = false } = {}): void {
    this.put({ ...this.now, [name]: point }, same);
    this.chosen = goes ? this.#following(name) : name;
  }

  /** Takes a point back: it is found by Omote again. */
  remove(name: LandmarkName): void {
    if (this.now[name] === undefined) return;
    this.put(Object.fromEntries(Object.entries(this.now).filter(([landmark]) => landmark !== name)), false);
    this.chosen = name;
  }

  protected override stepped(before: LandmarkPoints): void {
    this.chosen = LANDMARKS.find((name) => before[name] !== this.now[name]) ?? this.chosen;
  }

  /** The next point after one that is not set, around at the end; where all are set, the one itself. */
  #following(name: LandmarkName): LandmarkName {
    const at = LANDMARKS.indexOf(name);
    const round = [...LANDMARKS.slice(at + 1), ...LANDMARKS.slice(0, at)];
    return round.find((landmark) => this.now[landmark] === undefined) ?? name;
  }
}
