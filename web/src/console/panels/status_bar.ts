/** The status bar: stages, link, notices and panic. */

import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { levelsOf } from "../../face/quality/quality_levels";
import type { StageReport } from "../../link/messages";
import type { ShowNotices } from "../../ui/show_notices";
import { base } from "../../ui/theme";
import { passesOf } from "../clips/clip_passes";
import { ConsoleElement } from "../controls/console_element";
import { UPRIGHT } from "../controls/screen_sizes";
import type { Topic } from "../store/page_store";
import { secondsLabel } from "../store/timing";
import { HEARD_MS } from "../store/unheard_panic";
import type { CueLine } from "./cue_line";
import { offersStyle, viewOffers } from "./offers";
import { passNotices, saidNow } from "./said";
import "../clips/record_light";
import "./cue_line";
import "./import_progress";
import "./name_field";
import "./note_line";
import "./show_clock";
import { changeBus } from "./preview_bar";
import { style } from "./status_bar_style";

/** Stages that draw fewer frames a second than this are worth a look. */
const SLOW = 30;

/** Where what must be read of the show has its place beside what this console says, as the style has it. */
const ROOMY = matchMedia("(min-width: 1101px)");

/** Where words have no room in the bar. */
const CROWDED = matchMedia(UPRIGHT);

