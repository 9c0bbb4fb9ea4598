/** The seven points as a list beside a drawn face, with undo and redo. */

import { html, nothing } from "lit";
import { LANDMARKS } from "../../link/constants";
import type { LandmarkName, Points } from "./data/scan_document";
import { POINT_LABELS, type ScanPoints } from "./data/scan_points";
import { pointPicture } from "./point_picture";

/** found: points that Omote found; changed: is called when something has. */
export function pointList({ points, found, changed }: { points: ScanPoints; found: Points; changed: () => void }) {
  const act = (does: () => void) => () => {
    does();
    changed();
  };
  const row = (name: LandmarkName, at: number) => {
    const given = points.given[name] !== undefined;
    const state = given ? " ✓" : found[name] === undefined ? " ?" : "";
    return html`<li><button class="quiet" aria-pressed=${points.chosen === name} data-point=${name}
        title="The next click on the scan sets this point" @click=${act(() => {
          points.chosen = name;
        })}>${at + 1} ${POINT_LABELS[name]}${state}</button>
      ${given ? html`<button class="icon quiet" aria-label="Take back: ${POINT_LABELS[name]}" title="Take it back" @click=${act(() => points.remove(name))}>✕</button>` : nothing}</li>`;
  };
  return html`<header><h2>Points</h2><span class="note">left is the person's own</span></header>
    <div class="points">${pointPicture(points.chosen, points.given)}<ol>${LANDMARKS.map(row)}</ol></div>
    <div class="row">
      <button class="grow" ?disabled=${!points.canUndo} @click=${act(() => points.undo())}>Undo</button>
      <button class="grow" ?disabled=${!points.canRedo} @click=${act(() => points.redo())}>Redo</button>
    </div>`;
}
