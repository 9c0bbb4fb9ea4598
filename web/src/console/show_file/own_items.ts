/** The crew's own faces and expressions, as a console changes them: keep, name, delete, copy; each can be taken back. */

import { editorAddress } from "../../link/editor_address";
import { type Axis, callOf } from "../store/axis";
import type { ConsoleStore } from "../store/console_store";
import type { Offer } from "../store/page_store";
import type { Change, Step } from "../store/undo_history";

/** Milliseconds within which a second press of *Keep* is the same. */
const TWICE = 800;

/** Characters at most, as the wire has it. */
export const LONGEST_ITEM_NAME = 80;

/** An own face or expression by its name in the cast, and what people read. */
export interface OwnItem {
  readonly kind: Axis;
  readonly name: string;
  readonly label: string;
}

/** What is being named: `item` is null while what was kept is not in the cast yet. */
export interface Naming {
  readonly kind: Axis;
  item: OwnItem | null;
  /** Only what has just been kept: it has a name already, and the field goes away by itself. */
  readonly fresh: boolean;
  /** The name that the show refused, and why. */
  readonly refused?: RefusedName;
}

export interface RefusedName {
  readonly label: string;
  readonly reason: string;
  /** Whoever typed it has gone on elsewhere: the field does not take the focus back. */
  readonly left: boolean;
}

declare module "../controls/console_element" {
  interface ConsoleContext {
    readonly items: OwnItems;
  }
}

export class OwnItems {
  #naming: Naming | null = null;
  /** Names that were typed before what was kept came, and whether their field was left for something else. */
  readonly #wanted = new WeakMap<Naming, readonly [label: string, left: boolean]>();
  readonly #kept: Record<Axis, number> = { face: Number.NEGATIVE_INFINITY, expression: Number.NEGATIVE_INFINITY };

  /** `typing`: whether people here have keys, so that a name is asked for at once. */
  constructor(
    private readonly store: ConsoleStore,
    private readonly now: () => number,
    private readonly typing: () => boolean = () => true,
  ) {
    store.listen("link", () => {
      if (this.#naming?.item === null) this.#name(null); // the answer is not heard any more
    });
  }

  get naming(): Naming | null {
    return this.#naming;
  }

  /** Keeps what is on air on an axis as a new face or expression of the cast, and asks for its name. */
  keep(kind: Axis): void {
    if (this.now() - this.#kept[kind] < TWICE) return;
    const naming: Naming = { kind, item: null, fresh: true };
    const type = kind === "face" ? "keep_face" : "keep_expression";
    const sent = this.store.ask(
      { type, character: this.store.played.lead },
      {
        busy: `the ${kind} on air is being kept`,
        kept: ({ name, label }) => this.#received(naming, { kind, name, label }),
        refused: () => {
          if (this.#naming === naming) this.#name(null);
        },
      },
    );
    if (!sent) return;
    this.#kept[kind] = this.now();
    this.store.say(`Keeping the ${kind} on air ...`, "done"); // what is computed first may take seconds
    if (this.typing()) this.#name(naming);
  }

  /** Asks for another name of an item. */
  beginNaming(item: OwnItem): void {
    this.store.say(null); // its *Undo*, beside the field, would be taken for this one's
    this.#name({ kind: item.kind, item, fresh: false });
  }

  /** The name that was typed; where it is empty, the item's stays as it is. `left`: by going on elsewhere. */
  endNaming(naming: Naming, typed: string, left = false): void {
    const [label, { item }] = [typed.trim(), naming];
    if (this.#naming === naming) this.#name(null);
    if (label === "") return;
    if (item === null) this.#wanted.set(naming, [label, left]);
    else if (label !== item.label) this.#rename(item, label, left);
  }

  #rename(item: OwnItem, label: string, left: boolean): void {
    this.store.ask(
      { type: "rename_item", kind: item.kind, name: item.name, label },
      {
        item_changed: ({ label: now, before }) => this.#offerRenamed(item, now, before),
        refused: ({ reason }) => this.#askAgain(item, { label, reason, left }),
      },
    );
  }

  /** What was typed stands in the field again, with the reason; where another name is typed by now, that is not disturbed. */
  #askAgain(item: OwnItem, refused: RefusedName): true {
    const says = `Not renamed (${item.label}): ${refused.reason}`;
    if (this.#naming !== null) this.store.say(says);
    else {
      this.store.say(null);
      this.store.log(says, "attention");
      this.#name({ kind: item.kind, item, fresh: false, refused });
    }
    return true;
  }

  /** Deletes an item at once: it can be brought back. What is on air stays; the show says so. */
  delete(item: OwnItem): void {
    const step = { what: `delete ${item.label}`, undo: [restoring(item)], redo: [deleting(item)] };
    const said = `Deleted ${item.label}: no console has it any more. Faces and layouts made with it stay as they are.`;
    this.store.ask(deleting(item), { item_changed: () => this.store.offerUndo(said, step) });
  }

  /** Why an item cannot be deleted now; null where it can. */
  whyKept({ kind, name }: OwnItem): string | null {
    const characters = Object.values(this.store.state?.characters ?? {});
    if (kind === "face" && characters.some((character) => character.home_face === name))
      return "it is the home face; choose another in Set-up";
    const weights = characters.flatMap((character) =>
      kind === "face" ? [character.faces] : [character.expressions, character.channels],
    );
    if (weights.some((all) => (all[name] ?? 0) !== 0)) return "it is on air; call another first";
    return characters.some((character) => callOf(character, kind)?.target === name)
      ? "it is coming; call another first"
      : null;
  }

  /** Makes a second one of an item, under a name of its own. */
  copy(item: OwnItem): void {
    this.store.ask(
      { type: "copy_item", kind: item.kind, name: item.name },
      {
        busy: `${item.label} is being copied`,
        kept: ({ name, label }) => {
          const copy = { kind: item.kind, name, label };
          const step = { what: `keep ${label} too`, undo: [deleting(copy)], redo: [restoring(copy)] };
          this.store.offerUndo(`Both are there: ${item.label} and ${label}.`, step);
        },
      },
    );
  }

  /** What takes items that came in out of the cast again, and back. */
  stepOf(what: string, items: readonly OwnItem[]): Step {
    return { what, undo: items.map((item) => deleting(item)), redo: items.map(restoring) };
  }

  #received(naming: Naming, item: OwnItem): void {
    const { kind, name, label } = item;
    const step = { what: `keep ${label}`, undo: [deleting(item, true)], redo: [restoring(item)] };
    const edit: Offer = { label: "Edit it", address: editorAddress(kind, name) };
    const rename: Offer = { label: "Name it", act: () => this.beginNaming(item) };
    this.store.offerUndo(`Kept as ${label} under Own.`, step, this.typing() ? [edit] : [rename, edit]);
    const wanted = this.#wanted.get(naming);
    naming.item = item;
    if (wanted !== undefined) this.#rename(item, ...wanted);
    this.store.tell("naming");
  }

  #offerRenamed(item: OwnItem, label: string, before: string): void {
    const to = (wanted: string): Change[] => [{ type: "rename_item", kind: item.kind, name: item.name, label: wanted }];
    const step = { what: `rename ${before}`, undo: to(before), redo: to(label) };
    this.store.offerUndo(`${before} is called ${label} now.`, step);
  }

  #name(naming: Naming | null): void {
    this.#naming = naming;
    this.store.tell("naming");
  }
}

const deleting = ({ kind, name }: OwnItem, unedited = false) =>
  ({ type: "delete_item", kind, name, unedited }) as const;

const restoring = ({ kind, name }: OwnItem) => ({ type: "restore_item", kind, name }) as const;
