/** A small drawn face with the seven points, one of them marked: where each lies. */

import { html, svg } from "lit";
import { LANDMARKS } from "../../link/constants";
import type { LandmarkName, LandmarkPoints } from "./data/scan_document";

/** Where the points lie on the drawn face, as one looks at it: its left is on the right. */
const PLACES: Readonly<Record<LandmarkName, readonly [number, number]>> = {
  left_eye_outer: [75, 46],
  left_eye_inner: [58, 47],
  right_eye_inner: [42, 47],
  right_eye_outer: [25, 46],
  nose_tip: [50, 68],
  mouth_left: [63, 84],
  mouth_right: [37, 84],
};

export function pointPicture(chosen: LandmarkName, givenPoints: LandmarkPoints) {
  const dot = (name: LandmarkName) => {
    const [x, y] = PLACES[name];
    const kind = name === chosen ? "chosen" : givenPoints[name] === undefined ? "" : "given";
    return svg`<circle class=${kind} cx=${x} cy=${y} r=${name === chosen ? 5 : 3}></circle>`;
  };
  return html`<svg class="face" viewBox="0 0 100 118" aria-hidden="true">
    <path d="M50 4C20 4 10 28 12 56c2 30 20 58 38 58s36-28 38-58C90 28 80 4 50 4Z"></path>
    <path d="M25 46q8-8 17 1q-9 5-17-1ZM75 46q-8-8-17 1q9 5 17-1ZM50 46l-5 22q5 5 10 0M37 84q13-6 26 0q-13 9-26 0Z"></path>
    <path d="M22 38q10-7 21-2M78 38q-10-7-21-2"></path>
    ${LANDMARKS.map(dot)}
  </svg>`;
}
