/** Who sits at this page: an id that the browser keeps, so that a reload finds its draft, and a name for the others. */

import type { Identity } from "./editor_link";

const ID = "omote-editor";
const NAME = "omote-editor-name";

/** `randomUUID` is not there on a LAN without https. */
const newId = (): string => [...crypto.getRandomValues(new Uint32Array(2))].map((part) => part.toString(36)).join("");

/** What the browser keeps under a key; storage may be shut off, then nothing is. */
function kept(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

function keep(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    // then each load is a new editor; the draft stays on the server under the old id
  }
}

/** Two windows of one browser are one editor: they share their drafts. */
export function readIdentity(): Identity {
  const editor = kept(ID) ?? newId();
  keep(ID, editor);
  return { editor, name: kept(NAME) ?? `Editor ${editor.slice(-3).toUpperCase()}` };
}

/** The name from the next greeting on. */
export const saveName = (name: string): void => keep(NAME, name);
