/**
 * What the page knows and what it may do: the server's newest state, the hand's own values while they count, and the
 * messages of the next frame. Nothing here touches the page or a clock.
 */

import { ALL } from "../../link/constants";
import type { CallState, CharacterState, FromClient, Hands, Refused, State } from "../../link/messages";
import { callOf, endFrom, followTimed, LOOK_KINDS, type LookKind, timingOf } from "./axis";
import { GAZE, type GazePart, HEAD, type HeadPart, type Knob, Knobs } from "./knob";
import { Outbox } from "./outbox";
import { PageStore } from "./page_store";
import { charactersKey, PlayedCharacters } from "./played_characters";
import { callMessage, type PoseRegion } from "./region_calls";
import { type Answers, type Asked, Requests } from "./requests";
import { type Change, clearStep, movedBy, type Step, type TakeStep, type Way } from "./undo_history";
import { UnheardPanic } from "./unheard_panic";

const BACK = "The link to the show is back.";
const NOT_SENT = "Not sent: the link to the show is lost.";
const NOT_HEARD =
  "Panic is not heard: the link to the show is lost. It is sent if the link is back within five seconds.";
const NEVER_HEARD = "Panic was not heard: the link was lost for too long. Press it again.";
const NOTHING_TO_RELEASE = "Nothing to release: a call by hand has no seconds to run on in.";

/** Messages that are remembered until their answer has come. */
const MOST_CALLED = 64;

export class ConsoleStore extends PageStore {
  state: State | null = null;
  online = false;
  /** Rises with each panic: a drag begun before it is over. */
  era = 0;
  /** The characters that this console plays. */
  readonly played = new PlayedCharacters(() => this.state);

  /** Says that a message was rejected, and why. */
  sayRefused: (message: Refused, again: (() => void) | null) => void = ({ reason }) => this.say(reason);

  /** A panic of this console, which puts the bars to their rest, has not been heard yet. */
  #panicking = false;
  /** The link was lost after it had been there. */
  #lost = false;
  readonly #unheard = new UnheardPanic();
  readonly #requests: Requests;
  /** What was asked for last, by id: what is rejected can be asked for again. */
  readonly #called = new Map<string, FromClient>();
  readonly #timed: Record<LookKind, boolean | null> = { face: null, expression: null, pose: null };
  readonly #knobs: Knobs;
  readonly #outbox: Outbox;

