/** The macros of the character whose values the controls show, and what an operator does with them, with undo. */

import { LONGEST_MACRO } from "../../link/constants";
import type { MacroMapping, MappingLearned } from "../../link/messages";
import type { ConsoleStore } from "../store/console_store";
import type { Change } from "../store/undo_history";
import { freeName, targetChoices } from "./macro_targets";

declare module "../controls/console_element" {
  interface ConsoleContext {
    readonly mappings: MappingCommands;
  }
}

/** Milliseconds between two mappings that are sent while a knot is dragged. */
const LIVE_MS = 100;
/** Milliseconds after which what the show says counts, whatever was asked of it. */
const ANSWERED_MS = 1500;

/** A mapping that was asked for and that the show has not said yet. */
interface Draft {
  readonly character: string;
  readonly mapping: MacroMapping;
  /** Milliseconds; from then on what the show says counts; infinite while a hand is on it. */
  readonly until: number;
}

export class MappingCommands {
  /** Why the last change was rejected, "" where it was not. */
  refused = "";
  #chosen = "";
  #draft: Draft | null = null;
  /** What a drag began from. */
  #before: MacroMapping | null = null;
  #sent = Number.NEGATIVE_INFINITY;

  constructor(
    readonly store: ConsoleStore,
    private readonly now: () => number = () => performance.now(),
  ) {
    store.hear("mapping_list", () => this.#settle());
    store.listen("link", () => this.#relink());
  }

  /** Whose macros are shown. */
  get character(): string {
    return this.store.played.lead;
  }

  /** Its mappings; one that is changed here is as it will be. */
  get list(): readonly MacroMapping[] {
    const draft = this.#draft;
    if (draft === null || draft.character !== this.character) return this.#told;
    return this.#told.map((mapping) => (mapping.name === draft.mapping.name ? draft.mapping : mapping));
  }

  get #told(): readonly MacroMapping[] {
    return this.store.newest("mapping_list")?.mappings[this.character] ?? [];
  }

  /** Targets of its macros that there are not: they give nothing. */
  get missing(): readonly string[] {
    return this.store.newest("mapping_list")?.missing[this.character] ?? [];
  }

  /** What a macro can play, with what people call it. */
  get choices(): ReturnType<typeof targetChoices> {
    return targetChoices(this.store.expressions, this.store.newest("pad_list")?.pads ?? []);
  }

  /** What is taught by touch now, null for nothing. */
  get learned(): MappingLearned | null {
    const learned = this.store.online ? this.store.newest("mapping_learned") : null;
    return learned === null || learned.name === "" ? null : learned;
  }

  /** The one whose curves are shown, null where there is none. */
  get chosen(): MacroMapping | null {
    return this.list.find(({ name }) => name === this.#chosen) ?? this.list[0] ?? null;
  }

  choose(name: string): void {
    this.#chosen = name;
    this.refused = "";
    this.#tell();
  }

  /** A new macro, or another mapping in the place of one; `what` was done, for people. */
  change(mapping: MacroMapping, what: string): void {
    const dragged = this.#before;
    const before = dragged ?? this.#told.find(({ name }) => name === mapping.name) ?? null;
    this.#before = null;
    if (JSON.stringify(before) === JSON.stringify(mapping)) {
      if (dragged !== null) this.store.ask(this.#setting(mapping)); // dragged there and back
      this.#drop();
      return;
    }
    this.#hold(mapping, this.now() + ANSWERED_MS);
    const undo = before === null ? this.#dropping(mapping.name) : this.#setting(before);
    if (!this.#act(`Changed: ${what}.`, what, [undo], [this.#setting(mapping)])) this.#drop();
  }

  /** A mapping that a hand changes just now: it plays at once, and `change` ends it. */
  play(mapping: MacroMapping): void {
    this.#before ??= this.#told.find(({ name }) => name === mapping.name) ?? null;
    this.#hold(mapping, Number.POSITIVE_INFINITY);
    const now = this.now();
    if (now - this.#sent < LIVE_MS || !this.store.online) return;
    this.#sent = now;
    this.store.ask(this.#setting(mapping));
  }

  rename(name: string, to: string): void {
    const { character } = this;
    const undo: Change = { type: "rename_mapping", character, name: to, to: name };
    const redo: Change = { type: "rename_mapping", character, name, to };
    if (this.#act(`The macro ${name} is called ${to}.`, `name ${to}`, [undo], [redo])) this.#chosen = to;
  }

  copy(mapping: MacroMapping): void {
    const taken = this.list.map(({ name }) => name);
    const name = freeName(mapping.name, taken, LONGEST_MACRO);
    const redo = this.#setting({ ...mapping, name });
    if (this.#act(`${name} is a copy of ${mapping.name}.`, `copy ${name}`, [this.#dropping(name)], [redo]))
      this.choose(name);
  }

  drop(mapping: MacroMapping): void {
    const { name } = mapping;
    const undo = this.#setting(mapping);
    this.#act(`The macro ${name} is deleted.`, `delete macro ${name}`, [undo], [this.#dropping(name)]);
  }

  /** A mapping was learned by touch; `before`: what was there under its name. */
  noteLearned(mapping: MacroMapping, before: MacroMapping | null): void {
    const undo = before === null ? this.#dropping(mapping.name) : this.#setting(before);
    const what = `learned macro ${mapping.name}`;
    const { length } = mapping.targets;
    this.store.offerUndo(`Learned: ${mapping.name} plays ${length} ${length === 1 ? "target" : "targets"}.`, {
      what,
      undo: [undo],
      redo: [this.#setting(mapping)],
    });
    this.choose(mapping.name);
  }

  #setting(mapping: MacroMapping) {
    return { type: "set_mapping", character: this.character, mapping } as const;
  }

  #dropping(name: string) {
    return { type: "drop_mapping", character: this.character, name } as const;
  }

  #act(done: string, what: string, undo: readonly Change[], redo: readonly Change[]): boolean {
    const step = { what, undo, redo };
    this.refused = "";
    const refused = (reason: string): void => {
      this.store.history.skip(step);
      this.refused = reason;
      this.#drop();
    };
    if (!this.store.takeStep(step, "redo", refused)) return false;
    this.store.offerUndo(done, step);
    return true;
  }

  #hold(mapping: MacroMapping, until: number): void {
    this.#draft = { character: this.character, mapping, until };
    this.#tell();
  }

  /** What the show says counts again. */
  #drop(): void {
    this.#draft = null;
    this.#tell();
  }

  #settle(): void {
    const draft = this.#draft;
    if (draft === null || draft.until === Number.POSITIVE_INFINITY) return;
    const told = this.#told.find(({ name }) => name === draft.mapping.name);
    if (this.now() > draft.until || JSON.stringify(told) === JSON.stringify(draft.mapping)) this.#draft = null;
  }

  /** A show that has none says nothing of them: what was there before may be another's. */
  #relink(): void {
    this.#draft = null;
    if (!this.store.online) return;
    this.store.receive({ type: "mapping_list", mappings: {}, missing: {} });
    this.store.receive({ type: "setup_list", names: [], called: "" });
  }

  #tell(): void {
    this.store.tell("mapping_list");
  }
}
