/** How much of what the editor shows first has come, and what comes now. */

import type { Download } from "../../link/fetch_progress";

/** What addresses hold, by how they begin. */
const WORDS: readonly (readonly [string, string])[] = [
  ["/manifest", "the cast"],
  ["/assets/", "faces, skin and hair"],
  ["/contents/", "faces"],
  ["/tangents/", "how each face moves"],
  ["/compounds/", "the expression on every face"],
  ["/handles", "the handles"],
];

/** Downloads before the first picture: the cast and its skin; of each face its shape, its hair and how it moves. */
const expected = (faces: number): number => 2 + 3 * faces;

/** The share that has come, 0..1, and a sentence; `faces`: how many are to be shown. */
export function progressOf(all: readonly Download[], faces: number): { share: number; words: string } {
  const coming = all.filter(({ ended }) => !ended);
  const parts = all.map(({ ended, received, total }) => (ended ? 1 : total ? received / total : 0));
  const share = parts.reduce((sum, part) => sum + part, 0) / Math.max(expected(faces), all.length);
  const named = WORDS.filter(([begin]) => coming.some(({ address }) => address.startsWith(begin)));
  if (named.length === 0) return { share, words: all.length === 0 ? "Asking for the cast" : "Preparing the picture" };
  return { share, words: `Fetching ${named.map(([, words]) => words).join(", ")}${bytesOf(coming)}` };
}

/** How much has come of what is coming, where that is known. */
function bytesOf(coming: readonly Download[]): string {
  const sized = coming.filter(({ total }) => total !== undefined);
  const sum = (of: (download: Download) => number): string =>
    (sized.reduce((bytes, download) => bytes + of(download), 0) / 1e6).toFixed(1);
  return sized.length === 0 ? "" : `: ${sum(({ received }) => received)} of ${sum(({ total }) => total ?? 0)} MB`;
}