  /** `send` takes a message to the server, `now` is the page's clock in milliseconds, `id` names this console. */
  constructor(
    send: (message: FromClient) => void,
    private readonly now: () => number,
    id: string,
  ) {
    super();
    this.#requests = new Requests(id);
    this.#outbox = new Outbox(send);
    const { played } = this;
    const withMacro = (name: string): readonly string[] => played.withMacro(name);
    const host = { air: () => this.air, targets: () => played.targets, withMacro, now, mayAct: this.#mayAct };
    this.#knobs = new Knobs(host, this.#outbox);
    this.hear("state", (state) => this.#receiveState(state));
    this.hear("refused", (message) => this.#receiveRefused(message));
    for (const tag of ["kept", "item_changed", "bindings_changed", "recording_kept", "setup_changed"] as const)
      this.hear(tag, (answer) => this.#requests.receive(answer));
  }

  /** What hands at other consoles move, and the names of those consoles. */
  get hands(): Hands["hands"] {
    return this.newest("hands")?.hands ?? {};
  }

  /** What the character has on air whose values the controls show. */
  get air(): CharacterState | null {
    return this.played.air;
  }

  /** Plays these characters from now on: what hands hold stays with those that it was for. */
  play(names: readonly string[]): void {
    this.flush();
    this.played.choose(names);
    this.#takeUp();
  }

  /** Other characters are played than before. */
  #takeUp(): void {
    this.#knobs.clear();
    for (const axis of LOOK_KINDS) this.#timed[axis] = null;
    this.#unheard.forget(); // whose panic it was is not played any more
    this.era += 1;
    for (const topic of ["characters", "call", "panic"] as const) this.tell(topic);
  }

  /** A newer state than any before. */
  #receiveState(state: State): void {
    const [last, names, there] = [this.air, this.played.names.join(), charactersKey(this.state)];
    const [panics, black] = [this.played.panics(), this.goesBlack];
    this.state = state;
    if (black !== this.goesBlack) this.tell("black");
    const air = this.air as CharacterState; // a state has a character
    if (last !== null && names !== this.played.names.join()) {
      this.#takeUp();
      return;
    }
    if (there !== charactersKey(state)) this.tell("characters");
    for (const axis of LOOK_KINDS) this.#timed[axis] = followTimed(this.#timed[axis], axis, last, air);
    const turned = (axis: LookKind): boolean =>
      (last ? callOf(last, axis)?.target : null) !== callOf(air, axis)?.target;
    if (LOOK_KINDS.some(turned)) this.tell("call");
    this.#yield();
    if (last !== null && panics !== this.played.panics()) this.#handsOff();
    const { home_face: face, home_seconds: seconds, home_next: next } = air;
    if (last?.home_face !== face || last.home_seconds !== seconds || last.home_next !== next) this.tell("panic");
  }

  /** Hands elsewhere have what they move of the characters played here. */
  #yield(): void {
    for (const control in this.hands) {
      const [character = "", what = ""] = control.split("/");
      if (this.played.names.includes(character)) this.#knobs.yieldTo(what);
    }
  }

  /** Somebody pressed panic: what hands hold here has no weight any more. */
  #handsOff(): void {
    this.#panicking = false;
    this.#unheard.forget();
    this.#knobs.clear();
    this.#outbox.clear();
    this.era += 1;
    this.tell("panic");
  }

  /** The link came up or was lost. While it is lost the controls rest at the last state heard, and nothing is queued. */
  setOnline(online: boolean): void {
    if (online === this.online) return;
    this.online = online;
    this.receive({ type: "hands", hands: {} });
    this.#requests.clear();
    this.#knobs.clear();
    this.#outbox.clear();
    if (!online) this.latency = null;
    this.#panicking = false;
    if (online && this.#lost) this.say(BACK, "done");
    this.#lost = !online;
    if (online) this.#panicAgain();
    this.tell("link");
  }

  /** A panic that the link may have lost is sent again. */
  #panicAgain(): void {
    const late = this.panicIsLate;
    const messages = this.#unheard.again(this.now());
    if (late && messages.length === 0) this.say(NEVER_HEARD);
    this.#sendPanic(messages);
  }

