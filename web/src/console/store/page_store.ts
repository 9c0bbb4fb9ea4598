/** What the console has whatever is on air: the cast, who listens to changes, the arrangement, the notice and what can be taken back. */

import type { Bus } from "../../link/bus";
import { IDLE_POSES } from "../../link/constants";
import type {
  Crew,
  ExpressionDocument,
  FaceDocument,
  FromClient,
  FromServer,
  LightDocument,
  Manifest,
  PoseDocument,
  SourceState,
} from "../../link/messages";
import { MessageStore } from "../../link/topics";
import { type Arrangement, FIRST } from "./arrangement";
import { type Axis, type LookKind, timingOf } from "./axis";
import { mirrorOf, type Strip, stripsOf } from "./channels";
import type { PlayRegion, PoseRegion } from "./region_calls";
import { type Seconds, secondsLabel, type Timing } from "./timing";
import { type Step, type TakeStep, UndoHistory, type Way } from "./undo_history";

const IDLE: ReadonlySet<string> = new Set(IDLE_POSES);

/** What of the page itself has changed. */
type PageTopic =
  | "browser_devices"
  | "manifest"
  | "link"
  | "timing"
  | "arrangement"
  | "black"
  | "call"
  | "notice"
  | "panic"
  | "characters"
  | "naming"
  | "pad_edit"
  | "undo"
  | "show"
  | "import";
/** What has changed, for elements that render (rarely); what moves is read every frame instead. */
export type Topic = PageTopic | FromServer["type"];

/** Where to go on from a notice, in the tab of the editor or another, or what to do about it. */
export type Offer =
  | { readonly label: string; readonly address: string; readonly tab?: string }
  | { readonly label: string; readonly act: () => void };

/** What stands in the bar until it is answered; `dismiss`: what its cross does. */
export interface Question {
  readonly text: string;
  readonly offers: readonly Offer[];
  readonly dismiss: () => void;
}

/** A sentence that the operator was told, and when: milliseconds since 1970. */
export interface LogEntry {
  readonly time: number;
  readonly text: string;
  readonly tone: "attention" | "done";
}

/** Sentences that the log remembers. */
const MOST_LOG_ENTRIES = 200;
const DONE: Readonly<Record<Way, string>> = { undo: "Undone", redo: "Done again" };

export abstract class PageStore extends MessageStore<FromServer, PageTopic> {
  /** All that was told, the newest last. */
  logEntries: readonly LogEntry[] = [];
  readonly history = new UndoHistory(
    (step, way, refused) => this.takeStep(step, way, refused),
    (step, way, reason) => this.#offerToSkip(step, way, reason),
    () => this.tell("undo"),
  );
  /** What this page looks at, and plays. */
  bus: Bus = "air";
  /** Which show file is played; "" while it is not known. */
  show = "";
  manifest: Manifest | null = null;
  /** What this page sent of each kind last. */
  readonly sent = new MessageStore<FromClient>();
  /** The last thing the operator must read, how it is meant, and what can be done about it. */
  notice: string | null = null;
  tone: "attention" | "done" = "attention";
  offers: readonly Offer[] = [];
  arrangement: Arrangement = FIRST;
  /** The pad of looks that is edited at this page, on which tiles can be dragged; "" for none. */
  editedPad = "";
  /** Where the next calls of expressions go: one region of the face alone; null: the whole face. */
  region: PlayRegion | null = null;
  /** Milliseconds there and back, or null before the first pong. */
  latency: number | null = null;
  /** Whether a hand may move a control, named as in `Hands`; where not, the operator has been told why. */
  mayPlay: (control: string) => boolean = () => true;
  #strips: Strip[] = [];
  #labels: Record<Axis, ReadonlyMap<string, string>> = { face: new Map(), expression: new Map() };

  /** `wall`: milliseconds since 1970, for people to read. */
  constructor(private readonly wall: () => number = Date.now) {
    super();
    this.hear("welcome", ({ show }) => {
      if (show === this.show) return; // another one may be served at the same address
      this.show = show;
      this.tell("show");
    });
  }

  /** What the other consoles call this one. */
  get name(): string {
    return this.newest("welcome")?.name ?? "";
  }

  get crew(): Crew | null {
    return this.newest("crew");
  }

  /** What sends values all the time. */
  get sources(): readonly SourceState[] {
    return this.newest("sources")?.sources ?? [];
  }

  /** Sends what a step does in one way; whether it was sent. */
  abstract takeStep(...step: Parameters<TakeStep>): boolean;

  /** What people read of a name; a name that the cast does not know stands for itself. */
  label(kind: LookKind, name: string): string {
    if (kind === "pose") return this.manifest?.figures?.poses.find((pose) => pose.name === name)?.label ?? name;
    return this.#labels[kind].get(name) ?? name;
  }

  get poses(): readonly PoseDocument[] {
    return (this.manifest?.figures?.poses ?? []).filter(({ name }) => !IDLE.has(name));
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
    this.tell("manifest");
  }

