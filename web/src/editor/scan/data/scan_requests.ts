/** What the page asks of the server about a scan. */

import type { LongRequests } from "../../../ui/long_requests";
import { type LandmarkPoints, readScan, type SeenScan } from "./scan_document";

/** The title of a fit among the long requests of the page. */
export const FIT_TITLE = "A face from a scan";

/** As what a face is taken. */
export interface Taking {
  readonly label: string;
  readonly hair_style: string;
  readonly hair: string;
  /** The item that it replaces; null: it is a new one. */
  readonly replaced: number | null;
}

/** Sends the files of one scan; an Error with a sentence where it cannot be read, CancelledError where it was ended. */
export async function bringScan(files: readonly File[], requests: LongRequests): Promise<SeenScan> {
  const form = new FormData();
  for (const file of files) form.append("file", file, file.name);
  return await scanIn(requests.fetch(FIT_TITLE, "/scans", { method: "POST", body: form }));
}

/** Fits a scan by points; errors as `bringScan`. */
export async function fitAgain(
  { token }: SeenScan,
  points: LandmarkPoints,
  shut: boolean | null,
  requests: LongRequests,
): Promise<SeenScan> {
  const body = JSON.stringify({ points, shut });
  return await scanIn(requests.fetch(FIT_TITLE, `/scans/${token}`, { method: "POST", body }));
}

/** What a face that was taken is called: its name in the show, and as people read it. */
export interface Taken {
  readonly name: string;
  readonly label: string;
}

/** Takes the face of a scan. An Error with a sentence where that fails. */
export async function takeFace(
  { token }: Pick<SeenScan, "token">,
  taking: Taking,
  requests: LongRequests,
): Promise<Taken> {
  const body = JSON.stringify(taking);
  const answer = await answerOf(
    requests.fetch(`Face ${taking.label}`, `/scans/${token}/face`, { method: "POST", body }),
  );
  const { items } = (await answer.json()) as { items: Taken[] };
  return items[0] ?? { name: "", label: taking.label };
}

/** Throws a scan away, even while the page closes. */
export function dropScan({ token }: Pick<SeenScan, "token">): void {
  void fetch(`/scans/${token}`, { method: "DELETE", keepalive: true }).catch(() => undefined); // it goes by itself later
}

const scanIn = async (coming: Promise<Response | null>): Promise<SeenScan> => readScan(await bytesOf(coming));

/** What a request is answered with; an Error with a sentence where it is refused. */
export async function bytesOf(coming: Promise<Response | null>): Promise<Uint8Array> {
  const answer = await answerOf(coming);
  return new Uint8Array(await answer.arrayBuffer());
}

async function answerOf(coming: Promise<Response | null>): Promise<Response> {
  const answer = await coming;
  if (answer === null) throw new Error("The show's computer does not answer; try again.");
  if (!answer.ok) throw new Error(sentence(await answer.text()));
  return answer;
}

/** What the server says, as a sentence of its own; a file's name at its beginning stays as it is. */
export const sentence = (text: string): string => {
  const begun = /^\S+\.\w+: /.test(text) ? text : text.charAt(0).toUpperCase() + text.slice(1);
  return /[.!?]$/.test(begun) ? begun : `${begun}.`;
};
