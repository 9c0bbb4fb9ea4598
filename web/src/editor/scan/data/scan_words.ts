/** What is said of a fitted scan, in sentences. */

import { LANDMARKS } from "../../../link/constants";
import type { SeenScan } from "./scan_document";

/** Below this part of the face that the scan shows, it is said how much it is. */
const NEARLY_ALL = 0.9;

/** How near the face lies to the scan, and what the scan was taken for. */
export function nearnessOf({ face, unit }: SeenScan): string {
  if (face === null) return "No face has been fitted yet.";
  const { median, p95, seen } = face.figures;
  const share = seen < NEARLY_ALL ? ` ${Math.round(100 * seen)} % of the face was scanned; the rest is made up.` : "";
  return `Half of the face lies within ${median.toFixed(2)} mm of the scan, 95 % within ${p95.toFixed(2)} mm.${share} Taken for: ${unit}.`;
}

/** Whether one of the doubts is about the eyes. */
export const asksEyes = ({ doubts, shut }: Pick<SeenScan, "doubts" | "shut">): boolean =>
  shut === null && doubts.some(({ kind }) => kind === "eyes");

/** What to do now. */
export function adviceOf(scan: SeenScan, changed: boolean): string {
  if (changed) return "Press Fit again when the points are where they belong.";
  const all = Object.keys(scan.given).length === LANDMARKS.length;
  if (scan.face === null && all) return "No face came of these points: move those that are off, then press Fit again.";
  if (scan.face === null) return "Click the seven points on the scan, then press Fit again.";
  if (asksEyes(scan) && scan.doubts.length === 1)
    return "Omote is sure of all but the eyes. Say below whether they are shut, or take it as it is.";
  if (scan.doubts.length === 0) return "Omote is sure. Look at the three sides, then take it.";
  return "Omote is not sure. Look at the three sides; where eyes, nose or mouth are off, click them on the scan.";
}
