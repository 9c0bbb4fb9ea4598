/** What people do with items: make, open, save, undo, bring back, name, order, delete. */

import type { FaceRecipe, ItemDocument, Recipe, RevisionDocument, Saved } from "../../link/editing_messages";
import { type ImportKind, importFiles } from "../../ui/file_import";
import type { Request } from "../link/requests";
import { REST } from "./control_net";
import type { DraftStore } from "./draft_store";
import type { Described, Description } from "./editor_store";
import type { EditorNotice } from "./notices";

/** Where something new begins: sources by weight, or what is on air now. */
export interface Start {
  readonly mix: Readonly<Record<string, number>>;
  readonly onAir: boolean;
}

export type Kind = ItemDocument["kind"];

export function create(store: DraftStore, kind: Kind, label: string, { mix, onAir }: Start): Promise<unknown> {
  if (kind === "pose") return store.ask({ type: "create_pose", label, start: Object.keys(mix)[0] ?? "stand" });
  const request: Request =
    kind === "expression"
      ? { type: "create_expression", label, start: mix, on_air: onAir }
      : {
          type: "create_face",
          label,
          base: Object.keys(mix).length === 0 ? { generic: 1 } : normalised(mix),
          on_air: onAir,
        };
  return store.ask(request);
}

/** Opens an item, which may take long on a busy machine: until it is there the page says what it opens. */
export async function openItem(store: DraftStore, item: number): Promise<void> {
  const label = store.items.find(({ id }) => id === item)?.label ?? "";
  store.setOpening(label);
  const answer = await store.ask({ type: "open_item", item });
  if (store.opening === label) store.setOpening("");
  if (answer === null)
    store.say(`"${label}" was not opened.`, "refusal", [
      { label: "Open it again", act: () => void openItem(store, item) },
    ]);
}

/** What the cast has of a kind. */
function listed(manifest: DraftStore["manifest"], kind: Kind): readonly { name: string; label: string }[] {
  if (kind === "pose") return manifest?.figures?.poses ?? [];
  return (kind === "face" ? manifest?.faces : manifest?.expressions) ?? [];
}

/** A name for something new that nothing of its kind has yet, built in or own: `stem`, else with the first number
 * that is free. */
export function freeLabel(store: Pick<DraftStore, "items" | "manifest">, kind: Kind, stem: string): string {
  const own = store.items.filter((item) => item.kind === kind && !item.deleted);
  const builtIn = listed(store.manifest, kind);
  const taken = new Set([...own, ...builtIn].map(({ label }) => label.toLowerCase()));
  for (let number = 1; ; number += 1) {
    const label = number === 1 ? stem : `${stem} ${number}`;
    if (!taken.has(label.toLowerCase())) return label;
  }
}

/** Takes files in, and says what came of each, with what else can be done with those that were refused. */
export async function takeIn(
  store: DraftStore,
  files: readonly File[],
  kind: ImportKind,
  otherwise: EditorNotice["actions"] = [],
): Promise<void> {
  const { done, failed } = await importFiles(files, kind, store.longRequests);
  if (done !== "") store.say(done, "done");
  for (const sentence of failed) store.say(sentence, "refusal", otherwise);
}

/** Takes in a head, and says so; false where it cannot be, of which nothing is said. */
export async function takeInHead(store: DraftStore, file: File, kind: ImportKind): Promise<boolean> {
  const { done, failed } = await importFiles([file], kind, store.longRequests);
  if (done !== "") store.say(done, "done");
  return failed.length === 0;
}

// --- the open item ----------------------------------------------------------------------------------------------------

export async function save(store: DraftStore, note: string): Promise<void> {
  if (store.draft === null) return;
  const { item, base } = store.draft;
  const answer = await store.ask({ type: "save", item, note });
  if (answer?.type !== "saved") return;
  if (store.draft?.item === item && store.draft.base === base && !answer.aside) {
    store.receive({ ...store.draft, request: -1, net: null, base: answer.revision, dirty: false });
  }
  store.clear("conflict"); // what was to be decided is
  if (answer.aside) tellAside(store, answer);
  else if (answer.revision === base)
    store.say(answer.sentence, "done"); // nothing was new
  else tellSaved(store, answer);
  askHistory(store);
}

function tellSaved(store: DraftStore, { item }: Saved): void {
  const saved = store.items.find(({ id }) => id === item);
  const place = { face: "among the faces", pose: "among the poses", expression: "under Own" }[
    saved?.kind ?? "expression"
  ];
  const sentence = `Saved. On the console "${saved?.label ?? ""}" is now ${place}: call it there.${leftOut(store)}${atRest(store.recipe) ? AT_REST : ""}`;
  store.say(sentence, "done", [{ label: "Open the console", act: () => void window.open("/console", "_blank") }]);
}

const AT_REST = " It moves nothing yet: all points, layers, muscles and eyes are at rest.";