/** The head of the page: the link, the crew, what must be read, the help and panic. Tells `said`. */
@customElement("omote-status")
export class StatusBar extends ConsoleElement {
  @property({ attribute: false }) notices!: ShowNotices;
  /** Its person may only look. */
  @property({ type: Boolean }) restricted = false;
  @state() private panicked = false;
  #timers: {
    panic?: ReturnType<typeof setTimeout>;
    late?: ReturnType<typeof setTimeout>;
  } = {};
  #leave: (() => void)[] = [];
  @query(".messages") private messages!: HTMLElement;
  @query("omote-cue-line") private cues!: CueLine;
  readonly #room = new ResizeObserver(() => this.#askRoom());
  #era = 0;

  static override styles = [base, style, offersStyle];

  protected override readonly topics: readonly Topic[] = [
    "manifest",
    "characters",
    "clip_work",
    "crew",
    "leases",
    "link",
    "naming",
    "notice",
    "panic",
  ];

  constructor() {
    super();
    passNotices(
      this,
      () => this.store,
      (offers) => ROOMY.matches && offers.some((offer) => "address" in offer),
    );
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#leave = [
      this.store.listen("panic", () => {
        const { era } = this.store;
        clearTimeout(this.#timers.late);
        this.#timers.late = setTimeout(() => this.requestUpdate(), HEARD_MS);
        if (era === this.#era || !this.store.online) return; // nothing was sent, so nothing lights up
        this.#era = era;
        this.panicked = true;
        clearTimeout(this.#timers.panic);
        this.#timers.panic = setTimeout(() => {
          this.panicked = false;
        }, 400);
      }),
    ];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const leave of this.#leave) leave();
    this.#room.disconnect();
    clearTimeout(this.#timers.panic);
    clearTimeout(this.#timers.late);
  }

  protected override firstUpdated(): void {
    this.#room.observe(this.messages);
  }

  /** GO of the cues. */
  go(): void {
    this.cues.go();
  }

  /** Tells how many pixels of the picture the words need that the bar has no room for. */
  #askRoom(): void {
    const height = CROWDED.matches ? this.messages.offsetHeight : 0;
    this.dispatchEvent(new CustomEvent("said", { detail: height === 0 ? 0 : height + 4 }));
  }

  /** What is to be answered has the room of what is to be watched. */
  protected override updated(): void {
    this.toggleAttribute("asks", saidNow(this.context).offers.length > 0);
    this.toggleAttribute("records", passesOf(this.store).length > 0);
  }

  override render() {
    const unread = this.notices.open.length;
    const { text, tone, offers, dismiss } = saidNow(this.context);
    const none = text === null && this.context.items.naming === null; // the field for a name stands there too
    return html`
      <div class="mark">OMOTE</div>
      <omote-record-light .context=${this.context}></omote-record-light>
      <omote-show-clock .context=${this.context}></omote-show-clock>
      ${this.store.online ? this.#crew() : html`<div class="lost" role="alert">LINK LOST – nothing is sent</div>`}
      <div class="messages">
        <omote-import-progress .context=${this.context}></omote-import-progress>
        <div class="notice ${tone} ${none ? "none" : ""}" role="status">
          <span title=${text ?? ""}>${text ?? ""}</span>
          <omote-name-field .context=${this.context}></omote-name-field>
          <span class="offers">${viewOffers(offers, dismiss)}</span>
        </div>
        ${none ? html`<omote-note .context=${this.context}></omote-note>` : nothing}
      </div>
      <omote-cue-line .context=${this.context} .restricted=${this.restricted}></omote-cue-line>
      <slot name="seat"></slot>
      ${this.#steps()}
      <button class="log ${unread > 0 ? "unread" : ""}" title="What was said, and what can be taken back"
        @click=${() => this.tell("log")}>Log${unread > 0 ? html` <b>${unread}</b>` : nothing}</button>
      ${this.store.bus === "air" ? html`<button class="bus" title="Build a look up that shows nowhere until it is taken (Shift P)" @click=${() => changeBus(this.store)}>Preview</button>` : nothing}
      <button class="moments" title="Mark this moment of the recording, or keep what was played (Shift K)" @click=${() => this.tell("moments")}>Mark</button>
      <button class="learn" title="Bind controls of devices: touch a control here, move one there (Z)"
        @click=${() => this.tell("learn")}>Learn</button>
      <button class="setup" title="Home face and layouts" @click=${() => this.tell("setup")}>Set-up</button>
      <button class="help" title="Keys" aria-label="Keys" @click=${() => this.tell("help")}>?</button>
      ${this.#panic()}
    `;
  }

  /** What the keys of every program do, for a hand without a keyboard. */
  #steps() {
    const { history } = this.store;
    const [undo, redo] = [history.next("undo"), history.next("redo")];
    return html`<button class="step" aria-label="Undo" title="Undo${undo === null ? "" : `: ${undo.what}`} (Ctrl Z)"
        ?disabled=${undo === null} @click=${() => this.store.undo()}>↶</button>
      <button class="step redo" aria-label="Redo" title="Redo${redo === null ? "" : `: ${redo.what}`} (Ctrl Y)"
        ?disabled=${redo === null} @click=${() => this.store.redo()}>↷</button>`;
  }

  /** Says what it does now: the first press holds the face, the second brings the home face. */
  #panic() {
    const { air: state, online, panicIsLate } = this.store;
    if (this.restricted) return this.#panicButton("PANIC", "not by this role", "unheard");
    if (!online) return html`${this.#panicOfAll()}${this.#panicButton("PANIC", "NOT HEARD: no link", "unheard")}`;
    if (panicIsLate) return html`${this.#panicOfAll()}${this.#panicButton("PANIC", "NOT HEARD", "unheard")}`;
    const again = state?.home_next === true;
    const way = again ? (state.home_seconds === 0 ? "cut" : `in ${secondsLabel(state.home_seconds)} s`) : "";
    const [title, says] = again
      ? ["HOME FACE", `${this.store.label("face", state.home_face)} ${way}`]
      : ["PANIC", "neutral, hold still"];
    return html`${this.#panicOfAll()}${this.#panicButton(title, says, again ? "again" : "")}`;
  }

  #panicButton(title: string, says: string, kind: "" | "again" | "unheard") {
    return html`<button class="panic ${this.panicked ? "done" : ""} ${kind}"
      title="${kind === "again" ? "Panic again" : "Panic"} (Shift Backspace)"
      @pointerdown=${this.#press} @click=${this.#click}>
      ${title}<small>${says}<i> · ⇧⌫</i></small>
    </button>`;
  }

  /** Where some characters are played elsewhere: panic of all, left of the one that never moves. */
  #panicOfAll() {
    const { state, played } = this.store;
    if (state === null || played.names.length === Object.keys(state.characters).length) return nothing;
    return html`<button class="panic all" aria-label="Panic of all characters" title="Panic of all characters (Ctrl Shift Backspace)"
      @pointerdown=${(event: PointerEvent) => event.button === 0 && this.store.panic(true)}
      @click=${(event: MouseEvent) => event.detail === 0 && this.store.panic(true)}>ALL</button>`;
  }

  /** On the way down, not on release: panic does not wait for the finger to lift. */
  #press(event: PointerEvent): void {
    if (event.button === 0) this.store.panic(event.shiftKey);
  }

  #click(event: MouseEvent): void {
    if (event.detail === 0) this.store.panic(); // by keyboard; a pointer has been heard on its way down
  }

  #crew() {
    const { crew, latency } = this.store;
    const stages = crew?.stages ?? [];
    return html`
      <div class="item link"><span class="lamp"></span><b>live</b> <span class="trip">${latency === null ? nothing : tripLabel(latency)}</span></div>
      <div class="item stages ${crew !== null && stages.length === 0 ? "slow" : ""}">
        <b title=${stages.length === 1 ? "stage" : "stages"}>${stages.length}</b> <span class="word">${stages.length === 1 ? "stage" : "stages"}</span>
        ${stages.slice(0, 9).map((stage) => html`<b class=${stage === null || stage.fps < SLOW ? "slow" : ""} title=${stageTitle(stage)}>${stageRate(stage)}</b>`)}
        ${stages.map((stage, place) => darkNotice(stage, place))}
        ${crew?.lost ? html`<b class="slow" title="The link broke while the page was open, and has not come back">${crew.lost} lost</b>` : nothing}
        ${stages.length > 0 ? "fps" : nothing} <span class="level" title="quality">${levelsOf(stages)}</span>
      </div>
      <div class="item consoles"><b>${crew?.consoles ?? 0}</b> ${crew?.consoles === 1 ? "console" : "consoles"}</div>
    `;
  }
}

/** Milliseconds there and back, in as many letters on a machine that is late: PANIC beside it keeps its place. */
function tripLabel(latency: number): string {
  if (latency >= 999.5) return `${(latency / 1000).toFixed(1)} s`;
  return `${latency < 9.95 ? latency.toFixed(1) : latency.toFixed(0)} ms`;
}

/** What a stage draws a second, in a few letters. */
function stageRate(stage: StageReport | null): string {
  if (stage === null) return "–";
  return stage.fps < 1 ? stage.fps.toFixed(1) : String(Math.round(stage.fps));
}

const stageTitle = (stage: StageReport | null): string =>
  stage === null ? "silent" : `${stage.name}${stage.name === "" ? "" : ": "}${stage.level}`;

/** Which stage draws nothing, and for how long: nobody at a console sees its screen. */
function darkNotice(stage: StageReport | null, place: number) {
  if (stage === null || stage.dark < 1) return nothing;
  const which = stage.name === "" ? `stage ${place + 1}` : `stage ${stage.name}`;
  return html`<b class="slow dark" role="alert" title="Its browser has lost the graphics; it tries a new picture, then loads the page anew">${which} is dark, ${Math.round(stage.dark)} s</b>`;
}
