/**
 * What the page knows and what it may do: the server's newest state, the hand's own values while they count, and the
 * messages of the next frame. Nothing here touches the page or a clock.
 */

import { editorAddress } from "../../link/editor_address";
import type {
  CallState,
  Crew,
  ExpressionDocument,
  FaceDocument,
  FromClient,
  Kept,
  LightDocument,
  Manifest,
  State,
} from "../../link/messages";
import { type Axis, callOf, endFrom, type Followed, follow, UNKNOWN } from "./axis";
import { mirrorOf, type Strip, stripsOf } from "./channels";
import { type ConsoleLayout, FIRST } from "./console_layout";
import { GAZE, type GazePart, HEAD, type HeadPart, type Knob, Knobs } from "./knob";
import { Outbox } from "./outbox";
import type { Seconds, Timing } from "./timing";

/** What has changed, for elements that render (rarely); what moves is read every frame instead. */
export type Topic = "cast" | "crew" | "link" | "timing" | "layout" | "call" | "notice" | "panic";

const NOT_SENT = "Not sent: the link to the show is lost.";
const NOTHING_TO_RELEASE = "Nothing to release: a call by hand has no seconds to run on in.";
/** Milliseconds within which a second press of *Keep* is the same. */
const TWICE = 800;
/** Milliseconds after which a T-bar that another console moved is taken to be let go. */
const LET_GO = 1000;

export class ConsoleStore {
  manifest: Manifest | null = null;
  state: State | null = null;
  crew: Crew | null = null;
  /** Milliseconds there and back, or null before the first pong. */
  latency: number | null = null;
  online = false;
  /** The last thing the operator must read, how it is meant, and where to go for it. */
  notice: string | null = null;
  tone: "attention" | "done" = "attention";
  offer: { readonly label: string; readonly address: string } | null = null;
  /** Rises with each panic: a drag begun before it is over. */
  era = 0;
  layout: ConsoleLayout = FIRST;

  #strips: Strip[] = [];
  #labels: Record<Axis, ReadonlyMap<string, string>> = { face: new Map(), expression: new Map() };
  #calls = 0;
  /** A panic of this console, which puts the bars to their rest, has not been heard yet. */
  #panicking = false;
  readonly #kept: Record<Axis, number> = { face: Number.NEGATIVE_INFINITY, expression: Number.NEGATIVE_INFINITY };
  readonly #followed: Record<Axis, Followed> = { face: UNKNOWN, expression: UNKNOWN };
  readonly #knobs: Knobs;
  readonly #outbox: Outbox;
  readonly #listeners = new Map<Topic, Set<() => void>>();

  /** `send` takes a message to the server, `now` is the page's clock in milliseconds, `id` names this console. */
  constructor(
    send: (message: FromClient) => void,
    private readonly now: () => number,
    private readonly id: string,
  ) {
    this.#outbox = new Outbox(send);
    this.#knobs = new Knobs({ state: () => this.state, now, mayAct: () => this.#mayAct() }, this.#outbox);
  }

  listen(topic: Topic, heard: () => void): () => void {
    const listeners = this.#listeners.get(topic) ?? new Set();
    this.#listeners.set(topic, listeners.add(heard));
    return () => listeners.delete(heard);
  }

  #tell(topic: Topic): void {
    for (const heard of this.#listeners.get(topic) ?? []) heard();
  }

  /** What people read of a name; a name that the cast does not know stands for itself. */
  label(axis: Axis, name: string): string {
    return this.#labels[axis].get(name) ?? name;
  }

  get faces(): readonly FaceDocument[] {
    return this.manifest?.faces ?? [];
  }

  get expressions(): readonly ExpressionDocument[] {
    return this.manifest?.expressions ?? [];
  }

  get lights(): readonly LightDocument[] {
    return this.manifest?.lights ?? [];
  }

  setManifest(manifest: Manifest): void {
    this.manifest = manifest;
    this.#strips = stripsOf(manifest.expressions);
    const labels = (documents: readonly { name: string; label: string }[]) =>
      new Map(documents.map(({ name, label }) => [name, label]));
    this.#labels = { face: labels(manifest.faces), expression: labels(manifest.expressions) };
    this.#tell("cast");
  }

  /** A newer state than any before. */
  receiveState(state: State): void {
    const last = this.state;
    this.state = state;
    for (const axis of ["face", "expression"] as const) {
      const own = this.bar(axis).counts(this.now());
      this.#followed[axis] = follow(this.#followed[axis], axis, [last, state], own, this.now());
    }
    const turned = (axis: Axis): boolean => (last ? callOf(last, axis)?.target : null) !== callOf(state, axis)?.target;
    if (turned("face") || turned("expression")) this.#tell("call");
    if (last !== null && last.panics !== state.panics) this.#handsOff();
    const { home_face: face, home_seconds: seconds, home_next: next } = state;
    if (last?.home_face !== face || last.home_seconds !== seconds || last.home_next !== next) this.#tell("panic");
  }

