/**
 * What the page knows and what it may do: the server's newest state, the hand's own values while they count, and the
 * messages of the next frame. Nothing here touches the page or a clock.
 */

import type { CallState, Crew, FromClient, Hands, ItemChanged, Kept, State } from "../../link/messages";
import { type Axis, callOf, endFrom, followTimed } from "./axis";
import { type ConsoleLayout, FIRST } from "./console_layout";
import { type Answers, type Asked, FileRequests } from "./file_requests";
import { GAZE, type GazePart, HEAD, type HeadPart, type Knob, Knobs } from "./knob";
import { Outbox } from "./outbox";
import { PageStore } from "./page_store";
import type { Seconds, Timing } from "./timing";
import type { Change, Step, TakeStep, Way } from "./undo_history";

const NOT_SENT = "Not sent: the link to the show is lost.";
const NOTHING_TO_RELEASE = "Nothing to release: a call by hand has no seconds to run on in.";
export class ConsoleStore extends PageStore {
  state: State | null = null;
  crew: Crew | null = null;
  /** Milliseconds there and back, or null before the first pong. */
  latency: number | null = null;
  online = false;
  /** What the other consoles call this one. */
  name = "";
  /** What hands at other consoles move, and the names of those consoles. */
  hands: Hands["hands"] = {};
  /** Rises with each panic: a drag begun before it is over. */
  era = 0;
  layout: ConsoleLayout = FIRST;

  #calls = 0;
  /** A panic of this console, which puts the bars to their rest, has not been heard yet. */
  #panicking = false;
  readonly #requests = new FileRequests();
  readonly #timed: Record<Axis, boolean | null> = { face: null, expression: null };
  readonly #knobs: Knobs;
  readonly #outbox: Outbox;

  /** `send` takes a message to the server, `now` is the page's clock in milliseconds, `id` names this console. */
  constructor(
    send: (message: FromClient) => void,
    private readonly now: () => number,
    private readonly id: string,
  ) {
    super();
    this.#outbox = new Outbox(send);
    this.#knobs = new Knobs({ state: () => this.state, now, mayAct: () => this.#mayAct() }, this.#outbox);
  }

  /** A newer state than any before. */
  receiveState(state: State): void {
    const last = this.state;
    this.state = state;
    for (const axis of ["face", "expression"] as const) {
      this.#timed[axis] = followTimed(this.#timed[axis], axis, last, state);
    }
    const turned = (axis: Axis): boolean => (last ? callOf(last, axis)?.target : null) !== callOf(state, axis)?.target;
    if (turned("face") || turned("expression")) this.tell("call");
    for (const control in this.hands) this.#knobs.yieldTo(control);
    if (last !== null && last.panics !== state.panics) this.#handsOff();
    const { home_face: face, home_seconds: seconds, home_next: next } = state;
    if (last?.home_face !== face || last.home_seconds !== seconds || last.home_next !== next) this.tell("panic");
  }

