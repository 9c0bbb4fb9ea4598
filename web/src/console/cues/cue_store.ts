/** What a page of cues knows of their lists, and what it may do with them. Nothing here touches the page. */

import { missingRole } from "../../access/page_access";
import type {
  AccessDocument,
  Cue,
  CueListDocument,
  CueListStatus,
  CueName,
  CueStatus,
  PadState,
  State,
} from "../../link/messages";
import { TopicStore } from "../../link/topics";
import type { ConsoleStore } from "../store/console_store";
import type { Asked } from "../store/requests";
import { standbyBeside } from "./cue_order";
import { movedWords, titleWords } from "./cue_words";
import { LocalEdits } from "./local_edits";
import type { KnownNames } from "./missing_names";

/** `cues`: who stands where; `time`: what counts, ten times a second; `list`: the cues; `view`: what this page shows. */
export type CueTopic = "cues" | "time" | "list" | "view" | "link" | "notice" | "manifest" | "characters";

const NOT_PLAYED: CueListStatus = {
  current: null,
  standby: null,
  waits: [],
  moving: [],
  follows: null,
  follows_in: 0,
  since: null,
  by: "",
  pressed: "",
};
const NO_CUES: CueStatus = {
  chosen: "main",
  lists: { main: NOT_PLAYED },
  rate: 1,
  edits: 0,
  undo: "",
  redo: "",
  ignored: "",
  ignored_count: 0,
  rejected: [],
  locked: false,
};
/** Milliseconds for which a standby that was chosen here is shown before the show has answered. */
const WANTED_MS = 1000;
/** Milliseconds for which an ignored GO stays in sight. */
const IGNORED_MS = 12_000;
/** Milliseconds for which a link that is back is news. */
const BACK_MS = 6000;
const NONE_STANDS_BY = "No cue stands by: choose one, or press Back.";
const NO_CUES_YET = "No cues yet: press Edit, then New or Record.";
/** Milliseconds until a list is asked for again that could not be read. */
const AGAIN_MS = 500;

const TIMES: ReadonlySet<string> = new Set(["seconds", "since", "follows_in"]);

/** What of a status is shown: all but what counts, or with `times` that too, in tenths of seconds. */
const keyOf = (status: CueStatus, times: boolean): string =>
  JSON.stringify(status, (name, value) => {
    if (name === "rate") return value === 1;
    if (!TIMES.has(name)) return value;
    return times ? value && Math.round(value * 10) : value === null;
  });

export class CueStore extends TopicStore<CueTopic> {
  status: CueStatus = NO_CUES;
  /** The list that this page shows, and plays. */
  name = NO_CUES.chosen;
  /** Its cues, in the order of GO. */
  list: readonly Cue[] = [];
  /** Cues are edited here, where that is allowed. */
  editing = false;
  /** The cue that is edited, by identity. */
  edited: string | null = null;
  search = "";
  /** Keys play although cues are edited here. */
  keysPlay = false;
  /** A field has the focus: keys are its own. */
  typing = false;
  /** An empty cue that has just come, by identity: the cursor goes into its label. */
  begun: string | null = null;
  /** A panic that has taken off what the cues have left standing; "" for none, or once a cue has been called since. */
  panicked = "";
  /** An ignored GO that is still in sight; "" for none. */
  ignored = "";
  access: AccessDocument = { role: "admin", name: "", asked: false };
  #shown = { cues: "", time: "" };
  /** What `list` is. */
  #read = "";
  #reading = false;
  readonly #local = new LocalEdits();
  #wanted: { readonly identity: string; readonly until: number } | null = null;
  #ignoredCount: number | null = null;
  #ignoredUntil = 0;
  /** The cue that stood by, and its number, when a GO was ignored. */
  #ignoredAt = "";
  #panics: Readonly<Record<string, number>> = {};
  /** This page pressed panic, and no state has said so yet. */
  #pressed = false;
  /** What stood when somebody pressed panic: another GO or assert ends that. */
  #panickedAt = "";
  /** A notice of this page is true until then, in milliseconds, or for as long as no cue stands by. */
  #said = { notice: "", until: 0 };
  /** What is recorded, copied or begun here is edited once it is there. */
  #expects: "" | "filled" | "empty" = "";