/** Whether an expression moves nothing: it has no ground, and nobody has touched it. */
function atRest(recipe: Recipe | null): boolean {
  if (recipe === null || recipe.ground !== null || recipe.pupil !== 0) return false;
  const still = recipe.vectors.every((vector) => vector.every((part, at) => part === REST[at]));
  const silent = recipe.layers.every(({ muted, weight }) => muted || weight === 0);
  const pale = recipe.complexion.every((part) => part === 0);
  return (
    pale &&
    still &&
    silent &&
    recipe.eyes.every((turn) => turn === 0) &&
    recipe.pulls.every((pull) => pull.contraction === 0)
  );
}

/** What a save has not in what plays, though it is on the page; and what it has, though the page shows less. */
function leftOut({ recipe, layerPreview }: DraftStore): string {
  const muted = (recipe?.layers ?? []).filter((layer) => layer.muted).map(({ label }) => `"${label}"`);
  const silent = muted.length === 0 ? "" : ` Muted, so not in what plays: ${muted.join(", ")}.`;
  return layerPreview.solo.size === 0 ? silent : `${silent} Solo is your view alone: all other layers are in it.`;
}

/** Another editor saved first: both versions are kept, and the user chooses which plays. */
function tellAside(store: DraftStore, { item, head, sentence }: Saved): void {
  store.say(sentence, "conflict", [
    { label: "Look at theirs", act: () => void lookAt(store, item, head) },
    { label: "Save mine over it", act: () => void saveOver(store, item) },
  ]);
}

/** Whichever item is open by now. */
async function saveOver(store: DraftStore, item: number): Promise<void> {
  if (store.draft?.item !== item) await openItem(store, item);
  if (store.draft?.item === item) await save(store, "over another's");
}

async function lookAt(store: DraftStore, item: number, number: number): Promise<void> {
  if (store.draft?.item !== item) await openItem(store, item);
  await store.ask({ type: "ask_history", item });
  const theirs = store.revisions.find((revision) => revision.number === number);
  if (theirs !== undefined && store.draft?.item === item) store.setLook(theirs.content);
}

/** What Undo takes back, in words; "" for nothing. */
export function nextUndo({ draft, deleted, described }: DraftStore): string {
  if (deleted !== null) return `delete of ${deleted.item.label}`;
  return described.at(-1)?.what ?? (draft === null || draft.undo === 0 ? "" : draft.what);
}

/** The last step of the open item, or the delete, the name, tags or place that came after it. */
export function undo(store: DraftStore): void {
  const { draft, deleted, described } = store;
  const last = described.at(-1);
  if (deleted !== null) {
    void bringItemBack(store, deleted);
    return;
  }
  if (last !== undefined) {
    void takeBack(store, last);
    return;
  }
  if (draft === null || draft.undo === 0) return;
  const { what } = draft;
  void store.ask({ type: "undo", item: draft.item }).then((answer) => {
    if (answer !== null) store.undone = [...store.undone, what];
    store.tell("options");
  });
}

export function redo(store: DraftStore): void {
  const { draft } = store;
  if (draft === null || draft.redo === 0) return;
  void store.ask({ type: "redo", item: draft.item }).then((answer) => {
    if (answer !== null) store.undone = store.undone.slice(0, -1);
    store.tell("options");
  });
}

export function askHistory(store: DraftStore): void {
  if (store.draft !== null) void store.ask({ type: "ask_history", item: store.draft.item });
}

/** The draft becomes what a revision was; says that it does not play yet. */
export async function bringBack(store: DraftStore, { number }: RevisionDocument): Promise<void> {
  const { draft } = store;
  if (draft === null) return;
  store.setLook(null);
  const answer = await store.ask({ type: "bring_back", item: draft.item, revision: number });
  if (answer === null) return;
  if (store.draft?.item === draft.item && !store.draft.dirty) {
    store.say(`Revision ${number} is what plays and what your draft is: there is nothing to save.`, "done");
    return;
  }
  const sentence = `Revision ${number} is your draft now. What plays is unchanged: press Save to make this one play.`;
  store.say(sentence, "done", [{ label: "Save", act: () => void save(store, `revision ${number} again`) }]);
}

export const bake = (store: DraftStore): void => store.edit({ type: "flatten" });

/** Weights that sum to one, in the same proportions; an even mix where all are zero. */
export function normalised(mix: FaceRecipe["base"]): FaceRecipe["base"] {
  const sum = Object.values(mix).reduce((total, weight) => total + weight, 0);
  const even = 1 / Object.keys(mix).length;
  return Object.fromEntries(Object.entries(mix).map(([name, weight]) => [name, sum > 0 ? weight / sum : even]));
}

/** A mix with one weight as it was given, at most all; the others share what is left, in the same proportions. */
export function weighed(mix: FaceRecipe["base"], source: string, weight: number): FaceRecipe["base"] {
  const others = Object.fromEntries(Object.entries(mix).filter(([name]) => name !== source));
  if (Object.keys(others).length === 0) return { [source]: 1 };
  const clamped = Math.min(1, Math.max(0, weight));
  const shared = Object.entries(normalised(others)).map(([name, share]) => [name, (1 - clamped) * share]);
  return { ...mix, ...Object.fromEntries(shared), [source]: clamped };
}

// --- any item ---------------------------------------------------------------------------------------------------------

/** Shown at once, so that what is typed next is not built on what was before; a refusal takes it back, and so does
 * Undo. */
