/** What the page of clips knows of them, and what it may do with them. Nothing here touches the page. */

import { missingRole } from "../../access/page_access";
import { CLIP_PARTS } from "../../link/constants";
import type {
  AccessDocument,
  ClipOutline,
  ClipPass,
  ClipState,
  ClipWork,
  EditClip,
  EditLane,
  LaneOutline,
  NamedSound,
  State,
} from "../../link/messages";
import { TopicStore } from "../../link/topics";
import type { ConsoleStore } from "../store/console_store";
import type { Change, Step } from "../store/undo_history";
import { type Arming, armedAfter } from "./armed_parts";
import { findCallers } from "./clip_callers";
import { clipTime, endedWords, passesOf, passLabel, passWords, positionOf } from "./clip_passes";
import { HandsAbove } from "./hands_above";
import type { PageMarks } from "./page_marks";
import { freeLaneName, laneKey, type Span } from "./timeline";

export type Part = (typeof CLIP_PARTS)[number];
/** `clips`: their names and the one that is shown; `work`: what is recorded; `view`: what this page marks and arms. */
export type ClipTopic = "clips" | "work" | "view" | "link" | "notice" | "characters" | "undo";

/** Seconds that are counted in. */
const COUNT_IN = 3;
/** Seconds that are played before a span that is recorded again, and recorded after it. */
const RUN_UP = 2;
const RUN_OUT = 0.1;
/** Seconds in which playing begins and ends by the keys of a transport. */
const BLEND = 0.1;
const AGAIN_MS = 500;
/** Milliseconds within which presses that shift a lane follow each other. */
const RUN_MS = 1000;
const NO_WORK: ClipWork = { type: "clip_work", passes: [], edits: 0 };

/** A span of a lane that is recorded again: `by` is the pass, which replaces it once it is over. */
interface SpanAgain extends Span {
  readonly lane: string;
  readonly by: string;
}

type EditOf<Message> = Partial<Omit<Message, "type" | "id" | "name" | "lane">>;

export class ClipStore extends TopicStore<ClipTopic> {
  /** The clip that is shown; one that has no pass yet is in no list. */
  name = "";
  outline: ClipOutline | null = null;
  /** The lane that is chosen, from 0. */
  lane = 0;
  /** The place from which is played and recorded, seconds of the clip. */
  cursor = 0;
  span: Span | null = null;
  /** Where a span begins that has no end yet. */
  begun: number | null = null;
  /** The parts that are recorded next. */
  armed: ReadonlySet<Part> = new Set(CLIP_PARTS);
  countsIn = true;
  /** At what speed passes are recorded: seconds of the clip a second. */
  passSpeed = 1;
  /** Seconds until the pass begins; null while none is counted in. */
  counting: number | null = null;
  search = "";
  access: AccessDocument = { role: "admin", name: "", asked: false };
  /** The sound that a new clip has from its first pass on; "" for none. */
  firstSound = "";
  #silent = "";
  /** How many panics the character had had. */
  #panics: number | null = null;
  /** The presses that shift a lane now: from where, and where it was asked to be last. */
  #shifts: { of: string; before: number; asked: number; step: Step | null } | null = null;
  readonly #hands = new HandsAbove(this);
  #chosen = "";
  #again: SpanAgain | null = null;
  #work: ClipWork = NO_WORK;
  #ending: "keep" | "discard" | "again" | null = null;
  /** The name of a lane that is chosen once it is there. */
  #awaited: string | null = null;
  #epoch: State["epoch"] | null = null;
  #reading = 0;
  #count = 0;
  #counts = 0;