  /** Somebody pressed panic: what hands hold here has no weight any more. */
  #handsOff(): void {
    this.#panicking = false;
    this.#knobs.clear();
    this.#outbox.clear();
    this.era += 1;
    this.tell("panic");
  }

  receiveCrew(crew: Crew): void {
    this.crew = crew;
    this.tell("crew");
  }

  /** The way there and back took `milliseconds`. */
  receiveTrip(milliseconds: number): void {
    this.latency = milliseconds;
    this.tell("crew");
  }

  /** The link came up or was lost. While it is lost the controls rest at the last state heard, and nothing is queued. */
  setOnline(online: boolean): void {
    if (online === this.online) return;
    this.online = online;
    this.hands = {};
    this.#requests.clear();
    this.#knobs.clear();
    this.#outbox.clear();
    if (!online) this.latency = null;
    this.#panicking = false;
    this.tell("link");
  }

  /** Asks for a change of the show file; whether it was sent. */
  ask(asked: Asked, answers: Answers = {}): boolean {
    if (!this.#mayAct()) return false;
    const id = this.#nextId();
    this.#requests.add(id, answers);
    return this.#push({ ...asked, id } as FromClient);
  }

  /** What was on air, or copied, is in the cast. */
  receiveKept({ id, name, label }: Kept): void {
    this.#requests.take(id)?.kept?.(name, label);
  }

  receiveChanged({ id, label, before }: ItemChanged): void {
    this.#requests.take(id)?.changed?.(label, before);
  }

  /** A message was rejected; `id`: which, where it was about the show file. */
  receiveRefused(reason: string, id = ""): void {
    const told = this.told;
    this.#requests.take(id)?.refused?.(reason);
    if (this.told === told) this.say(reason);
  }

  override get busy(): string | null {
    return this.#requests.busy;
  }

  /** What the other consoles call this one. */
  receiveName(name: string): void {
    this.name = name;
    this.tell("layouts");
  }

  receiveHands(hands: Hands["hands"]): void {
    this.hands = hands;
  }

  /** The other console whose hand is on a knob too; null for none. */
  otherOn({ control }: Pick<Knob, "control">): string | null {
    return this.hands[control] ?? null;
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
    if (change.timing !== undefined) this.tell("timing");
    this.tell("layout");
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
    return this.otherOn(this.bar(axis)) !== null ? null : endFrom(this.bar(axis).value(this.now()));
  }

  /** Calls a light in the time of a face, also while faces are called by hand: a light has no T-bar. */
  callLight(name: string): void {
    if (!this.#mayAct()) return;
    const { seconds, easing } = this.timing.face;
    this.#outbox.push({ type: "call_light", id: this.#nextId(), name, seconds, easing });
  }

  /** Whether the call is timed and a T-bar has it, so that it runs on once the hand is off. */
  releasable(axis: Axis): boolean {
    return this.callOf(axis)?.by_hand === true && this.#timed[axis] !== false;
  }

  release(axis: Axis): void {
    if (this.#timed[axis] === false && this.online) this.say(NOTHING_TO_RELEASE);
    else this.#push({ type: axis === "face" ? "release_face" : "release_expression" });
  }

  panic(): void {
    this.#handsOff();
    if (!this.#mayAct()) return;
    this.#panicking = true;
    this.#outbox.push({ type: "panic" });
  }

  /** Chooses the face that a second panic brings, and the seconds that it takes. */
  setHome(face: string, seconds: number): void {
    const before = this.state;
    const to = (name: string, time: number) => ({ type: "set_home", face: name, seconds: time }) as const;
    const redo = to(face, seconds);
    if (!this.#push(redo) || before === null) return;
    const [label, undo] = [this.label("face", face), to(before.home_face, before.home_seconds)];
    this.offerUndo(`The home face is ${label}.`, { what: `home face ${label}`, undo: [undo], redo: [redo] });
  }

  #push(message: FromClient): boolean {
    if (!this.#mayAct()) return false;
    this.#outbox.push(message);
    return true;
  }

  clearChannels(names: Iterable<string>): void {
    if (!this.#mayAct()) return;
    const read = (name: string): number => this.channel(name, false).value(this.now());
    const before = [...names].map((name) => [name, read(name)] as const).filter(([, weight]) => weight !== 0);
    if (before.length === 0) return;
    const to = (at: (weight: number) => number): Change[] =>
      before.map(([name, weight]) => ({ type: "set_channel", name, value: at(weight) }));
    const what = `${before.length} ${before.length === 1 ? "fader" : "faders"}`;
    const [undo, redo, panics] = [to((weight) => weight), to(() => 0), this.state?.panics ?? 0];
    const step: Step = { what: `clear ${what}`, undo, redo, panics };
    this.takeStep(step, "redo", () => undefined);
    this.offerUndo(`Cleared ${what}.`, step);
  }

  takeStep(step: Step, way: Way, refused: Parameters<TakeStep>[2]): boolean {
    if (!this.#mayAct()) return false;
    const over = step.panics !== undefined && (this.#panicking || step.panics !== this.state?.panics);
    if (way === "undo" && over) return this.tooLate(step);
    return step[way].map((change) => this.#change(change, refused)).some(Boolean);
  }

  #change(change: Change, refused: (reason: string) => void): boolean {
    if (change.type === "set_home") return this.#push(change);
    if (change.type === "set_channel") {
      this.channel(change.name, false).nudge(change.value);
      return true;
    }
    if (change.type === "rename_layout" && change.name === this.chosenLayout) this.chosenLayout = change.to;
    return this.ask(change, { refused });
  }

  centre(): void {
    for (const part of HEAD) this.head(part).nudge(0);
    for (const part of GAZE) this.gaze(part).nudge(0);
  }

  /** Sends what the hands changed since the last frame. */
  flush = (): void => this.#outbox.flush();

  /** The weight of a channel; with `linked` its mirror moves along. */
  channel(name: string, linked = this.linked): Knob {
    return this.#knobs.channel(name, linked ? this.mirrorOf(name) : null);
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
