/** Files dropped on a page or chosen there, which the show takes in as expressions or faces. */

export type ImportKind = "expression" | "face";

/** What the show made of a file: the labels of the new items, and what it says of each. */
export interface Imported {
  readonly labels: readonly string[];
  readonly said: readonly string[];
}

/** What a page may be given of each kind, as a file dialog has it. */
export const ACCEPTED: Readonly<Record<ImportKind, string>> = { expression: ".json,.glb,.obj", face: ".glb,.obj" };

/** Sends one file; an Error with a sentence where the show cannot take it in. */
export async function importFile(file: File, kind: ImportKind): Promise<Imported> {
  const address = `/imports/${encodeURIComponent(file.name)}?as=${kind}`;
  const answer = await fetch(address, { method: "POST", body: file }).catch(() => null);
  if (answer === null) throw new Error(`${file.name} was not sent: the show's computer does not answer; try again.`);
  if (!answer.ok) throw new Error(`${file.name} was not taken in: ${await answer.text()}`);
  return (await answer.json()) as Imported;
}

/** Sends files one after the other; a sentence about all that came in, and one about each that did not. */
export async function importFiles(
  files: readonly File[],
  kind: ImportKind,
): Promise<{ done: string; failed: string[] }> {
  const [came, failed] = [[] as string[], [] as string[]];
  for (const file of files)
    await importFile(file, kind).then(
      ({ said }) => void came.push(...said),
      (error: unknown) => void failed.push((error as Error).message),
    );
  return { done: came.length === 0 ? "" : `Taken in, under Own: ${came.join("; ")}.`, failed };
}

/** Without this the browser would leave the page for a file. Calls `dropped` with files that are dropped anywhere on the page, until what it gives is called. */
export function onFileDrop(dropped: (files: readonly File[], event: DragEvent) => void): () => void {
  const ending = new AbortController();
  const { signal } = ending;
  window.addEventListener("dragover", holdFiles, { signal });
  window.addEventListener(
    "drop",
    (event) => {
      if (!holdFiles(event)) return;
      dropped([...(event.dataTransfer?.files ?? [])], event);
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
