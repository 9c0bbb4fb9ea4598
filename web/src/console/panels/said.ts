/** What a page says now: its last notice for some seconds, with the ways back of a panic; else what waits for an answer. */

import type { ReactiveControllerHost } from "lit";
import { whileShown } from "../../ui/topic_element";
import type { ConsoleStore } from "../store/console_store";
import type { Offer, PageStore, Question } from "../store/page_store";

/** Milliseconds for which a notice stands. */
const NOTICE = 6000;
/** Milliseconds for which what was done can be taken back by a button; a key does so later too. */
const OFFER = 15_000;

/** What may ask, the first that does so first. */
export interface Asking {
  readonly store: ConsoleStore;
  readonly panicReturn: { readonly question: Question | null };
  readonly leases: { readonly question: Question | null };
  readonly sources: { readonly question: Question | null };
}

export interface Said {
  readonly text: string | null;
  readonly tone: PageStore["tone"];
  readonly offers: readonly Offer[];
  readonly dismiss: () => void;
}

export function saidNow({ store, panicReturn, leases, sources }: Asking): Said {
  const { notice: text, tone, offers } = store;
  const notice = { text, tone, offers, dismiss: () => store.say(null) };
  const question = panicReturn.question ?? leases.question ?? sources.question;
  if (text === null) return { ...notice, tone: "attention", ...question };
  return { ...notice, offers: [...offers, ...(panicReturn.question?.offers ?? [])] };
}

/** Takes notices away once they have been read; `waits`: what waits for somebody who follows it, where it has room. */
export function passNotices(
  host: ReactiveControllerHost,
  store: () => ConsoleStore,
  waits: (offers: readonly Offer[]) => boolean = () => false,
): void {
  whileShown(host, () => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const leave = store().listen("notice", () => {
      clearTimeout(timer);
      const { notice, offers } = store();
      if (notice === null || waits(offers)) return;
      timer = setTimeout(() => store().say(null), offers.length > 0 ? OFFER : NOTICE);
    });
    return () => {
      clearTimeout(timer);
      leave();
    };
  });
}
