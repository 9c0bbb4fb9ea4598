/** Set-ups: all mappings and bindings under a name; what an operator does with them, with undo. */

import type { SetupChanged } from "../../link/messages";
import type { ConsoleStore } from "../store/console_store";
import type { Asked } from "../store/requests";
import type { Change } from "../store/undo_history";

type SetupRequest = Extract<Asked, { type: "keep_setup" | "call_setup" | "drop_setup" }>;

export class SetupCommands {
  constructor(private readonly store: ConsoleStore) {}

  get names(): readonly string[] {
    return this.store.newest("setup_list")?.names ?? [];
  }

  /** The one that plays, "" where mappings or bindings have changed since it was called. */
  get called(): string {
    return this.store.newest("setup_list")?.called ?? "";
  }

  keep(name: string): void {
    this.#ask({ type: "keep_setup", name }, `Kept as the set-up ${name}: all macros and bindings.`, `set-up ${name}`);
  }

  call(name: string): void {
    this.#ask({ type: "call_setup", name }, `Plays by the set-up ${name}.`, `call set-up ${name}`);
  }

  drop(name: string): void {
    this.#ask(
      { type: "drop_setup", name },
      `The set-up ${name} is deleted; what plays goes on.`,
      `delete set-up ${name}`,
    );
  }

  #ask(asked: SetupRequest, done: string, what: string): void {
    const answered = ({ id, missing }: SetupChanged): void => {
      const undo: Change = { type: "restore_setup", change: id };
      const left = missing.length === 0 ? "" : ` Not here, so left out: ${missing.join(", ")}.`;
      this.store.offerUndo(`${done}${left}`, { what, undo: [undo], redo: [asked] });
    };
    this.store.ask(asked, { setup_changed: answered });
  }
}
