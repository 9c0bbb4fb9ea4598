/** Files dropped on a page: without this the browser would leave the page for the file. */

/** Calls `dropped` with files that are dropped anywhere on the page, until what it gives is called. */
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