  #resumes: string | null = null;
  #came: (cue: Cue) => void = () => undefined;

  /** `asked`: the list that is to be shown, "" for the chosen one; `now`: milliseconds. */
  constructor(
    readonly show: ConsoleStore,
    private asked = "",
    private readonly now: () => number = () => performance.now(),
    private readonly request: typeof fetch = (...of) => fetch(...of),
    private readonly later: (act: () => void) => unknown = (act) => setTimeout(act, AGAIN_MS),
  ) {
    super();
    show.hear("state", (state) => this.#receive(state));
    show.listen("link", () => this.#noteLink());
    for (const topic of ["link", "notice", "manifest", "characters"] as const)
      show.listen(topic, () => this.tell(topic));
    for (const topic of ["clips", "pad_list"] as const) show.listen(topic, () => this.tell("manifest"));
  }

  // --- what shows ---

  get names(): readonly string[] {
    return Object.keys(this.status.lists);
  }

  /** How far the shown list is. */
  get way(): CueListStatus {
    return this.status.lists[this.name] ?? NOT_PLAYED;
  }

  get current(): Cue | null {
    return this.find(this.way.current?.identity ?? null);
  }

  /** The cue that GO calls: as the show has it, or as was chosen here a moment ago. */
  get standby(): CueName | null {
    return this.#wanted === null ? this.way.standby : this.find(this.#wanted.identity);
  }

  get paused(): boolean {
    return this.status.rate !== 1;
  }

  find(identity: string | null): Cue | null {
    return this.list.find((cue) => cue.identity === identity) ?? null;
  }

  /** A cue with what was sent of it and is not in the list yet: another edit begins from there. */
  newest(cue: Cue): Cue {
    return this.#local.over(this.find(cue.identity) ?? cue, this.now());
  }

  /** What a cue is called, also one without a label. */
  titleOf({ identity, label }: CueName): string {
    return titleWords(this.find(identity) ?? { label, moves: {}, actions: [] }, this.labels);
  }

  /** A part that the cue of a number moves, in words. */
  partOf(number: string, part: string): string {
    const cue = this.list.find((each) => each.number === number);
    return movedWords(part, cue?.moves[part]?.goal, this.labels);
  }

  /** What people call each character. */
  get labels(): Readonly<Record<string, string>> {
    const characters = Object.entries(this.show.state?.characters ?? {});
    return Object.fromEntries(characters.map(([name, { label }]) => [name, label]));
  }

  /** The names of the clips of the show. */
  get clips(): readonly string[] {
    return this.show.newest("clips")?.names ?? [];
  }

  /** The pads of the show; null until they are here. */
  get pads(): readonly PadState[] | null {
    return this.show.newest("pad_list")?.pads ?? null;
  }

  /** The names that cues can call now; null until the cast and the pads are here. */
  get known(): KnownNames | null {
    const { faces, expressions, lights, state } = this.show;
    const { pads } = this;
    if (faces.length === 0 || state === null || pads === null) return null;
    const names = (documents: readonly { name: string }[]) => new Set(documents.map(({ name }) => name));
    return {
      face: names(faces),
      expression: names(expressions),
      light: names(lights),
      clip: new Set(this.clips),
      character: new Set(Object.keys(state.characters)),
      "gaze point": new Set(Object.keys(state.gaze_points)),
      pad: names(pads),
    };
  }

  /** Why nobody would hear a GO of this page; "" where the show hears it. */
  get unheard(): string {
    if (!this.show.online) return "Link lost: the show does not hear this page.";
    return missingRole(this.access, "operate", "playing cues") ?? "";
  }

  /** Why this page edits no cue; "" where it may. */
  get locked(): string {
    if (this.status.locked) return "Show mode: cues are locked, and nobody edits them.";
    return missingRole(this.access, "edit", "editing cues") ?? "";
  }

  get mayLock(): boolean {
    return missingRole(this.access, "admin", "the show mode") === null;
  }

  setAccess(access: AccessDocument): void {
    this.access = access;
    this.tell("view");
  }

  /** Shows another list. */
  choose(name: string): void {
    this.name = name;
    [this.edited, this.#wanted, this.#expects] = [null, null, ""];
    this.list = [];
    this.tell("view");
    void this.#readList();
  }

  /** Edits, or plays. */
  setEditing(on: boolean): void {
    if (on && this.locked !== "") this.show.say(this.locked);
    this.editing = on && this.locked === "";
    this.keysPlay = false;
    if (this.editing) this.edited ??= this.standby?.identity ?? this.way.current?.identity ?? null;
    this.tell("view");
  }

  /** Lets keys play while cues are edited, until a field is entered. */
  letKeysPlay(on: boolean): void {
    this.keysPlay = on;
    this.tell("view");
  }

  /** Takes note of whether a field has the focus. */
  setTyping(on: boolean): void {
    if (on === this.typing) return;
    this.typing = on;
    if (on) this.keysPlay = false;
    this.tell("view");
  }

  /** Edits again where a page before this one did, once the list is there; null: it played. */
  resume(edited: string | null): void {
    this.#resumes = edited;
  }

  edit(identity: string | null): void {
    this.edited = identity;
    this.tell("view");
  }

  searchFor(text: string): void {
    this.search = text;
    this.tell("view");
  }

  // --- what plays ---

  /** GO: the cue that stands by here; where another one does by now, nothing is called. */
  go(): void {
    const seen = this.standby?.identity ?? "";
    if (seen === "" && !this.paused) this.#sayWhile(this.list.length === 0 ? NO_CUES_YET : NONE_STANDS_BY);
    else this.play({ type: "go", seen, cue_list: this.name });
  }

  back(): void {
    this.play({ type: "go_back", cue_list: this.name });
  }

  pause(): void {
    this.play({ type: "pause_cues", on: !this.paused });
  }

  assertLook(): void {
    if (this.play({ type: "assert_look", cue_list: this.name })) this.forgetPanic();
  }

  /** Panic of all characters: this page plays none of them alone. */
  panic(): void {
    this.#pressed = true;
    this.show.panic(true);
  }

  /** The look has been brought back, or somebody has read that it is gone. */
  forgetPanic(): void {
    this.panicked = "";
    this.tell("cues");
  }

  /** Shows a cue in preview as it will stand; nothing moves on air. */
  lookAt(number: string): void {
    if (!this.play({ type: "preview_cue", cue: number, cue_list: this.name })) return;
    const console = { label: "Console in preview", address: "/console?bus=preview", tab: "omote-preview" };
    this.show.say(`Cue ${number} is in preview: change it at the console there, and update it there.`, "done", [
      console,
    ]);
  }

  /** Has a cue stand by; nothing moves. */
  setStandby({ identity, number }: Pick<Cue, "identity" | "number">): void {
    if (!this.play({ type: "set_standby", cue: number, cue_list: this.name })) return;
    this.#wanted = { identity, until: this.now() + WANTED_MS };
    this.tell("cues");
  }

  /** Has the cue before or behind stand by. */
  stepStandby(way: -1 | 1): void {
    const cue = standbyBeside(this.list, this.standby?.identity ?? null, way);
    if (cue !== null) this.setStandby(cue);
  }

  /** Asks for something of who plays; whether it was sent. `failed`: is told why it was not done. */
  play(asked: Asked, failed?: (reason: string) => void): boolean {
    return this.#ask(this.unheard, asked, failed);
  }

  // --- what edits ---

  /** Asks for an edit; `failed` is told why it was not made, without it the page is. */
  change(asked: Asked, failed?: (reason: string) => void): boolean {
    const say = failed ?? ((reason: string) => this.show.say(reason));
    let forget = (): void => undefined;
    const sent = this.#ask(this.locked, asked, (reason) => {
      forget();
      say(reason);
    });
    if (sent) forget = this.#local.add(asked, this.now());
    return sent;
  }

  /** The same, and what is new by it is edited next; `came` is told once it is there. */
  add(asked: Asked, failed?: (reason: string) => void, came = (): void => undefined): void {
    const sent = this.change(asked, (reason) => {
      this.#expects = "";
      if (failed === undefined) this.show.say(reason);
      else failed(reason);
    });
    if (!sent) return;
    this.#expects = "filled";
    this.#came = (cue) => {
      came();
      if (asked.type !== "record_cue" || Object.keys(cue.moves).length > 0) return;
      this.show.say(
        `Cue ${cue.number} is empty: all stands as the cues before it leave it. Tick whose look it is to have.`,
      );
    };
  }