  #sendPanic(messages: readonly FromClient[]): void {
    for (const message of messages) this.push(message);
    this.#panicking = messages.length > 0 && this.online;
  }

  /** Whether a panic that was pressed here should have been heard, and was not. */
  get panicIsLate(): boolean {
    return this.#unheard.late(this.now());
  }

  /** Asks for something that is to be done once; whether it was sent. */
  ask(asked: Asked, answers: Answers = {}): boolean {
    if (!this.#mayAct()) return false;
    const id = this.#requests.nextId();
    this.#requests.add(id, answers);
    return this.push({ ...asked, id } as FromClient);
  }

  /** Whoever asked says why it was rejected, or that nothing is to be said (true). */
  #receiveRefused(message: Refused): void {
    const { logEntries } = this;
    if (this.#requests.receive(message) !== true && this.logEntries === logEntries)
      this.sayRefused(message, this.#again(message.id));
  }

  /** Sends a message anew that the show has rejected; null for one that is not known any more. */
  #again(id: string | undefined): (() => void) | null {
    const asked = id === undefined ? undefined : this.#called.get(id);
    return asked === undefined ? null : () => void this.push({ ...asked, id: this.#requests.nextId() } as FromClient);
  }

  override get busy(): string | null {
    return this.#requests.busy;
  }

  /** The other console whose hand is on a knob too; null for none. */
  otherOn({ control }: Pick<Knob, "control">): string | null {
    const names = this.played.names.map((name) => this.hands[`${name}/${control}`]);
    return names.find((name) => name !== undefined) ?? null;
  }

  /** True when the link is there and a control is not another's; else the operator is told that nothing was sent. */
  readonly #mayAct = (control = ""): boolean => {
    if (!this.online) this.say(NOT_SENT);
    return this.online && this.mayPlay(control);
  };

  /** Calls a face, an expression where the next ones go, or a pose; `of`: the region of a figure that alone does it. */
  call(axis: LookKind, name: string, of: PoseRegion | null = null): void {
    if (!this.#mayAct()) return;
    const region = axis === "expression" ? this.region : of;
    const [seconds, rest] = [this.callSeconds(axis, region), region === null ? this.#restOf(axis) : null];
    const running = this.callOf(axis) !== null;
    if (rest !== null && !running) this.bar(axis).nudge(rest);
    const { easing } = this.timing[timingOf(axis)];
    this.#play((character) =>
      callMessage(axis, { character, id: this.#requests.nextId(), name, seconds, easing }, region),
    );
    if (rest !== null && running && seconds === null) this.bar(axis).nudge(rest); // before, it would move the old call
  }

  /** The end that a T-bar in the middle goes to at a new call; null where a hand may be on it, here or elsewhere. */
  #restOf(axis: LookKind): number | null {
    if (this.state === null || this.#panicking || this.bar(axis).gripped()) return null;
    return this.otherOn(this.bar(axis)) !== null ? null : endFrom(this.bar(axis).value(this.now()));
  }

  /** Calls a light in the time of a face, also while faces are called by hand: a light has no T-bar. */
  callLight(name: string): void {
    const { seconds, easing } = this.timing.face;
    this.ask({ type: "call_light", name, seconds, easing });
  }

  /** Whether all stages are black, or on their way there. */
  get goesBlack(): boolean {
    return this.state?.black_goal === 1;
  }

  /** Fades all stages to black, or up where they go there: in the time of a face's call, unless other seconds are given. */
  callBlack(seconds: number | null = null): void {
    const { seconds: usual, easing } = this.timing.face;
    this.ask({ type: "call_black", black: this.goesBlack ? 0 : 1, seconds: seconds ?? usual, easing });
  }

  /** Whether the call is timed and a T-bar has it, so that it runs on once the hand is off. */
  releasable(axis: LookKind): boolean {
    return this.callOf(axis)?.by_hand === true && this.#timed[axis] !== false;
  }

  release(axis: LookKind): void {
    if (this.#timed[axis] === false && this.online) this.say(NOTHING_TO_RELEASE);
    else this.#play((character) => ({ type: `release_${axis}` as const, character }));
  }

  /** Panic of the characters that this console plays, or of all that there are. */
  panic(all = false): void {
    this.#handsOff();
    const messages = (all ? [ALL] : this.played.targets).map((character) => this.#panicOf(character));
    this.#unheard.press(messages, this.now());
    if (this.online) this.#sendPanic(messages);
    else this.say(NOT_HEARD);
    this.tell("panic");
  }

  #panicOf(character: string): FromClient {
    const id = this.#requests.nextId();
    this.#requests.add(id, { refused: () => this.#unheard.forget() });
    return { type: "panic", character, id };
  }

  /** Chooses the face that a second panic brings, and the seconds that it takes. */
  setHome(face: string, seconds: number): void {
    const [before, label] = [Object.entries(this.state?.characters ?? {}), this.label("face", face)];
    const [redo, undo]: [Change[], Change[]] = [[], []];
    for (const [character, { home_face, home_seconds }] of before.filter(([name]) =>
      this.played.names.includes(name),
    )) {
      redo.push({ type: "set_home", character, face, seconds });
      undo.push({ type: "set_home", character, face: home_face, seconds: home_seconds });
    }
    this.act(`The home face is ${label}.`, { what: `home face ${label}`, undo, redo });
  }

  /** Sends a message for each character that is played; whether it was sent. */
  #play(make: (character: string) => FromClient): boolean {
    return this.played.targets.map(make).every((message) => this.push(message));
  }

  /** Sends a message that is no value of a frame; whether it was sent. */
  push(message: FromClient): boolean {
    if (!this.#mayAct()) return false;
    this.#outbox.push(message);
    this.sent.receive(message);
    if ("id" in message && message.id) this.#remember(message.id, message);
    return true;
  }

  #remember(id: string, message: FromClient): void {
    this.#called.set(id, message);
    const [oldest] = this.#called.keys();
    if (this.#called.size > MOST_CALLED && oldest !== undefined) this.#called.delete(oldest);
  }

  clearChannels(names: Iterable<string>): void {
    if (!this.#mayAct()) return;
    const read = (name: string) => this.played.weights(name, this.channel(name, false).value(this.now()));
    const before = [...names].flatMap(read).filter(([, , weight]) => weight !== 0);
    if (before.length === 0) return;
    const step = clearStep(before);
    const counted = { ...step, panics: this.played.panics(movedBy(step)) };
    this.act(`Cleared ${step.what.replace(/^clear /, "")}.`, counted);
  }

  takeStep(step: Step, way: Way, refused: Parameters<TakeStep>[2]): boolean {
    if (!this.#mayAct()) return false;
    const over = step.panics !== undefined && (this.#panicking || step.panics !== this.played.panics(movedBy(step)));
    if (way === "undo" && over) return this.tooLate(step);
    return step[way].map((change) => this.#change(change, refused)).some(Boolean);
  }

  #change(change: Change, refused: (reason: string) => void): boolean {
    if (change.type === "set_home") return this.push(change);
    if (change.type === "set_channel") {
      if (this.played.names.join() === change.character) this.channel(change.name, false).nudge(change.value);
      else this.#outbox.put(`${change.character}/channel:${change.name}`, change);
      return true;
    }
    return this.ask(change, { refused: ({ reason }) => refused(reason) });
  }

  centre(): void {
    for (const part of HEAD) this.head(part).nudge(0);
    for (const part of GAZE) this.gaze(part).nudge(0);
  }

  /** A value for a parameter of the scene, with the next frame. */
  put(parameter: string, message: FromClient): void {
    if (this.#mayAct()) this.#outbox.put(parameter, message);
  }

  /** Sends what the hands changed since the last frame. */
  flush = (): void => {
    this.#outbox.flush();
    this.#knobs.sent();
  };

  /** The weight of a channel; with `linked` its mirror moves along. */
  channel(name: string, linked = this.linked): Knob {
    return this.#knobs.channel(name, linked ? this.mirrorOf(name) : null);
  }

  readonly head = (part: HeadPart): Knob => this.#knobs.head(part);
  readonly gaze = (part: GazePart): Knob => this.#knobs.gaze(part);
  /** How much of a layer shows. */
  readonly layer: Knobs["layer"] = (...of) => this.#knobs.layer(...of);
  /** Where the point of a pad stands along a dimension of it. */
  readonly pad: Knobs["pad"] = (...of) => this.#knobs.pad(...of);
  readonly motion: Knobs["motion"] = (detail) => this.#knobs.motion(detail);
  readonly spring: Knobs["spring"] = (name) => this.#knobs.spring(name);
  readonly skin: Knobs["skin"] = (name) => this.#knobs.skin(name);
  /** Where a macro is. */
  readonly macro: Knobs["macro"] = (name) => this.#knobs.macro(name);

  /** Where a T-bar stands, under the hand of this console or of another. */
  bar(axis: LookKind): Knob {
    return this.#knobs.bar(axis);
  }

  callOf(axis: LookKind): CallState | null {
    return this.air === null ? null : callOf(this.air, axis);
  }
}
