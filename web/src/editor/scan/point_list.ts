/** The seven points as a list beside a drawn face, with undo and redo. */

import { html, nothing } from "lit";
import { LANDMARKS } from "../../link/constants";
import type { LandmarkName, LandmarkPoints } from "./data/scan_document";
import { POINT_LABELS, type ScanPoints } from "./data/scan_points";
import { pointPicture } from "./point_picture";

/** foundPoints: points that Omote found; changed: is called when something has. */
export function pointList({
  points,
  foundPoints,
  changed,
}: {
  points: ScanPoints;
  foundPoints: LandmarkPoints;
  changed: () => void;
}) {
  const act = (does: () => void) => () => {
    does();
    changed();
  };
  const row = (name: LandmarkName, at: number) => {
    const isGiven = points.given[name] !== undefined;
    const state = isGiven ? " ✓" : foundPoints[name] === undefined ? " ?" : "";
    return html`<li><button class="quiet" aria-pressed=${points.chosen === name} data-point=${name}
        title="The next click on the scan sets this point" @click=${act(() => {
          points.chosen = name;
        })}>${at + 1} ${POINT_LABELS[name]}${state}</button>
      ${isGiven ? html`<button class="icon quiet" aria-label="Take back: ${POINT_LABELS[name]}" title="Take it back" @click=${act(() => points.remove(name))}>✕</button>` : nothing}</li>`;
  };
  return html`<header><h2>Points</h2><span class="note">left is the person's own</span></header>
    <div class="points">${pointPicture(points.chosen, points.given)}<ol>${LANDMARKS.map(row)}</ol></div>
    <div class="row">
      <button class="grow" ?disabled=${!points.canUndo} @click=${act(() => points.undo())}>Undo</button>
      <button class="grow" ?disabled=${!points.canRedo} @click=${act(() => points.redo())}>Redo</button>
    </div>`;
}