export async function describe(store: DraftStore, item: ItemDocument, change: Description): Promise<void> {
  const before = store.items.find(({ id }) => id === item.id);
  if (before === undefined) return;
  const { label, tags, place } = before;
  const kept = { label, tags, place };
  const changed = Object.fromEntries(Object.keys(change).map((key) => [key, kept[key as keyof Description]]));
  const other = change.tags === undefined ? "order" : "tags";
  const what = change.label === undefined ? `${other} of ${label}` : `name ${change.label}`;
  const step = { item: item.id, before: changed, what };
  store.described = [...store.described, step];
  if (!(await put(store, item.id, change))) store.described = store.described.filter((each) => each !== step);
  else if (change.label !== undefined && isTaken(store, item, change.label))
    store.say(`Another ${item.kind} is called "${change.label}" too: on the console both read the same.`, "refusal");
  store.tell("options");
}

/** Whether another of its kind, built in or own, is called so. */
function isTaken({ items, manifest }: DraftStore, { id, kind }: ItemDocument, label: string): boolean {
  const own = items.filter((item) => item.kind === kind);
  const names = new Set(own.map(({ name }) => name));
  const builtIn = listed(manifest, kind);
  const others = [
    ...own.filter((item) => item.id !== id && !item.deleted),
    ...builtIn.filter(({ name }) => !names.has(name)),
  ];
  return others.some((other) => other.label.toLowerCase() === label.toLowerCase());
}

/** Undoes a change of a name, tags or a place, and offers to do it again. */
async function takeBack(store: DraftStore, step: Described): Promise<void> {
  const item = store.items.find(({ id }) => id === step.item);
  store.described = store.described.slice(0, -1);
  store.tell("options");
  if (item === undefined) return;
  const { label, tags, place } = item;
  const now = { label, tags, place };
  const again = Object.fromEntries(Object.keys(step.before).map((key) => [key, now[key as keyof Description]]));
  if (!(await put(store, step.item, step.before))) return;
  store.say(`Undone: ${step.what}.`, "done", [{ label: "Redo", act: () => void describe(store, item, again) }]);
}

/** Whether the show has taken it. */
async function put(store: DraftStore, id: number, change: Description): Promise<boolean> {
  const before = store.items.find((item) => item.id === id);
  if (before === undefined) return false;
  const show = (now: Description): void =>
    store.setItems(store.items.map((item) => (item.id === id ? { ...item, ...now } : item)));
  const { label, tags, place } = { ...before, ...change };
  if (label !== before.label) store.clear("done"); // good news that calls it by its old name
  show(change);
  const answer = await store.ask({ type: "describe", item: id, label, tags, place });
  if (answer === null) show({ label: before.label, tags: before.tags, place: before.place });
  return answer !== null;
}

export const duplicate = (store: DraftStore, { id, kind, label }: ItemDocument): void =>
  void store.ask({ type: "duplicate", item: id, label: freeLabel(store, kind, `${label} copy`) });

export async function remove(store: DraftStore, item: ItemDocument): Promise<void> {
  const answer = await store.ask({ type: "delete", item: item.id });
  if (answer === null) return;
  const gone = { item, open: store.draft?.item === item.id };
  store.deleted = gone;
  if (gone.open) store.leave();
  else store.tell("draft");
  const still = item.kind === "face" ? ", and is still in the show file: omote file forget removes it for good" : "";
  store.say(`"${item.label}" is deleted${still}.`, "done", [
    { label: "Undo", act: () => void bringItemBack(store, gone) },
  ]);
}

/** Undoes a delete: the item is in its place again, and open where it was. */
async function bringItemBack(store: DraftStore, { item, open }: NonNullable<DraftStore["deleted"]>): Promise<void> {
  const { openings } = store;
  const answer = await store.ask({ type: "restore", item: item.id });
  store.tell("draft");
  if (answer === null) return;
  store.say(`"${item.label}" is back.`, "done");
  if (open && openings === store.openings) await openItem(store, item.id);
}

export const restore = (store: DraftStore, { id }: ItemDocument): void => void store.ask({ type: "restore", item: id });

/** Words of a search are all found in an item's name or tags. */
export function matches(words: string, label: string, tags: readonly string[] = []): boolean {
  const text = [label, ...tags].join(" ").toLowerCase();
  return words
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

/** Own items of a kind in their order. */
export const ordered = (items: readonly ItemDocument[], kind: Kind): ItemDocument[] =>
  items.filter((item) => item.kind === kind).sort((a, b) => a.place - b.place || a.id - b.id);

/** The place that puts an item between its new neighbours: `others` in order, without the item; it comes before `at`. */
export function placeAt(others: readonly ItemDocument[], at: number): number {
  const [before, after] = [others[at - 1]?.place, others[at]?.place];
  if (before === undefined) return (after ?? 1) - 1;
  return after === undefined ? before + 1 : (before + after) / 2;
}

/** The names of those at an item but for one's own, once: another editor may bear the same. */
export function othersOf(editors: readonly string[], name: string): string[] {
  const own = editors.indexOf(name);
  return editors.filter((_, at) => at !== own);
}