  /** Begins an empty cue behind the one that is edited. Until it is there no other takes what is typed. */
  begin(): void {
    const after = this.edited ?? "";
    this.add({ type: "put_cue", number: "", after, cue_list: this.name });
    if (this.#expects === "") return;
    this.#expects = "empty";
    this.edit(null);
  }

  /** Takes in a list as text (TOML) in the place of the shown one; what is wrong in it, each with its line, "" for nothing. */
  async takeIn(text: string): Promise<string> {
    if (this.locked !== "") return this.locked;
    try {
      const answer = await this.request(this.#address(this.name), { method: "POST", body: text });
      return answer.ok ? "" : (await answer.text()) || `The show did not take it in (${answer.status}).`;
    } catch {
      return "Not sent: the link to the show is lost.";
    }
  }

  #address(name: string): string {
    return `/cue_lists/${encodeURIComponent(name)}`;
  }

  undo(way: "undo" | "redo"): void {
    if (this.status[way] === "")
      this.show.say(way === "undo" ? "No edit of cues to undo." : "No edit of cues to do again.");
    else this.change({ type: `${way}_cues`, seen: this.status.edits });
  }

  renameList(to: string, failed: (reason: string) => void): void {
    if (this.change({ type: "rename_cue_list", cue_list: this.name, to }, failed)) this.asked = to;
  }

  addList(name: string, failed: (reason: string) => void): void {
    if (this.change({ type: "add_cue_list", cue_list: name }, failed)) this.asked = name;
  }

  #ask(barred: string, asked: Asked, failed?: (reason: string) => void): boolean {
    const refused = failed && {
      refused: ({ reason }: { reason: string }): true => {
        failed(reason);
        return true;
      },
    };
    const sent = barred === "" && this.show.ask(asked, refused ?? {});
    if (sent) return true;
    const why = barred || "Not sent: the link to the show is lost.";
    if (failed === undefined) this.show.say(why);
    else failed(why);
    return false;
  }

