/** What a browser keeps of how somebody likes to work: the faces that are shown, and whether Mirror is on. */

import type { DraftStore } from "./draft_store";
import { MOST_NEIGHBOURS } from "./editor_store";

const KEY = "omote-editor-view";

export interface View {
  readonly work: string;
  readonly neighbours: readonly string[];
  readonly mirror: boolean;
}

/** Whether the lines of muscles lie on the face: they pull at expressions, so a face under work shows none. */
export const showsMuscles = ({ options, face }: Pick<DraftStore, "options" | "face">): boolean =>
  options.muscles && face === null;

/** Reads and writes text by key; both may throw. */
type Store = Pick<Storage, "getItem" | "setItem">;

const isName = (name: unknown): name is string => typeof name === "string" && name !== "" && name.length <= 200;

/** What was kept, as far as it makes sense: anything may stand in a browser's storage. */
export function readViewSettings(text: string | null): Partial<View> {
  let kept: unknown;
  try {
    kept = JSON.parse(text ?? "null");
  } catch {
    return {};
  }
  if (typeof kept !== "object" || kept === null) return {};
  const { work, neighbours, mirror } = kept as Record<string, unknown>;
  return {
    ...(isName(work) ? { work } : {}),
    ...(Array.isArray(neighbours) ? { neighbours: neighbours.filter(isName).slice(0, MOST_NEIGHBOURS) } : {}),
    ...(typeof mirror === "boolean" ? { mirror } : {}),
  };
}

/** Takes up how it was left, before the cast comes (which drops names that it has not), and keeps each change. */
export function keepViewSettings(store: DraftStore, storage: () => Store = () => localStorage): void {
  const view = readViewSettings(attempt(() => storage().getItem(KEY)) ?? null);
  store.work = view.work ?? store.work;
  store.neighbours = view.neighbours ?? store.neighbours;
  store.setOptions({ mirror: view.mirror ?? store.options.mirror });
  const keep = (): void => {
    if (store.library === null) return; // nobody has chosen anything yet
    const { work, neighbours, options } = store;
    const text = JSON.stringify({ work, neighbours, mirror: options.mirror } satisfies View);
    attempt(() => storage().setItem(KEY, text));
  };
  store.listen("cast", keep);
  store.listen("options", keep);
}

/** Storage may be shut off or full: then each load begins anew. */
function attempt<T>(does: () => T): T | undefined {
  try {
    return does();
  } catch {
    return undefined;
  }
}