  /** Somebody pressed panic: what hands hold here has no weight any more. */
  #handsOff(): void {
    this.#panicking = false;
    this.#knobs.clear();
    this.#outbox.clear();
    this.era += 1;
    this.#tell("panic");
  }

  receiveCrew(crew: Crew): void {
    this.crew = crew;
    this.#tell("crew");
  }

  /** The way there and back took `milliseconds`. */
  receiveTrip(milliseconds: number): void {
    this.latency = milliseconds;
    this.#tell("crew");
  }

  /** The link came up or was lost. While it is lost the controls rest at the last state heard, and nothing is queued. */
  setOnline(online: boolean): void {
    if (online === this.online) return;
    this.online = online;
    this.#knobs.clear();
    this.#outbox.clear();
    if (!online) this.latency = null;
    this.#panicking = false;
    this.#tell("link");
  }

  say(notice: string | null, tone: ConsoleStore["tone"] = "attention", offer: ConsoleStore["offer"] = null): void {
    [this.notice, this.tone, this.offer] = [notice, tone, offer];
    this.#tell("notice");
  }

  /** What was on air is in the cast. */
  receiveKept({ id, name, label }: Kept): void {
    const axis = id.endsWith("-face") ? "face" : "expression";
    this.say(`Kept as ${label} under Own.`, "done", { label: "Edit it", address: editorAddress(axis, name) });
  }

  /** True when the link is there; else tells the operator that nothing was sent. */
  #mayAct(): boolean {
    if (!this.online) this.say(NOT_SENT);
    return this.online;
  }

  get timing(): ConsoleLayout["timing"] {
    return this.layout.timing;
  }

  /** Left and right of a pair move together. */
  get linked(): boolean {
    return this.layout.linked;
  }

  /** Chosen seconds end calls by hand. */
  setTiming(axis: Axis, change: Partial<Timing>): void {
    const timed = change.seconds === undefined ? {} : { byHand: false };
    this.arrange({ timing: { ...this.timing, [axis]: { ...this.timing[axis], ...timed, ...change } } });
  }

  /** Lays the console out. */
  arrange(change: Partial<ConsoleLayout>): void {
    this.layout = { ...this.layout, ...change };
    if (change.timing !== undefined) this.#tell("timing");
    this.#tell("layout");
  }

  callSeconds(axis: Axis): Seconds {
    const { seconds, byHand } = this.timing[axis];
    return byHand ? null : seconds;
  }

  /** A name for a message that is to be obeyed once. */
  #nextId(): string {
    this.#calls += 1;
    return `${this.id}-${this.#calls}`;
  }

  call(axis: Axis, name: string): void {
    if (!this.#mayAct()) return;
    const [id, seconds, rest] = [this.#nextId(), this.callSeconds(axis), this.#restOf(axis)];
    const running = this.callOf(axis) !== null;
    if (rest !== null && !running) this.bar(axis).nudge(rest);
    const [type, { easing }] = [axis === "face" ? "call_face" : "call_expression", this.timing[axis]] as const;
    this.#outbox.push({ type, id, name, seconds, easing });
    if (rest !== null && running && seconds === null) this.bar(axis).nudge(rest); // before, it would move the old call
  }

  /** The end that a T-bar in the middle goes to at a new call; null where a hand may be on it, here or elsewhere. */
  #restOf(axis: Axis): number | null {
    if (this.state === null || this.#panicking || this.bar(axis).gripped()) return null;
    const elsewhere = this.now() - this.#followed[axis].movedElsewhere < LET_GO;
    return elsewhere ? null : endFrom(this.bar(axis).value(this.now()));
  }

  /** Calls a light in the time of a face, also while faces are called by hand: a light has no T-bar. */
  callLight(name: string): void {
    if (!this.#mayAct()) return;
    const { seconds, easing } = this.timing.face;
    this.#outbox.push({ type: "call_light", id: this.#nextId(), name, seconds, easing });
  }

  /** Keeps what is on air on an axis as a new face or expression of the cast. */
  keep(axis: Axis): void {
    if (this.now() - this.#kept[axis] < TWICE) return;
    this.#kept[axis] = this.now();
    const id = `${this.#nextId()}-${axis}`; // the answer names nothing else of what was asked
    if (this.#mayAct()) this.#outbox.push({ type: axis === "face" ? "keep_face" : "keep_expression", id });
  }

  /** Whether the call is timed and a T-bar has it, so that it runs on once the hand is off. */
  releasable(axis: Axis): boolean {
    return this.callOf(axis)?.by_hand === true && this.#followed[axis].timed !== false;
  }

  release(axis: Axis): void {
    if (!this.#mayAct()) return;
    if (this.#followed[axis].timed === false) {
      this.say(NOTHING_TO_RELEASE);
      return;
    }
    this.#outbox.push({ type: axis === "face" ? "release_face" : "release_expression" });
  }

  panic(): void {
    this.#handsOff();
    if (!this.#mayAct()) return;
    this.#panicking = true;
    this.#outbox.push({ type: "panic" });
  }

  /** Chooses the face that a second panic brings, and the seconds that it takes. */
  setHome(face: string, seconds: number): void {
    if (this.#mayAct()) this.#outbox.push({ type: "set_home", face, seconds });
  }

  clearChannels(names: Iterable<string>): void {
    if (!this.#mayAct()) return;
    const now = this.now();
    for (const name of names) {
      if (this.channel(name).value(now) === 0) continue;
      this.channel(name, false).nudge(0);
    }
  }

  centre(): void {
    for (const part of HEAD) this.head(part).nudge(0);
    for (const part of GAZE) this.gaze(part).nudge(0);
  }

  /** Sends what the hands changed since the last frame. */
  flush = (): void => this.#outbox.flush();

  /** The weight of a channel; with `linked` its mirror moves along. */
  channel(name: string, linked = this.linked): Knob {
    return this.#knobs.channel(name, linked ? mirrorOf(name, this.#strips) : null);
  }

  head(part: HeadPart): Knob {
    return this.#knobs.head(part);
  }

  gaze(part: GazePart): Knob {
    return this.#knobs.gaze(part);
  }

  /** Where a T-bar stands, under the hand of this console or of another. */
  bar(axis: Axis): Knob {
    return this.#knobs.bar(axis);
  }

  callOf(axis: Axis): CallState | null {
    return this.state === null ? null : callOf(this.state, axis);
  }
}