  /** `page`: a name that no other page has; `later`: calls after some milliseconds; `marks`: outlive a reload. */
  constructor(
    readonly show: ConsoleStore,
    private readonly page: string,
    private readonly request: typeof fetch = (...of) => fetch(...of),
    private readonly later: (act: () => void, milliseconds: number) => unknown = (act, wait) => setTimeout(act, wait),
    private readonly marks: Pick<PageMarks, "read" | "write"> = { read: () => ({}), write: () => undefined },
  ) {
    super();
    const { armed, countsIn, passSpeed, character } = marks.read();
    if (armed !== undefined) this.armed = new Set(armed);
    [this.countsIn, this.passSpeed] = [countsIn ?? this.countsIn, passSpeed ?? this.passSpeed];
    this.#chosen = character ?? "";
    this.listen("view", () => this.#keepMarks());
    this.listen("clips", () => this.#keepMarks());
    show.sent.hear("keep_pass", ({ character, keep }) => {
      if (character === this.character) this.#ending ??= keep ? "keep" : "discard"; // at its red light
    });
    show.hear("clips", () => this.#receiveNames());
    show.hear("sounds", () => this.tell("clips"));
    show.hear("sound_dropped", ({ name, needed_by }) => {
      if (needed_by.length > 0)
        this.show.say(
          `The sound ${name} is deleted, and needed by ${needed_by.join(", ")}: silent now. Undo brings it back.`,
        );
    });
    show.hear("clip_work", (work) => this.#receiveWork(work));
    show.hear("state", ({ epoch }) => {
      this.#forgetDropped(epoch);
      this.#endSpan();
      this.#hearSilence();
      this.#hands.hear();
      this.#hearPanic();
    });
    show.listen("link", () => this.#relink());
    for (const topic of ["notice", "characters", "undo"] as const) show.listen(topic, () => this.tell(topic));
  }

  // --- what shows ---

  get names(): readonly string[] {
    return this.show.newest("clips")?.names ?? [];
  }

  get found(): readonly string[] {
    const words = this.search.toLowerCase().split(/\s+/).filter(Boolean);
    return this.names.filter((name) => words.every((word) => name.toLowerCase().includes(word)));
  }

  get lanes(): readonly LaneOutline[] {
    return this.outline?.lanes ?? [];
  }

  get chosenLane(): LaneOutline | null {
    return this.lanes[this.lane] ?? null;
  }

  /** The character that plays and is recorded here. */
  get character(): string {
    const names = Object.keys(this.show.state?.characters ?? {});
    return names.includes(this.#chosen) ? this.#chosen : (names[0] ?? "");
  }

  labelOf(character: string): string {
    return this.show.state?.characters[character]?.label || character;
  }

  /** The pass that is recorded of the character that is chosen. */
  get pass(): ClipPass | null {
    return passesOf(this.show).find(({ character }) => character === this.character) ?? null;
  }

  /** The shown clip as the character plays it; null while it does not. */
  get playing(): ClipState | null {
    const clips = this.show.state?.characters[this.character]?.clips ?? [];
    return clips.findLast(({ name }) => name === this.name) ?? null;
  }

  /** Where the clip is now, seconds of it. */
  get position(): number {
    const { pass, playing } = this;
    if (pass !== null && pass.name === this.name) return positionOf(pass, this.show.state?.time ?? 0);
    return playing === null ? this.cursor : playing.elapsed + (this.outline?.start ?? 0);
  }

  /** Why nobody would hear this page play; "" where the show hears it. */
  get unheard(): string {
    if (!this.show.online) return "Link lost: the show does not hear this page.";
    return missingRole(this.access, "operate", "playing clips") ?? "";
  }

  /** Why this page records and edits nothing; "" where it may. */
  get locked(): string {
    if (!this.show.online) return this.unheard;
    return missingRole(this.access, "edit", "recording and editing clips") ?? "";
  }

  setAccess(access: AccessDocument): void {
    this.access = access;
    this.tell("view");
  }

  // --- what this page marks ---

  /** Shows another clip, or a new one that its first pass makes. */
  choose(name: string): void {
    this.name = name;
    this.#awaited = null;
    [this.lane, this.span, this.begun, this.outline] = [0, null, null, null];
    [this.cursor, this.firstSound] = [0, ""];
    this.tell("clips");
    void this.#read(true);
  }

  /** Begins a clip that its first pass makes; false where there is one of this name, which is then said. */
  begin(name: string): boolean {
    const twin = this.names.find((each) => each.toLowerCase() === name.toLowerCase());
    if (twin !== undefined)
      this.show.say(`There is a clip ${twin} already: give another name.`, "attention", [
        { label: `Open ${twin}`, act: () => this.choose(twin) },
      ]);
    else {
      this.choose(name);
      this.show.say(`Arm parts and record (R): the first pass makes ${name}.`, "done");
    }
    return twin === undefined;
  }

  chooseCharacter(name: string): void {
    [this.#chosen, this.#panics] = [name, null];
    this.tell("view");
  }

  chooseLane(index: number): void {
    this.lane = Math.max(0, Math.min(this.lanes.length - 1, index));
    this.tell("view");
  }

  searchFor(text: string): void {
    this.search = text;
    this.tell("view");
  }

  /** Marks a place; what plays goes on from there. */
  seek(seconds: number): void {
    const { start = 0, stop = Number.POSITIVE_INFINITY } = this.outline ?? {};
    this.cursor = Math.max(start, Math.min(stop, seconds));
    if (this.playing !== null && this.pass === null) this.#playFrom(this.cursor);
    this.tell("view");
  }

  select(span: Span | null): void {
    [this.span, this.begun] = [span, null];
    this.tell("view");
  }

  /** A span begins or ends at the place where the clip is. */
  mark(end: "from" | "to"): void {
    const here = this.position;
    const other = end === "from" ? (this.span?.to ?? null) : (this.span?.from ?? this.begun);
    if (other !== null && (end === "from" ? here < other : here > other))
      this.select(end === "from" ? { from: here, to: other } : { from: other, to: here });
    else if (end === "from") [this.span, this.begun] = [null, here];
    else this.show.say("The span ends before it begins: press I where it is to begin, then O.");
    this.tell("view");
  }

  arm(part: Part, how: Arming): void {
    this.armed = armedAfter(this.armed, part, how);
    this.tell("view");
  }

  armAll(): void {
    this.armed = new Set(CLIP_PARTS);
    this.tell("view");
  }

  setCountIn(on: boolean): void {
    this.countsIn = on;
    this.tell("view");
  }

  setPassSpeed(speed: number): void {
    this.passSpeed = speed;
    this.tell("view");
  }

  // --- what plays ---

  /** Plays from the place that is marked, or stops; ends a pass that is recorded, and keeps it. */
  togglePlay(): void {
    if (this.counting !== null) this.#cancel();
    else if (this.pass !== null) this.keep();
    else if (this.playing !== null) this.stop();
    else this.#playFrom(this.cursor);
  }

  stop(): void {
    if (this.#may(this.unheard))
      this.show.ask({ type: "stop_clip", character: this.character, name: this.name, seconds: BLEND });
  }

  #playFrom(seconds: number): void {
    const { outline } = this;
    if (outline === null) this.show.say("Nothing to play yet: choose a clip, or record a pass.");
    else if (this.#may(this.unheard)) {
      const at = seconds - outline.start;
      const start = at < outline.stop - outline.start - 0.05 ? Math.max(0, at) : 0;
      this.show.ask({ type: "play_clip", character: this.character, name: this.name, seconds: BLEND, start });
    }
  }

  // --- what is recorded ---

  /** Records a pass of what is armed, after the count; ends and keeps the one that is recorded. */
  record(): void {
    if (this.counting !== null) this.#cancel();
    else if (this.pass !== null) this.keep();
    else if (this.#mayRecord() && this.armed.size === 0)
      this.show.say("No part is armed: press 1 to 7 (A: all), or touch what is to be recorded.");
    else if (this.#mayRecord()) this.#countIn(() => this.#begin());
    if (this.counting !== null) this.#hands.say(this.#hands.above(this.armed));
  }

  /** Records a span of the chosen lane again, from a little before it. */
  recordAgain(): void {
    const { span, chosenLane: lane, outline } = this;
    if (!this.#mayRecord()) return;
    if (span === null || lane === null || outline === null)
      this.show.say("Select a span of a lane first: drag over it, or I and O.");
    else if (this.pass !== null) this.show.say("A pass is recorded already: keep it, or discard it, first.");
    else {
      const by = freeLaneName(this.lanes, "again");
      const start = Math.min(outline.stop, Math.max(outline.start, span.from - RUN_UP));
      this.#countIn(() => {
        this.#again = { ...span, lane: laneKey(this.lanes, this.lane), by };
        this.#send(lane.parts, by, start);
      });
    }
  }

  /** Ends the pass and keeps it; that of somebody else only after a question. */
  keep(): void {
    if (this.#asks()) return;
    if (this.#again !== null) this.#replaceAgain(Math.min(this.#again.to, this.position));
    else this.#end("keep");
  }

  /** Ends the pass without a trace; without one, forgets what is selected. */
  discard(): void {
    if (this.counting !== null) this.#cancel();
    else if (this.pass === null) this.select(null);
    else if (!this.#asks()) this.#end("discard");
  }

  /** Asks before a pass ends that another records; whether it did. */
  #asks(): boolean {
    const { pass } = this;
    if (pass === null || pass.by === this.show.name) return false;
    const says = `${passWords(pass, this.labelOf(pass.character), CLIP_PARTS.length)}: it goes on.`;
    this.show.say(says, "attention", [
      { label: "Keep it", act: () => this.#end("keep") },
      { label: "Discard it", act: () => this.#end("discard") },
    ]);
    return true;
  }

  #mayRecord(): boolean {
    if (this.name === "") this.show.say("Choose a clip, or begin a new one (N), before you record.");
    return this.name !== "" && this.#may(this.locked);
  }

  #countIn(then: () => void): void {
    this.#counts += 1;
    const begun = this.#counts;
    const step = (left: number): void => {
      if (left < COUNT_IN && (this.counting === null || begun !== this.#counts)) return; // it was called off
      this.counting = left > 0 ? left : null;
      if (left > 0) this.later(() => step(left - 1), 1000);
      else then();
      this.tell("view");
    };
    if (this.countsIn) step(COUNT_IN);
    else then();
  }

  #cancel(): void {
    this.counting = null;
    this.show.say("Nothing is recorded.", "done");
    this.tell("view");
  }

  #begin(): void {
    const parts = CLIP_PARTS.filter((part) => this.armed.has(part));
    const called = parts.length === CLIP_PARTS.length ? "all" : parts.join("+");
    const start = this.outline === null ? null : Math.max(this.outline.start, Math.min(this.outline.stop, this.cursor));
    this.#send(parts, freeLaneName(this.lanes, called), start);
  }

  #send(parts: readonly Part[], lane: string, start: number | null): void {
    this.#ending = null;
    this.#hands.forget();
    this.show.say(null);
    const asked = { type: "record_clip", character: this.character, name: this.name, lane, start } as const;
    const refused = ({ reason }: { reason: string }): void => {
      this.#again = null;
      this.show.say(reason);
    };
    const sound = this.outline === null ? this.firstSound : "";
    if (this.passSpeed !== 1 && this.sound !== "") this.show.say("Not at full speed: no sound is heard in this pass.");
    this.show.ask({ ...asked, parts: [...parts], sound, speed: this.passSpeed }, { refused });
  }

  #end(how: "keep" | "discard"): void {
    const { pass } = this;
    if (pass === null) this.show.say("No pass is recorded.");
    else if (this.#may(this.locked)) {
      [this.#ending, this.#again] = [how, null];
      const ends = { type: "keep_pass", character: pass.character, keep: how === "keep" } as const;
      if (how === "discard") this.show.ask(ends);
      else this.#change(`Kept in ${pass.name}: ${passLabel(pass)} is a lane now.`, "pass", [ends], pass.name);
    }
  }

  /** Says that a pass goes on after a panic, with what shows then. */
  #hearPanic(): void {
    const [before, now] = [this.#panics, this.show.state?.characters[this.character]?.panics ?? 0];
    this.#panics = now;
    if (this.pass === null || before === null || before === now) return;
    this.show.say("Panic: the pass goes on, and records the neutral face until it is played again.", "attention", [
      { label: "Keep", act: () => this.keep() },
      { label: "Discard", act: () => this.discard() },
    ]);
  }

  /** Says why the sound of a clip that plays is not heard. */
  #hearSilence(): void {
    const silent = this.playing?.silent ?? "";
    if (silent !== "" && silent !== this.#silent) this.show.say(`The clip plays without its sound: ${silent}`);
    this.#silent = silent;
  }

  /** The span that is recorded again is over. */
  #endSpan(): void {
    const again = this.#again;
    if (again !== null && this.pass?.lane === again.by && this.position >= again.to + RUN_OUT)
      this.#replaceAgain(again.to);
  }

  #replaceAgain(to: number): void {
    const { pass } = this;
    const again = this.#again;
    if (again === null || pass === null || to - again.from < 0.05)
      this.#end("keep"); // it stays, as a lane
    else if (this.#may(this.locked)) {
      const { lane, by, from } = again;
      [this.#ending, this.#again] = ["again", null];
      this.#change(
        `Recorded again from ${clipTime(from)} to ${clipTime(to)}.`,
        "span recorded again",
        [
          { type: "keep_pass", character: pass.character, keep: true },
          { type: "replace_span", name: pass.name, lane, by, start: from, stop: to },
        ],
        pass.name,
      );
    }
  }

  #receiveWork(work: ClipWork): void {
    const before = this.#work;
    this.#work = work;
    this.tell("work");
    const kept = before.edits !== work.edits;
    if (kept) void this.#read(false);
    const ended = before.passes.find((pass) => pass.character === this.character && pass.name === this.name);
    if (ended !== undefined && !work.passes.some(({ character }) => character === ended.character))
      this.#hearEnd(ended, kept);
  }

  /** A pass of the character is over; what this page ended itself has been said. */
  #hearEnd(pass: ClipPass, kept: boolean): void {
    const how = this.#ending;
    [this.#ending, this.#again] = [null, null];
    if (kept && how !== "again") this.#awaited = pass.lane; // what is new is chosen
    if (how === "discard") this.show.say("The pass is discarded.", "done");
    else if (how === null) this.show.say(endedWords(pass, kept, this.show.state?.time ?? 0), "done");
  }

  // --- what is edited ---

  editClip(change: EditOf<EditClip>): void {
    const { outline, name } = this;
    if (outline === null || !this.#may(this.locked)) return;
    const before = Object.fromEntries(Object.keys(change).map((key) => [key, outline[key as keyof typeof change]]));
    const what = Object.keys(change).join(", ").replaceAll("_", " ");
    this.show.act(`${name}: ${what} changed.`, {
      what: `${what} of ${name}`,
      undo: [{ type: "edit_clip", name, ...before }],
      redo: [{ type: "edit_clip", name, ...change }],
    });
  }

  /** What the clip calls the sound that is heard with it: its name, or the key of one without; "" for none. */
  get sound(): string {
    return this.outline === null ? this.firstSound : this.outline.sound;
  }

  /** The sounds that the show file keeps. */
  get sounds(): readonly NamedSound[] {
    return this.show.newest("sounds")?.sounds ?? [];
  }

  /** The sound of the clip, where the show file keeps it: by its name of now or of before, or by its key. */
  get namedSound(): NamedSound | null {
    const { sound, sounds } = this;
    const calls: ((each: NamedSound) => boolean)[] = [
      ({ name }) => name === sound,
      ({ former }) => (former ?? []).includes(sound),
      (each) => each.sound === sound,
    ];
    return calls.map((call) => sounds.find(call)).find((each) => each !== undefined) ?? null;
  }

  /**
   * Adds a file to the sounds of the show, under its name; it is heard with the clip from the place that is marked on,
   * with a new clip from its first pass on.
   */
  async bringSound(file: File): Promise<void> {
    if (!this.#may(this.locked)) return;
    const { name, cursor } = this;
    try {
      const called = freeLaneName(this.sounds, file.name.replace(/\.[^.]*$/, "").slice(0, 50) || "sound");
      const answer = await this.request(`/sounds?name=${encodeURIComponent(called)}`, { method: "POST", body: file });
      if (!answer.ok) throw new Error(`${file.name} was not added: ${await answer.text()}`);
      const added = (await answer.json()) as { name: string; seconds: number };
      const told = `The sound ${added.name} (${clipTime(added.seconds)}) is in the show`;
      if (name === "" || name !== this.name) this.show.say(`${told}.`, "done");
      else {
        this.setSound(added.name, cursor);
        this.show.say(`${told}; ${name} is recorded along with it.`, "done");
      }
    } catch (error) {
      this.show.say(
        error instanceof TypeError
          ? "The show does not answer: the sound was not sent."
          : `${(error as Error).message}`,
      );
    }
  }

  /** Gives the sound of the clip another name in the show. */
  renameSound(to: string): void {
    const name = this.namedSound?.name ?? "";
    if (name === "" || to === "" || to === name || !this.#may(this.locked)) return;
    this.show.act(`The sound ${name} is called ${to}; clips and cues find it still.`, {
      what: `sound ${to}`,
      undo: [{ type: "rename_sound", name: to, to: name }],
      redo: [{ type: "rename_sound", name, to }],
    });
  }

  /** Takes the sound of the clip out of the show; who needs it is said. */
  dropSound(): void {
    const name = this.namedSound?.name ?? "";
    if (name === "" || !this.#may(this.locked)) return;
    this.show.act(`The sound ${name} is deleted.`, {
      what: `deleted sound ${name}`,
      undo: [{ type: "restore_sound", name }],
      redo: [{ type: "drop_sound", name }],
    });
  }

  /** Has another sound heard with the clip, from a place on; "": none. */
  setSound(sound: string, from = 0): void {
    if (this.outline === null) {
      this.firstSound = sound;
      this.tell("view");
    } else this.editClip(sound === "" ? { sound } : { sound, sound_at: from });
  }

  /** `was`: what is taken back to, where that is not what was heard last. */
  editLane(index: number, change: EditOf<EditLane>, what: string, was: EditOf<EditLane> = {}): void {
    const [lane, name] = [this.lanes[index], this.name];
    if (lane === undefined || !this.#may(this.locked)) return;
    const { to, ...rest } = change;
    const heard = Object.fromEntries(Object.keys(rest).map((key) => [key, lane[key as keyof typeof rest]]));
    const before: EditOf<EditLane> = { ...heard, ...was };
    const renamed = this.lanes.map((each, place) => (place === index && to != null ? { name: to } : each));
    const [old, now] = [laneKey(this.lanes, index), laneKey(renamed, index)];
    this.show.act(`${what}.`, {
      what,
      undo: [{ type: "edit_lane", name, lane: now, ...before, ...(to == null ? {} : { to: lane.name }) }],
      redo: [{ type: "edit_lane", name, lane: old, ...change }],
    });
  }

  /** A part is of a lane, or not. */
  togglePart(index: number, part: Part): void {
    const lane = this.lanes[index];
    if (lane === undefined) return;
    const has = lane.parts.includes(part);
    const parts = CLIP_PARTS.filter((each) => (each === part ? !has : lane.parts.includes(each)));
    this.editLane(index, { parts }, `Lane ${index + 1} ${has ? "without" : "with"} ${part}`);
  }

  toggleMute(index: number): void {
    const lane = this.lanes[index];
    if (lane !== undefined)
      this.editLane(index, { muted: !lane.muted }, `Lane ${index + 1} ${lane.muted ? "plays again" : "is mute"}`);
  }

  /**
   * Moves a lane by so many seconds from where it was asked to be last, heard or not: presses that follow each other
   * within a second are one step that can be taken back.
   */
  shift(index: number, seconds: number): void {
    const lane = this.lanes[index];
    if (lane === undefined || seconds === 0 || !this.#may(this.locked)) return;
    const of = `${this.name}/${laneKey(this.lanes, index)}`;
    const run = this.#shifts?.of === of && this.show.history.next("undo") === this.#shifts.step ? this.#shifts : null;
    const [before, asked] = run === null ? [lane.shift, lane.shift] : [run.before, run.asked];
    if (run !== null && run.step !== null) this.show.history.skip(run.step);
    this.#shiftTo(index, asked + seconds, before);
    const begun = { of, before, asked: asked + seconds, step: this.show.history.next("undo") };
    this.#shifts = begun;
    this.later(() => {
      if (this.#shifts === begun) this.#shifts = null;
    }, RUN_MS);
  }

  /** Moves a lane to so many seconds. */
  shiftTo(index: number, seconds: number): void {
    const lane = this.lanes[index];
    this.#shifts = null;
    if (lane !== undefined && seconds !== lane.shift) this.#shiftTo(index, seconds, lane.shift);
  }

  #shiftTo(index: number, seconds: number, before: number): void {
    const shift = Math.round(seconds * 1000) / 1000;
    const what = `Lane ${index + 1} ${Math.abs(shift)} s ${shift < 0 ? "earlier" : "later"}`;
    this.editLane(index, { shift }, what, { shift: before });
  }

  dropLane(index: number): void {
    if (this.lanes[index] === undefined || !this.#may(this.locked)) return;
    const lane = laneKey(this.lanes, index);
    this.#change(`Lane ${index + 1} is deleted.`, "deleted lane", [{ type: "drop_lane", name: this.name, lane }]);
  }

  /** Another lane takes the place of the chosen one within the span, and is no lane of its own any more. */
  replaceBy(index: number): void {
    const { span, lanes, lane } = this;
    if (span === null || lanes[index] === undefined || index === lane) {
      this.show.say("Select a span of a lane first, then the lane that is to show there.");
      return;
    }
    if (!this.#may(this.locked)) return;
    const [of, by] = [laneKey(lanes, lane), laneKey(lanes, index)];
    this.#change(`Lane ${index + 1} shows from ${clipTime(span.from)} to ${clipTime(span.to)}.`, "replaced span", [
      { type: "replace_span", name: this.name, lane: of, by, start: span.from, stop: span.to },
    ]);
  }

  rename(to: string): void {
    const name = this.name;
    if (to === name || to === "" || !this.#may(this.locked)) return;
    const [undo, redo] = [[{ type: "rename_clip", name: to, to: name }], [{ type: "rename_clip", name, to }]] as const;
    if (
      this.show.act(`${name} is called ${to}; cues that call it are to be changed too.`, {
        what: `name ${to}`,
        undo,
        redo,
      })
    )
      this.choose(to);
  }

  copy(): void {
    const { name } = this;
    if (!this.names.includes(name) || !this.#may(this.locked)) return;
    const to = freeLaneName(
      this.names.map((each) => ({ name: each })),
      `${name.slice(0, 34)} copy`,
    );
    const [undo, redo] = [[{ type: "drop_clip", name: to }], [{ type: "copy_clip", name, to }]] as const;
    if (this.show.act(`${to} is a copy of ${name}.`, { what: `copy of ${name}`, undo, redo })) this.choose(to);
  }

  drop(name = this.name): void {
    if (!this.names.includes(name) || !this.#may(this.locked)) return;
    const [undo, redo] = [[{ type: "restore_clip", name }], [{ type: "drop_clip", name }]] as const;
    if (!this.show.act(`${name} is deleted.`, { what: `deleted clip ${name}`, undo, redo })) return;
    if (name === this.name) this.choose(this.names.find((each) => each !== name) ?? "");
    void this.#sayCallers(name);
  }

  /** Says which cues call a clip that was deleted. */
  async #sayCallers(name: string): Promise<void> {
    const cues = await findCallers(name, Object.keys(this.show.state?.cues?.lists ?? {}), this.request);
    if (cues.length === 0) return;
    const says = `${name} is deleted, and ${cues.join(", ")} ${cues.length === 1 ? "calls" : "call"} it: nothing plays there now.`;
    this.show.say(says, "attention", [{ label: "Undo", act: () => this.show.undo() }]);
  }

  /**
   * A change that no message takes back, the end of a pass too: the clip is laid aside as it is before, and after it
   * once that is taken back. A clip that the change makes is dropped and restored.
   */
  #change(done: string, what: string, changes: readonly Change[], name = this.name): boolean {
    this.#count += 1;
    const [before, after] = ["before", "after"].map((when) => `${when} ${this.page.slice(0, 8)} ${this.#count}`);
    const made = !this.names.includes(name);
    const step: Step = {
      what: `${what} of ${name}`,
      undo: made ? [{ type: "drop_clip", name }] : [...layAside(name, after ?? ""), ...bringBack(name, before ?? "")],
      redo: made
        ? [{ type: "restore_clip", name }]
        : [...layAside(name, before ?? ""), ...bringBack(name, after ?? "")],
    };
    const first: Step = { ...step, redo: [...(made ? [] : layAside(name, before ?? "")), ...changes] };
    if (!this.show.takeStep(first, "redo", () => this.show.history.skip(step))) return false;
    this.show.offerUndo(done, step);
    return true;
  }

  // --- within ---

  /** Whether something is in the way, which is then said. */
  #may(barred: string): boolean {
    if (barred !== "") this.show.say(barred);
    return barred === "";
  }

  /** A server that was started anew has nothing that was laid aside before: what needs it is not taken back. */
  #forgetDropped(epoch: State["epoch"]): void {
    const [before, { history }] = [this.#epoch, this.show];
    this.#epoch = epoch;
    if (before === null || before === epoch) return;
    for (const step of [...history.steps.undo, ...history.steps.redo])
      if ([...step.undo, ...step.redo].some(({ type }) => type === "restore_clip")) history.skip(step);
  }

  #keepMarks(): void {
    const { name: clip, lane, countsIn, passSpeed } = this;
    const [armed, character] = [[...this.armed], this.#chosen];
    if (clip !== "") this.marks.write({ clip, lane, armed, countsIn, passSpeed, character });
  }

  #receiveNames(): void {
    const [first] = this.names;
    const { clip = "", lane = 0 } = this.name === "" ? this.marks.read() : {};
    if (this.names.includes(clip)) {
      this.choose(clip);
      this.lane = lane;
    } else if (this.name === "" && first !== undefined) this.choose(first);
    else void this.#read(false);
    this.tell("clips");
  }

  #relink(): void {
    [this.counting, this.#again] = [null, null];
    if (this.show.online) void this.#read(false);
    this.tell("link");
  }

  /** Reads what is drawn of the shown clip; `from_start`: the place that is marked is its start. */
  async #read(fromStart: boolean): Promise<void> {
    this.#reading += 1;
    const [reading, name] = [this.#reading, this.name];
    try {
      const answer = this.names.includes(name)
        ? await this.request(`/clip_outlines/${encodeURIComponent(name)}`)
        : null;
      if (answer !== null && !answer.ok) throw new Error(await answer.text());
      const outline = answer === null || answer.status === 204 ? null : ((await answer.json()) as ClipOutline);
      if (reading !== this.#reading) return; // another is asked for by now
      this.#show(outline, fromStart);
    } catch {
      if (reading === this.#reading) this.later(() => void this.#read(fromStart), AGAIN_MS);
    }
  }

  #show(outline: ClipOutline | null, fromStart: boolean): void {
    this.outline = outline;
    if (outline !== null) {
      const { start, stop, lanes } = outline;
      this.cursor = fromStart ? start : Math.max(start, Math.min(stop, this.cursor));
      const awaited = this.#awaited === null ? -1 : lanes.findLastIndex(({ name }) => name === this.#awaited);
      if (awaited !== -1) [this.lane, this.#awaited] = [awaited, null];
      this.lane = Math.max(0, Math.min(this.lane, lanes.length - 1));
    } // one that is taken back is gone for a moment, and its lane stays chosen
    this.tell("clips");
  }
}

/** Keeps a clip as it is under another name, for `bringBack`. */
const layAside = (name: string, aside: string): readonly Change[] => [
  { type: "copy_clip", name, to: aside },
  { type: "drop_clip", name: aside },
];

/** Puts what was laid aside in the place of a clip. */
const bringBack = (name: string, aside: string): readonly Change[] => [
  { type: "drop_clip", name },
  { type: "restore_clip", name: aside },
  { type: "rename_clip", name: aside, to: name },
];
