/** What a page does with the pads of the show; each change can be taken back. Nothing here touches the page. */

import { MOST_LOOKS } from "../../link/constants";
import type { PadLook, PadState } from "../../link/messages";
import { randomId } from "../../ui/browser_storage";
import type { ConsoleStore } from "../store/console_store";
import type { Asked } from "../store/requests";
import { freeLabel, freeName, kindOf, type PadContent, restOf, shownMix, withLook } from "./pad_layout";

/** Milliseconds between two messages of a look that is dragged: the show follows their steps in 60. */
export const DRAG_PACE = 50;

/** The pads of the show, those that this console has chosen first. */
export const padsOf = (store: ConsoleStore): readonly PadState[] =>
  inOrder(store.newest("pad_list")?.pads ?? [], store.arrangement.pads);

/** Pads, those first whose names are chosen. */
export function inOrder(pads: readonly PadState[], chosen: readonly string[]): readonly PadState[] {
  const first = chosen.flatMap((name) => pads.filter((pad) => pad.name === name));
  return [...first, ...pads.filter((pad) => !first.includes(pad))];
}

/** Where the point of a pad stands on the character whose values are shown. */
export const isPlaying = (store: ConsoleStore, name: string): boolean => store.air?.pads[name]?.plays ?? false;

export class PadCommands {
  constructor(private readonly store: ConsoleStore) {}

  /** Keeps a pad as it is now; whether it could be sent. `done`: what is said; `what`: what undo names. */
  set(pad: PadContent, what: string, done: string): boolean {
    const key = randomId();
    return this.#act(setting(pad, key), key, what, done);
  }

  /** Begins a change that is sent while it goes on, and taken back as one. */
  drag(pad: PadContent, what: string): PadDrag {
    return new PadDrag(this.store, pad, what);
  }

  /** The name that the pad has then; null where it was not sent. `refused`: told where the show keeps the old one. */
  rename(pad: PadState, to: string, refused = (): void => undefined): string | null {
    if (to === "" || to === pad.name) return null;
    const key = randomId();
    const sent = this.#act(
      { type: "rename_pad", name: pad.name, to, key },
      key,
      `rename ${pad.name}`,
      `${pad.name} is called ${to} now.`,
      () => {
        this.#chooseInstead(to, pad.name);
        refused();
      },
    );
    if (sent) this.#chooseInstead(pad.name, to);
    return sent ? to : null;
  }

  /** A pad that this console has chosen is chosen under another name. */
  #chooseInstead(before: string, name: string): void {
    const { pads } = this.store.arrangement;
    if (pads.includes(before)) this.store.arrange({ pads: pads.map((each) => (each === before ? name : each)) });
  }

  /** The name of the copy; null where it was not sent. `refused`: told where there is none. */
  copy(pad: PadState, refused = (): void => undefined): string | null {
    const key = randomId();
    const to = freeName(pad.name, this.store.newest("pad_list")?.pads ?? []);
    return this.#act(
      { type: "copy_pad", name: pad.name, to, key },
      key,
      `copy ${pad.name}`,
      `${to} is a copy of ${pad.name}.`,
      refused,
    )
      ? to
      : null;
  }

  delete(pad: PadState): boolean {
    const key = randomId();
    return this.#act(
      { type: "drop_pad", name: pad.name, key },
      key,
      `delete the pad ${pad.name}`,
      `Deleted the pad ${pad.name}; what it shows stays on air.`,
    );
  }

  addOfCast(): boolean {
    const key = randomId();
    return this.#act({ type: "add_cast_pads", key }, key, "pads of the cast", "The pads of the cast are here.");
  }

  /** The pad with one more look; null where it has no room, which is said. */
  added(pad: PadContent, look: PadLook): PadContent | null {
    const looks = withLook(pad.looks, look);
    if (looks === null)
      this.store.say(
        `No room for ${look.label}: ${pad.name} has ${pad.looks.length} looks, and ${MOST_LOOKS} have room.`,
      );
    return looks === null ? null : { ...pad, looks };
  }

  /** What shows, as a look where the point of the pad is; null where nothing does. */
  shown(pad: PadContent, place: readonly number[]): PadLook | null {
    const { air } = this.store;
    const mix = air === null ? null : shownMix(pad.part, air);
    if (mix === null) return null;
    const [heaviest = restOf(pad.part)] = Object.keys(mix);
    const label = this.store.label(kindOf(pad.part), heaviest);
    return {
      label: freeLabel(Object.keys(mix).length > 1 ? `${label} mix` : label, pad.looks),
      mix,
      place: [...place],
    };
  }

  #act(asked: Asked, key: string, what: string, done: string, failed = (): void => undefined): boolean {
    const back = { type: "restore_pad", key } as const;
    const step = { what, undo: [back], redo: [back] };
    const refused = ({ reason }: { reason: string }): void => {
      this.store.history.skip(step);
      this.store.say(reason);
      failed();
    };
    if (!this.store.ask(asked, { refused })) return false;
    this.store.offerUndo(done, step);
    return true;
  }
}

const setting = ({ name, part, dimensions, looks }: PadContent, key: string): Asked => ({
  type: "set_pad",
  name,
  part,
  dimensions,
  looks: [...looks],
  key,
});

/** A pad that changes under a hand: what plays it follows, twenty times a second at most. */
export class PadDrag {
  readonly #key = randomId();
  #sent = Number.NEGATIVE_INFINITY;
  #looks: readonly PadLook[];
  #pending = false;
  #refused = false;

  constructor(
    private readonly store: ConsoleStore,
    private readonly pad: PadContent,
    private readonly what: string,
  ) {
    this.#looks = pad.looks;
  }

  /** The looks as they are under the hand. */
  get looks(): readonly PadLook[] {
    return this.#looks;
  }

  /** Other looks at `now`, milliseconds. */
  put(looks: readonly PadLook[], now: number): void {
    if (looks === this.#looks) return;
    this.#looks = looks;
    this.#pending = true;
    if (now - this.#sent >= DRAG_PACE) this.#send(now);
  }

  /** The hand lets go; whether anything has changed. */
  end(now: number): boolean {
    if (this.#pending) this.#send(now);
    if (this.#sent === Number.NEGATIVE_INFINITY || this.#refused) return false;
    const back = { type: "restore_pad", key: this.#key } as const;
    this.store.offerUndo(`${this.what}.`, { what: this.what, undo: [back], redo: [back] });
    return true;
  }

  #send(now: number): void {
    this.#pending = false;
    this.#sent = now;
    const refused = ({ reason }: { reason: string }): void => {
      this.#refused = true;
      this.store.say(reason);
    };
    if (!this.store.ask(setting({ ...this.pad, looks: this.#looks }, this.#key), { refused })) this.#refused = true;
  }
}
