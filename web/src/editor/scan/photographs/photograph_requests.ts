/** What the page asks of the server about photographs; they are taken and thrown away as scans are. */

import type { LongRequests } from "../../../ui/long_requests";
import { bytesOf } from "../data/scan_requests";
import { readPhotographs, type SeenPhotographs } from "./photograph_document";
import type { PhotographPoints } from "./photograph_points";

/** The title of a fit among the long requests of the page. */
export const PHOTOGRAPH_TITLE = "A face from photographs";
const DIGITS = 1e5;

/** Sends photographs with their landmarks; an Error with a sentence where no face can be made, CancelledError where it
 * was ended. */
export async function bringPhotographs(points: PhotographPoints, requests: LongRequests): Promise<SeenPhotographs> {
  const form = new FormData();
  for (const { file, picture } of points.all) form.append("file", picture, file);
  form.append("file", new Blob([landmarksOf(points)]), "landmarks.json");
  const body = { method: "POST", body: form };
  return readPhotographs(await bytesOf(requests.fetch(PHOTOGRAPH_TITLE, "/photographs", body)));
}

/** A photograph that this browser does not decode (HEIC, as telephones write it), as a JPEG; errors as
 * `bringPhotographs`. */
export async function decodePhotograph(file: File, requests: LongRequests): Promise<Blob> {
  const form = new FormData();
  form.append("file", file, file.name);
  const coming = requests.fetch(PHOTOGRAPH_TITLE, "/photographs/picture", { method: "POST", body: form });
  return new Blob([(await bytesOf(coming)) as Uint8Array<ArrayBuffer>], { type: "image/jpeg" });
}

/** Fits photographs by points that were moved; errors as `bringPhotographs`. */
export async function fitPhotographsAgain(
  { token }: SeenPhotographs,
  points: PhotographPoints,
  requests: LongRequests,
): Promise<SeenPhotographs> {
  const body = { method: "POST", body: landmarksOf(points) };
  return readPhotographs(await bytesOf(requests.fetch(PHOTOGRAPH_TITLE, `/photographs/${token}`, body)));
}

function landmarksOf(points: PhotographPoints): string {
  const short = (part: number): number => Math.round(DIGITS * part) / DIGITS;
  const photographs = points.all.map(({ file, name, width, height }, at) => {
    const rows = points.of(at);
    const triples = Array.from({ length: rows.length / 3 }, (_, row) =>
      [...rows.slice(3 * row, 3 * row + 3)].map(short),
    );
    return { file, name, width, height, points: triples };
  });
  return JSON.stringify(photographs);
}
