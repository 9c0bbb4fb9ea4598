/** What a browser keeps of how somebody likes to work: the faces that are shown, and whether Mirror is on. */

import { type BrowserStorage, keep, readKept, readRecord } from "../../ui/browser_storage";
import type { DraftStore } from "./draft_store";
import { MOST_NEIGHBOURS } from "./editor_store";

const KEY = "omote-editor-view";

export interface ViewSettings {
  readonly work: string;
  readonly neighbours: readonly string[];
  readonly mirror: boolean;
}

/** Whether the lines of muscles lie on the face: they pull at expressions, so a face under work shows none. */
export const showsMuscles = ({ options, face }: Pick<DraftStore, "options" | "face">): boolean =>
  options.muscles && face === null;

const isName = (name: unknown): name is string => typeof name === "string" && name !== "" && name.length <= 200;

/** What was kept, as far as it makes sense: anything may stand in a browser's storage. */
export function readViewSettings(text: string): Partial<ViewSettings> {
  const { work, neighbours, mirror } = readRecord(text);
  return {
    ...(isName(work) ? { work } : {}),
    ...(Array.isArray(neighbours) ? { neighbours: neighbours.filter(isName).slice(0, MOST_NEIGHBOURS) } : {}),
    ...(typeof mirror === "boolean" ? { mirror } : {}),
  };
}

/** Takes up how it was left, before the cast comes (which drops names that it has not), and keeps each change. */
export function keepViewSettings(store: DraftStore, storage: BrowserStorage = () => localStorage): void {
  const view = readViewSettings(readKept(storage, KEY));
  store.work = view.work ?? store.work;
  store.neighbours = view.neighbours ?? store.neighbours;
  store.setOptions({ mirror: view.mirror ?? store.options.mirror });
  const keepView = (): void => {
    if (store.library === null) return; // nobody has chosen anything yet
    const { work, neighbours, options } = store;
    keep(storage, KEY, JSON.stringify({ work, neighbours, mirror: options.mirror } satisfies ViewSettings));
  };
  store.listen("cast", keepView);
  store.listen("options", keepView);
}
