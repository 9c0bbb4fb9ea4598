/** Edits that were sent and that the list does not show yet: another edit of the same cue begins from them. */

import type { Cue } from "../../link/messages";
import type { Asked } from "../store/requests";

/** Milliseconds for which an edit is believed that neither comes nor is rejected, as where somebody else has changed it. */
const BELIEVED_MS = 5000;

interface LocalEdit {
  readonly identity: string;
  /** What the cue has of it. */
  readonly read: (cue: Cue) => unknown;
  readonly apply: (cue: Cue) => Cue;
  readonly wanted: unknown;
  readonly until: number;
}

export class LocalEdits {
  /** By what they write: another edit of the same takes the place of the one before. */
  readonly #edits = new Map<string, LocalEdit>();

  /** Believes what was sent; gives what forgets it, where it is rejected. */
  add(asked: Asked, now: number): () => void {
    const found = editOf(asked, now + BELIEVED_MS);
    if (found === null) return () => undefined;
    const [key, edit] = found;
    this.#edits.set(key, edit);
    return () => {
      if (this.#edits.get(key) === edit) this.#edits.delete(key);
    };
  }

  /** A cue as it is once all that was sent of it has come. */
  over(cue: Cue, now: number): Cue {
    const own = [...this.#edits.values()].filter(({ identity, until }) => identity === cue.identity && now < until);
    return own.reduce((edited, edit) => edit.apply(edited), cue);
  }

  /** Forgets what a list shows, and what it may not come to show any more. */
  settle(list: readonly Cue[], now: number): void {
    for (const [key, edit] of this.#edits) {
      const cue = list.find(({ identity }) => identity === edit.identity);
      if (cue === undefined || now >= edit.until || same(edit.read(cue), edit.wanted)) this.#edits.delete(key);
    }
  }
}

/** What an edit makes of a cue, under a name of its own; null of an edit that no other one begins from. */
function editOf(asked: Asked, until: number): [string, LocalEdit] | null {
  if (asked.type === "put_move") {
    const { cue: identity, part, goal, seconds = 1, easing = "smooth", delay = 0 } = asked;
    const wanted = { goal, seconds, easing, delay };
    const apply = (cue: Cue): Cue => ({ ...cue, moves: { ...cue.moves, [part]: wanted } });
    return [`${identity} ${part}`, { identity, read: ({ moves }) => moves[part], apply, wanted, until }];
  }
  if (asked.type !== "put_cue" || !asked.cue || !asked.actions) return null;
  const { cue: identity, actions: wanted } = asked;
  const apply = (cue: Cue): Cue => ({ ...cue, actions: wanted });
  return [`${identity} actions`, { identity, read: ({ actions }) => actions, apply, wanted, until }];
}

/** Whether two values say the same, in whatever order their names stand. */
const same = (one: unknown, other: unknown): boolean => sorted(one) === sorted(other);

const sorted = (value: unknown): string =>
  JSON.stringify(value, (_, each) =>
    each !== null && typeof each === "object" && !Array.isArray(each)
      ? Object.fromEntries(Object.entries(each).toSorted(([one], [other]) => (one < other ? -1 : 1)))
      : each,
  );
