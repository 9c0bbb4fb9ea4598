/** Files dropped on a page or chosen there, which the show takes in as expressions or faces. */

import { suffixesOf } from "./file_contents";
import { joinGltf } from "./joined_gltf";
import { CancelledError, LongRequests } from "./long_requests";

export type ImportKind = "expression" | "face";

/** An item that a file brought, as it is in the show; known: it was there already, so nothing new came. */
export interface TakenIn {
  readonly kind: ImportKind;
  readonly name: string;
  readonly label: string;
  readonly known: boolean;
}

/** What the show made of a file: its items, and what it says of each. */
export interface Imported {
  readonly items: readonly TakenIn[];
  readonly said: readonly string[];
}

/** What a page may be given of each kind, as a file dialog has it. */
export const ACCEPTED: Readonly<Record<ImportKind, string>> = {
  expression: suffixesOf("document", "shape").join(","),
  face: suffixesOf("shape").join(","),
};

/** Sends one file; an Error with a sentence where the show cannot take it in, CancelledError where it was ended. */
export async function importFile(file: File, kind: ImportKind, requests = new LongRequests()): Promise<Imported> {
  const address = `/imports/${encodeURIComponent(file.name)}?as=${kind}`;
  const answer = await requests.fetch(`Import of ${file.name}`, address, { method: "POST", body: file });
  if (answer === null) throw new Error(`${file.name} was not sent: the show's computer does not answer; try again.`);
  if (!answer.ok) throw new Error(`${file.name} was not taken in: ${asSentence(await answer.text())}`);
  return (await answer.json()) as Imported;
}

/** Sends files one after the other; a sentence about all that came in, and one about each that did not. One that is
 * cancelled is the last. */
export async function importFiles(
  files: readonly File[],
  kind: ImportKind,
  requests = new LongRequests(),
): Promise<{ done: string; failed: string[] }> {
  const [came, same, failed] = [[] as string[], [] as string[], [] as string[]];
  let ended = "";
  const sent = await joinGltf(files);
  for (const [place, file] of sent.entries()) {
    if (ended !== "") break;
    await importFile(file, kind, requests).then(
      (imported) => {
        const nothingNew = imported.items.every(({ known }) => known);
        if (nothingNew) same.push(`Nothing new in ${file.name}: ${sayTakenIn(imported)}.`);
        else came.push(sayTakenIn(imported));
      },
      (error: Error) => {
        if (error instanceof CancelledError) ended = error.message + notSent(sent.length - place - 1);
        else failed.push(error.message);
      },
    );
  }
  const taken = came.length === 0 ? "" : `Taken in, under Own: ${came.join("; ")}.`;
  return { done: [taken, ...same, ended].filter(Boolean).join(" "), failed };
}

/** Items of a file that are named each, where there are more the others are counted. */
const MOST_NAMED = 4;

/** What to say of the items that a file brought. */
export function sayTakenIn({ items, said }: Imported): string {
  const sentences = items.map((item, index) => sentenceOf(item, said[index] ?? item.label));
  const existingCount = items.filter((item) => item.known).length;
  if (items.length <= MOST_NAMED) return sentences.join("; ");
  if (existingCount === items.length) return `all ${existingCount} are there already, ${items[0]?.label} and others`;
  const named = sentences.filter((_, index) => items[index]?.known === false).slice(0, MOST_NAMED - 1);
  const more = items.length - existingCount - named.length;
  const parts = [
    ...named,
    ...(more > 0 ? [`${more} more`] : []),
    ...(existingCount > 0 ? [`${existingCount} are there already`] : []),
  ];
  return parts.join("; ");
}

function sentenceOf({ label, known }: TakenIn, said: string): string {
  if (known) return `${label} is there already`;
  return said.includes(label) ? said : `${said}, named ${label}`;
}

const notSent = (files: number): string =>
  files === 0 ? "" : ` ${files} more ${files === 1 ? "file was" : "files were"} not sent.`;

const asSentence = (text: string): string => (/[.!?]$/.test(text) ? text : `${text}.`);

/** Parts what was dropped into files and what no page can read, with a sentence about the latter; "" where all are files. */
export async function readableOf(dropped: readonly File[]): Promise<[files: readonly File[], refused: string]> {
  if (dropped.length === 0) return [[], "Nothing that a page can read was dropped: drop files."];
  const reads = await Promise.all(
    dropped.map((file) =>
      file
        .slice(0, 1)
        .arrayBuffer()
        .then(
          () => true,
          () => false,
        ),
    ),
  );
  const lost = dropped.filter((_, place) => !reads[place]).map(({ name }) => name);
  const refused =
    lost.length === 0
      ? ""
      : `${lost.join(", ")} cannot be read: a folder, or a file that is there no more. Drop the files in it.`;
  return [dropped.filter((_, place) => reads[place]), refused];
}

/**
 * Without this the browser would leave the page for a file. Calls `dropped` with files that are dropped anywhere on the
 * page, and `refused` with a sentence about what is none, until what it gives is called.
 */
export function onFileDrop(
  dropped: (files: readonly File[]) => void = () => undefined,
  refused: (sentence: string) => void = () => undefined,
): () => void {
  const ending = new AbortController();
  const { signal } = ending;
  window.addEventListener("dragover", holdFiles, { signal });
  window.addEventListener(
    "drop",
    (event) => {
      if (!holdFiles(event)) return;
      void readableOf([...(event.dataTransfer?.files ?? [])]).then(([files, sentence]) => {
        if (sentence !== "") refused(sentence);
        if (files.length > 0) dropped(files);
      });
    },
    { signal },
  );
  return () => ending.abort();
}

/** Keeps the browser from opening files; false for what is dragged inside the page. */
function holdFiles(event: DragEvent): boolean {
  if (event.dataTransfer?.types.includes("Files") !== true) return false;
  event.preventDefault();
  return true;
}
