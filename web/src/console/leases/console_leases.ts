/** The leases at this console: what others hold bars its hands and says so, and what can be done about it. */

import { ALL } from "../../link/constants";
import type { LeaseClaim, Leases, SeatState } from "../../link/messages";
import type { ConsoleStore } from "../store/console_store";
import type { Offer, Question } from "../store/page_store";
import {
  explain,
  heldByOthers,
  heldHere,
  holdingsOf,
  keysOf,
  type LeasePart,
  listed,
  NOBODY,
  partOf,
  wordsOf,
} from "./held_parts";
import { askedHere, waited, wantedHere } from "./lease_wishes";

declare module "../controls/console_element" {
  interface ConsoleContext {
    readonly leases: ConsoleLeases;
  }
}

/** Milliseconds within which claims of one seat are one: its console sends a message for each part. */
const ONE_CLAIM = 2000;

export class ConsoleLeases {
  /** Who holds what, as the show told last. */
  report: Leases = NOBODY;
  /** Why this page's person may not switch leases nor name the stage manager; null where they may. */
  barred: string | null = null;
  /** Asks anew for what was rejected because others hold it; null where a hand moved it. */
  #again: (() => void) | null = null;
  /** What was touched in vain last, until it is taken over or anything else is told. */
  #wanted: readonly string[] = [];
  /** The last claim that was heard, with those before it that came together with it, and when. */
  #claim: (LeaseClaim & { readonly at: number }) | null = null;

  /** `now`: milliseconds. */
  constructor(
    private readonly store: ConsoleStore,
    private readonly now: () => number = () => performance.now(),
  ) {
    store.mayPlay = (control) => this.#mayPlay(control);
    store.sayRefused = ({ reason, held }, again) => this.#sayRefused(reason, held, again);
    store.hear("lease_claim", (claim) => this.#hearClaim(claim));
    store.hear("leases", (leases) => this.#set(leases));
    store.listen("link", () => {
      if (!store.online) store.receive(NOBODY);
    });
  }

  #set(leases: Leases): void {
    const before = this.report;
    this.report = leases;
    if (before.on !== leases.on && this.store.online) this.store.say(...switched(leases));
  }

  /** This console's own seat; null before the show has told. */
  get seat(): SeatState | null {
    return this.report.seats.find(({ number }) => number === this.report.you) ?? null;
  }

  /** The stage manager, where one is there. */
  get manager(): SeatState | null {
    return this.report.seats.find(({ manager }) => manager) ?? null;
  }

  get isManager(): boolean {
    return this.report.on && this.seat?.manager === true;
  }

  /** What is to be answered: what another wants of this seat, else what this seat wants of others; null for nothing. */
  get question(): Question | null {
    return this.#asked() ?? this.#wants();
  }

  #asked(): Question | null {
    const [first, ...others] = askedHere(this.report);
    if (first === undefined) return null;
    const { by, parts, seconds } = first;
    const more = others.length === 0 ? "" : ` (${listed(others.map((wish) => wish.by.name))} too)`;
    const text = `${by.name} has wanted ${this.#list(parts)} for ${waited(seconds)}${more}.`;
    return { text, offers: this.#answers(parts), dismiss: () => this.keep(parts) };
  }

  #wants(): Question | null {
    const wish = wantedHere(this.report);
    if (wish === null) return null;
    const { parts, seconds } = wish;
    const text = `${explain(heldByOthers(this.report, parts), (name) => this.#label(name))}; you have wanted it for ${waited(seconds)}.`;
    const dismiss = (): void => this.withdraw(parts);
    const over = { label: "Take over", act: () => this.takeOver(parts) };
    return { text, offers: [over, { label: "Leave it", act: dismiss }], dismiss };
  }

  /** What others hold of a part of those that this console plays. */
  others(part: LeasePart): ReadonlyMap<string, SeatState> {
    return heldByOthers(this.report, keysOf(this.store.played.names, part));
  }

  /** What this seat holds of a part of those that this console plays. */
  own(part: LeasePart): readonly string[] {
    return heldHere(this.report, keysOf(this.store.played.names, part));
  }

  /** All that this seat holds. */
  get mine(): readonly string[] {
    return heldHere(this.report, Object.keys(this.report.held));
  }

  words(key: string): string {
    return wordsOf(key, (character) => this.#label(character));
  }

  #label(character: string): string {
    return this.store.state?.characters[character]?.label ?? character;
  }

