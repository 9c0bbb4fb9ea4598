/** Who sits at this page: an id that a reload keeps, so that it finds its draft, and a name that other editors read. */

import type { Who } from "./editing_link";

const ID = "omote-editor";
const NAME = "omote-editor-name";
/** Milliseconds that a reloaded page waits for its former self to be gone. */
const GONE = 1500;

/** `randomUUID` is not there on a LAN without https. */
const newId = (): string => [...crypto.getRandomValues(new Uint32Array(2))].map((part) => part.toString(36)).join("");

/** Storage may be shut off; then every load is a new editor. */
function kept(storage: () => Storage, key: string): string | null {
  try {
    return storage().getItem(key);
  } catch {
    return null;
  }
}

function keep(storage: () => Storage, key: string, value: string): void {
  try {
    storage().setItem(key, value);
  } catch {
    // the draft is then found by no reload, which the server's own copy outlives
  }
}

/** True when no other tab of this browser works under an id; it is then this tab's while it lives. */
function claim(id: string, patience: number): Promise<boolean> {
  if (navigator.locks === undefined) return Promise.resolve(true); // a LAN without https
  return new Promise((claimed) => {
    const held = (): Promise<never> => {
      claimed(true);
      return new Promise(() => undefined);
    };
    navigator.locks.request(`${ID}-${id}`, { signal: AbortSignal.timeout(patience) }, held).catch(() => claimed(false));
  });
}

/** This tab's own id, else the browser's, else a new one: two tabs are two editors. */
async function editorId(): Promise<string> {
  const [own, shared] = [kept(() => sessionStorage, ID), kept(() => localStorage, ID)];
  for (const id of [own, shared]) if (id !== null && (await claim(id, id === own ? GONE : 100))) return id;
  const id = newId();
  await claim(id, GONE);
  if (shared === null) keep(() => localStorage, ID, id);
  return id;
}

export async function whoIsHere(): Promise<Who> {
  const editor = await editorId();
  keep(() => sessionStorage, ID, editor);
  return { editor, name: kept(() => localStorage, NAME) ?? `Editor ${editor.slice(-3).toUpperCase()}` };
}

/** The name that others read from the next greeting on. */
export const keepName = (name: string): void => keep(() => localStorage, NAME, name);