  // --- what comes ---

  #receive(state: State): void {
    this.status = state.cues ?? NO_CUES;
    this.#follow();
    this.#noteIgnored();
    this.#notePanic(state);
    this.#endNotice();
    const [cues, time] = [keyOf(this.status, false), keyOf(this.status, true)];
    const before = this.#shown;
    this.#shown = { cues, time };
    if (before.cues !== cues) {
      if (this.editing && this.locked !== "") this.setEditing(false);
      this.tell("cues");
    }
    if (before.time !== time) this.tell("time");
    void this.#readList();
  }

  /** Shows the list that was asked for once it is there, and the chosen one where the shown one has gone. */
  #follow(): void {
    const { lists, chosen } = this.status;
    if (this.asked in lists) {
      const name = this.asked;
      this.asked = "";
      if (name !== this.name) this.choose(name);
    } else if (!(this.name in lists)) this.choose(chosen);
    const wanted = this.#wanted;
    if (wanted === null) return;
    if (
      this.way.standby?.identity === wanted.identity ||
      this.now() > wanted.until ||
      this.find(wanted.identity) === null
    ) {
      this.#wanted = null;
      this.tell("cues");
    }
  }

  /** One that was ignored before this page came is no news. */
  #noteIgnored(): void {
    const { ignored, ignored_count: count } = this.status;
    const news = this.#ignoredCount !== null && count > this.#ignoredCount;
    this.#ignoredCount = count;
    const stands = `${this.way.standby?.identity} ${this.way.standby?.number}`;
    if (news) [this.#ignoredUntil, this.#ignoredAt] = [this.now() + IGNORED_MS, stands];
    const shown = this.now() < this.#ignoredUntil && stands === this.#ignoredAt ? ignored : "";
    if (news) this.show.log(ignored, "attention");
    if (shown === this.ignored) return;
    this.ignored = shown;
    this.tell("cues");
  }

  /** Says whose look a panic has taken off, until a cue is called again. */
  #notePanic({ characters }: State): void {
    const before = this.#panics;
    this.#panics = Object.fromEntries(Object.entries(characters).map(([name, { panics }]) => [name, panics]));
    const hit = Object.keys(this.#panics).filter((name) => (this.#panics[name] ?? 0) > (before[name] ?? Infinity));
    const stands = `${this.way.current?.identity} ${this.way.since === null}`;
    if (hit.length > 0) {
      const whose =
        hit.length === Object.keys(characters).length
          ? "of all"
          : hit.map((name) => this.labels[name] || name).join(", ");
      const look =
        this.way.current === null
          ? ""
          : ` The look of cue ${this.way.current.number} is off: Assert (A) brings it back.`;
      this.panicked = `PANIC ${whose}, pressed ${this.#pressed ? "here" : "at another page"}.${look}`;
      this.#panickedAt = stands;
      this.#pressed = false;
      this.show.log(this.panicked, "attention");
      this.tell("cues");
    } else if (this.panicked !== "" && stands !== this.#panickedAt) this.forgetPanic();
  }

  /** Says what is true for as long as no cue stands by, or for a time. */
  #sayWhile(notice: string, milliseconds = Infinity): void {
    this.#said = { notice, until: this.now() + milliseconds };
    this.show.say(notice);
  }

  /** That the link is back is news for some seconds. */
  #noteLink(): void {
    const { notice, tone } = this.show;
    if (this.show.online && notice !== null && tone === "done") this.#said = { notice, until: this.now() + BACK_MS };
  }

  /** A notice that is not true any more is taken away, where no other has taken its place. */
  #endNotice(): void {
    const { notice, until } = this.#said;
    if (notice === "" || (this.now() < until && (until !== Infinity || this.way.standby === null))) return;
    this.#said = { notice: "", until: 0 };
    if (this.show.notice === notice) this.show.say(null);
  }

  /** Reads the cues of the shown list where they have been edited since. */
  async #readList(): Promise<void> {
    const [wanted, { name }] = [this.#wantedKey, this];
    if (this.#reading || wanted === this.#read || this.show.state === null) return;
    this.#reading = true;
    const document = await this.#fetch(name);
    this.#reading = false;
    if (document === null) this.later(() => void this.#readList());
    else {
      if (name === this.name) this.#take(document, wanted);
      void this.#readList(); // another list is shown by now, or it was edited again
    }
  }

  get #wantedKey(): string {
    return `${this.show.state?.epoch} ${this.status.edits} ${this.name}`;
  }

  /** Null where it cannot be read; a list that has gone has no cue. */
  async #fetch(name: string): Promise<CueListDocument | null> {
    try {
      const answer = await this.request(this.#address(name), { cache: "no-store" });
      if (answer.status === 204) return { edits: this.status.edits, cues: [] };
      return answer.ok ? ((await answer.json()) as CueListDocument) : null;
    } catch {
      return null;
    }
  }

  #take({ cues }: CueListDocument, wanted: string): void {
    const known = new Set(this.list.map(({ identity }) => identity));
    const fresh = cues.find(({ identity }) => !known.has(identity));
    this.list = cues;
    this.#local.settle(cues, this.now());
    this.#read = wanted;
    if (this.#expects !== "" && fresh !== undefined) {
      if (this.editing) this.edited = fresh.identity;
      if (this.editing && this.#expects === "empty") this.begun = fresh.identity;
      this.#expects = "";
      this.#came(fresh);
    }
    if (this.#resumes !== null) {
      this.setEditing(true);
      if (this.find(this.#resumes) !== null) this.edited = this.#resumes;
      this.#resumes = null;
    }
    if (this.find(this.edited) === null) this.edited = null;
    this.tell("list");
  }
}