  /** Whether a hand of this console may move a control; else the operator reads who holds it. */
  #mayPlay(control: string): boolean {
    const part = partOf(control, this.store.newest("pad_list")?.pads);
    const held = part === null ? new Map<string, SeatState>() : this.others(part);
    if (held.size > 0) {
      this.#again = null;
      this.#ask([...held.keys()]);
      this.offer(held);
    }
    return held.size === 0;
  }

  /** The show rejected a message; `held`: because others hold these parts, which can be taken over. */
  #sayRefused(reason: string, held: readonly string[], again: (() => void) | null): void {
    const holders = heldByOthers(this.report, held);
    this.#again = again;
    if (holders.size > 0) this.offer(holders);
    else this.store.say(reason);
  }

  /** Lets the holders know, once, that a hand of this console wants their parts: the show has seen no message of it. */
  #ask(keys: readonly string[]): void {
    const wantedParts = wantedHere(this.report)?.parts ?? [];
    const fresh = keys.filter((key) => !wantedParts.includes(key) && !this.#wanted.includes(key));
    for (const key of fresh) this.store.ask({ type: "lease", ...split(key) });
  }

  /** Takes back that this seat wants parts. */
  withdraw(keys: readonly string[]): void {
    this.#wanted = [];
    for (const key of keys) this.store.ask({ type: "release_lease", ...split(key) });
  }

  /** Answers those who want parts of this seat that it keeps them. */
  keep(keys: readonly string[]): void {
    if (this.#lease(keys, false)) this.store.say(null);
  }

  /** Says who holds parts, and offers to take them over; while it stands there it is not said again. */
  offer(held: ReadonlyMap<string, SeatState>): void {
    const text = `${explain(held, (name) => this.#label(name))}.`;
    this.#wanted = [...held.keys()];
    if (this.store.notice === text) return;
    this.store.say(text, "attention", [{ label: "Take over", act: () => this.takeOver([...held.keys()]) }]);
  }

  /** Takes over what was touched in vain last. */
  takeOverWanted(): void {
    if (this.#wanted.length > 0) this.takeOver(this.#wanted);
    else this.store.say("Nothing to take over: nobody else holds what you touched last.");
  }

  takeOver(keys: readonly string[]): void {
    const again = this.#wanted.length > 0 && this.#wanted.every((key) => keys.includes(key)) ? this.#again : null;
    [this.#wanted, this.#again] = [[], null];
    const from = new Set([...heldByOthers(this.report, keys).values()].map(({ name }) => name));
    if (!this.#lease(keys, true)) return;
    again?.();
    const notice = from.size === 0 ? "" : ` ${listed([...from])} ${from.size === 1 ? "is" : "are"} told.`;
    this.store.say(`Taken over: ${this.#list(keys)}.${notice}`, "done", [this.#releaseOffer(keys)]);
  }

  /** Holds what is free. */
  hold(keys: readonly string[]): void {
    this.#lease(keys, false);
  }

  release(keys: readonly string[]): void {
    if (keys.length === 0 || !keys.every((key) => this.store.ask({ type: "release_lease", ...split(key) }))) return;
    const again = { label: "Hold again", act: () => this.hold(keys) };
    this.store.say(`Released: ${this.#list(keys)}.`, "done", [again]);
  }

  /** Everything of everybody: the stage manager's. */
  takeAll(): void {
    this.store.ask({ type: "lease", character: ALL, part: ALL, take_over: true });
  }

  releaseAll(): void {
    if (this.store.ask({ type: "release_lease", character: ALL, part: ALL }))
      this.store.say("Released: all that you held.", "done");
  }

  /** Switches leases on, which makes this seat the stage manager where there is none, or off. */
  switch(on: boolean): void {
    this.store.ask({ type: "set_leases", on });
  }

  appoint(seat: number): void {
    this.store.ask({ type: "appoint_manager", seat });
  }

  #lease(keys: readonly string[], takes: boolean): boolean {
    return keys.every((key) => this.store.ask({ type: "lease", ...split(key), take_over: takes }));
  }

  #hearClaim(claim: LeaseClaim): void {
    const { parts, by, taken, kept } = this.#joined(claim);
    const what = this.#list(parts);
    const back = { label: "Take back", act: () => this.takeOver(parts) };
    if (kept) {
      this.#wanted = [];
      const over = { label: "Take over", act: () => this.takeOver(parts) };
      this.store.say(`${by.name} keeps ${what}.`, "attention", [over]);
    } else if (taken) this.store.say(`${by.name} has taken over ${what}.`, "attention", [back]);
    else this.store.say(`${by.name} wants ${what}, which you hold.`, "attention", this.#answers(parts));
  }

  /** A claim with all parts of those that came together with it: a notice covers the one before it. */
  #joined(claim: LeaseClaim): LeaseClaim {
    const before = this.#claim;
    const { by, taken, kept } = claim;
    const same = before?.by.number === by.number && before.taken === taken && before.kept === kept;
    const together = before !== null && same && this.now() - before.at < ONE_CLAIM;
    const parts = [...new Set([...(together ? before.parts : []), ...claim.parts])];
    this.#claim = { ...claim, parts, at: this.now() };
    return this.#claim;
  }

  #answers(keys: readonly string[]): Offer[] {
    const own = holdingsOf(this.report, keys);
    return own.length === 0 ? [] : [this.#releaseOffer(own), { label: "Keep it", act: () => this.keep(keys) }];
  }

  #releaseOffer(keys: readonly string[]) {
    return { label: "Release", act: () => this.release(keys) };
  }

  #list(keys: readonly string[]): string {
    return listed(keys.map((key) => this.words(key)));
  }
}

const split = (key: string): { character: string; part: LeasePart } => {
  const [character, part] = key.split("/") as [string, LeasePart];
  return { character, part };
};

/** What is said when leases are switched. */
function switched({ on, seats }: Leases): [string, "done"] {
  const manager = seats.find((seat) => seat.manager)?.name;
  const who = manager === undefined ? "" : ` ${manager} is the stage manager.`;
  return [on ? `Leases are on: what you touch first is yours.${who}` : "Leases are off: the last touch wins.", "done"];
}