  get timing(): Arrangement["timing"] {
    return this.arrangement.timing;
  }

  /** Left and right of a pair move together. */
  get linked(): boolean {
    return this.arrangement.linked;
  }

  /** Chosen seconds end calls by hand. */
  setTiming(axis: Axis, change: Partial<Timing>): void {
    const timed = change.seconds === undefined ? {} : { byHand: false };
    this.arrange({ timing: { ...this.timing, [axis]: { ...this.timing[axis], ...timed, ...change } } });
  }

  /** Lays the console out. */
  arrange(change: Partial<Arrangement>): void {
    this.arrangement = { ...this.arrangement, ...change };
    if (change.timing !== undefined) this.tell("timing");
    this.tell("arrangement");
  }

  /** The seconds of the next call; a region has no T-bar, and takes those that are chosen beside it. */
  callSeconds(axis: LookKind, region: PlayRegion | PoseRegion | null = null): Seconds {
    const { seconds, byHand } = this.timing[timingOf(axis)];
    return byHand && region === null ? null : seconds;
  }

  /** Chooses where the next calls of expressions go. */
  chooseRegion(region: PlayRegion | null): void {
    this.region = region;
    this.warnOfHand(region);
    this.tell("timing");
  }

  /** Says what calls take that go to a region while calls are by hand; null: the whole, which has a T-bar. */
  warnOfHand(region: PlayRegion | PoseRegion | null): void {
    const { seconds, byHand } = this.timing.expression;
    if (region !== null && byHand)
      this.say(`No T-bar moves one region alone: calls there take ${secondsLabel(seconds)} s.`, "done");
  }

  /** Edits a pad of looks; "" for none. */
  editPad(name: string): void {
    this.editedPad = name;
    this.tell("pad_edit");
  }

  /** The way there and back took `milliseconds`. */
  receiveTrip(milliseconds: number): void {
    this.latency = milliseconds;
    this.tell("crew");
  }

  /** The channel that moves the same on the other side of the face; null where there is none. */
  protected mirrorOf(name: string): string | null {
    return mirrorOf(name, this.#strips);
  }

  say(notice: string | null, tone: PageStore["tone"] = "attention", offers: readonly Offer[] = []): void {
    [this.notice, this.tone, this.offers] = [notice, tone, offers];
    if (notice !== null) this.log(notice, tone);
    this.tell("notice");
  }

  /** What the log says and the bar does not. */
  log(text: string, tone: PageStore["tone"]): void {
    this.logEntries = [...this.logEntries, { time: this.wall(), text, tone }].slice(-MOST_LOG_ENTRIES);
  }

  /** Says what was done, and offers to take it back. */
  offerUndo(done: string, step: Step, others: readonly Offer[] = []): void {
    this.history.add(step);
    this.say(done, "done", [{ label: "Undo", act: () => this.undo() }, ...others]);
  }

  /** Does something that can be taken back, unless the show rejects it; whether it was sent. */
  act(done: string, step: Step): boolean {
    if (!this.takeStep(step, "redo", () => this.history.skip(step))) return false;
    this.offerUndo(done, step);
    return true;
  }

  /** What the show still works at, so that nothing can be taken back yet; null for nothing. */
  get busy(): string | null {
    return null;
  }

  /** Takes the last change of the show back that was made here: an own item, a layout, the home face, cleared faders. */
  undo(): void {
    this.#take("undo");
  }

  /** Does again what was taken back last. */
  redo(): void {
    this.#take("redo");
  }

  #take(way: Way): void {
    if (this.busy !== null) this.say(`Not yet: ${this.busy}.`);
    else if (this.history.next(way) === null) this.say(NOTHING[way]);
    else {
      const step = this.history.take(way);
      if (step !== null) this.say(`${DONE[way]}: ${step.what}.`, "done", this.#ways());
    }
  }

  /** A step that a panic has overtaken is left out. */
  protected tooLate(step: Step): false {
    this.history.skip(step);
    this.say("Not brought back: panic was pressed meanwhile.");
    return false;
  }

  #ways(): Offer[] {
    const [undo, redo] = [this.history.next("undo"), this.history.next("redo")];
    const more: Offer[] = undo === null ? [] : [{ label: "Undo more", act: () => this.undo() }];
    return redo === null ? more : [{ label: "Redo", act: () => this.redo() }, ...more];
  }

  /** A step that the show rejects must not bar the way to those before it. */
  #offerToSkip(step: Step, way: Way, reason: string): void {
    const skip = (): void => {
      this.history.skip(step);
      this.say(`Left as it is: ${step.what}.`, "done", this.#ways());
    };
    const says = `Not ${way === "undo" ? "undone" : "done again"} (${step.what}): ${reason}`;
    this.say(says, "attention", [{ label: "Leave it", act: skip }]);
  }
}

const NOTHING: Readonly<Record<Way, string>> = {
  undo: "Nothing to undo: what you keep, name, delete, clear or save here can be taken back.",
  redo: "Nothing to do again.",
};
