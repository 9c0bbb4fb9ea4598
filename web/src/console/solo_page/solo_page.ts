/** The page for one person alone: two pads, the face, keys for looks and lines, and what comes next. */

import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Library } from "../../link/assets";
import { pressed } from "../../ui/gestures";
import { hasFieldFocus, listenToKeys } from "../../ui/key_presses";
import { base, palette } from "../../ui/theme";
import { hearWhileShown, textOf, whileShown } from "../../ui/topic_element";
import { clipsFound, pressClip } from "../clips/clip_tiles";
import { ConsoleElement } from "../controls/console_element";
import type { CueStore } from "../cues/cue_store";
import type { BlendPad } from "../pads/blend_pad";
import { padsOf } from "../pads/pad_commands";
import type { Monitor } from "../panels/monitor";
import { offersStyle, viewOffers } from "../panels/offers";
import { passNotices, saidNow } from "../panels/said";
import type { MemoryRow } from "../scene/memory_row";
import { SOLO_PARTS, type SoloPart } from "../store/arrangement";
import { isPanic, stepOf } from "../store/keys";
import type { Topic } from "../store/page_store";
import { toggleStill } from "../store/stillness";
import { HEARD_MS } from "../store/unheard_panic";
import { NO_PLACES, placesAfter, withChosen } from "./pad_places";
import { SOLO_KEYS, type SoloCommand, soloCommandOf } from "./solo_keys";
import { soloPageStyle } from "./solo_page_style";
import "../clips/clip_tiles";
import "../clips/record_light";
import "../controls/pad";
import "../learn/binding_marks";
import "../learn/learn_mode";
import "../leases/lease_marks";
import "../pads/blend_pad";
import "../panels/monitor";
import "../scene/memory_row";
import "../../ui/keys_help";
import "./black_key";
import "./liveliness";
import "./next_cue";
import "./source_line";

const PART_LABELS: Readonly<Record<SoloPart, string>> = {
  looks: "Looks: keys of memories",
  lines: "Lines: clips of the show",
  head: "Pad of the head",
};
const ROW_LABELS: Readonly<Record<SoloPart, string>> = { looks: "Looks", lines: "Lines", head: "Head" };
const SIDES = ["left", "right"] as const;

@customElement("omote-solo")
export class SoloPage extends ConsoleElement {
  @property({ attribute: false }) cues!: CueStore;
  @state() private help = false;
  @state() private learning = false;
  /** What the page shows is chosen. */
  @state() private choosing = false;
  /** What was chosen to stand below the face, where one part has room there. */
  @state() private row: SoloPart = "looks";
  @query("omote-monitor") private monitor!: Monitor;
  @query("omote-memories") private memories!: MemoryRow | null;
  #places = NO_PLACES;

  static override styles = [palette, base, offersStyle, soloPageStyle];

  protected override readonly topics: readonly Topic[] = [
    "link",
    "black",
    "call",
    "notice",
    "arrangement",
    "characters",
    "manifest",
    "pad_list",
    "panic",
    "undo",
  ];

  constructor() {
    super();
    passNotices(this, () => this.store);
    whileShown(this, () => listenToKeys({ everywhere: this.#keyEverywhere, page: this.#key }));
    hearWhileShown<KeyboardEvent>(this, window, ["keyup"], this.#spaceUp, true);
    const noteFocus = (): void => this.cues.setTyping(hasFieldFocus());
    hearWhileShown(this, window, ["focusin", "focusout", "keyup", "pointerup"], noteFocus);
    hearWhileShown<PointerEvent>(this, window, ["pointerdown"], this.#pressElsewhere, true);
  }

  /** A panic that nobody hears is said after a while. */
  protected override changed(topic: Topic): void {
    super.changed(topic);
    if (topic === "panic") setTimeout(() => this.requestUpdate(), HEARD_MS);
  }

  /** Gives the picture the cast to draw. */
  async open(library: Library): Promise<void> {
    await this.updateComplete;
    await this.monitor.open(library);
  }

  /** Lets hands off everything, where this page may only look. */
  restrict(sentence: string | null): void {
    this.classList.toggle("view-only", sentence !== null);
    if (sentence !== null) this.store.say(sentence);
  }

  override render() {
    const { context, store } = this;
    const { solo } = store.arrangement;
    this.classList.toggle("lost", !store.online);
    this.classList.toggle("preview", store.bus === "preview");
    for (const part of SOLO_PARTS) this.toggleAttribute(part, solo[part]);
    this.dataset.row = this.#row ?? "";
    return html`${this.#header()}
      ${solo.lines ? html`<section class="lines panel live" aria-label="Lines"><omote-clip-tiles .context=${context}></omote-clip-tiles></section>` : nothing}
      <section class="face panel" aria-label="On air"><omote-monitor bare .context=${context}></omote-monitor></section>
      <omote-next-cue class="panel live" .cues=${this.cues}></omote-next-cue>
      ${SIDES.map((side, at) => this.#pad(side, at))}
      ${solo.head ? html`<omote-pad low class="head panel live" .context=${context} .what=${"head"}></omote-pad>` : nothing}
      ${solo.looks ? html`<omote-memories class="panel live" .context=${context}></omote-memories>` : nothing}
      <omote-lease-marks .context=${context} .page=${this.renderRoot}></omote-lease-marks>
      <omote-binding-marks .context=${context} .page=${this.renderRoot}></omote-binding-marks>
      ${this.help ? html`<omote-keys-help .keys=${SOLO_KEYS} @close=${() => (this.help = false)}></omote-keys-help>` : nothing}`;
  }

  #header() {
    const { store } = this;
    const panic = pressed(() => store.panic());
    const { text, tone, offers, dismiss } = saidNow(this.context);
    return html`<header><div class="bar panel"><h1>SOLO</h1>
        ${this.#characters()}<span class="air ${store.goesBlack ? "black" : ""}">${this.#airWords}</span>
        <omote-source-line .context=${this.context}></omote-source-line>
        <omote-record-light .context=${this.context}></omote-record-light>
        ${store.online ? nothing : html`<span class="lost-link" role="alert">LINK LOST</span>`}
        <span class="notice ${tone} ${text === null ? "none" : ""}" role="status"><span title=${text ?? ""}>${text ?? ""}</span>${viewOffers(offers, dismiss)}</span>
        ${this.#rows()}
        <omote-liveliness class="live" .context=${this.context}></omote-liveliness>
        <omote-black-key class="live" .context=${this.context}></omote-black-key>
        <button class="show" aria-expanded=${this.choosing} title="What this page shows" @click=${() => (this.choosing = !this.choosing)}>Show ▾</button>
        <button class="help" aria-label="Keys" title="Keys (?)" @click=${() => (this.help = true)}>?</button>
        ${this.choosing ? this.#choice() : nothing}
      </div><button class="panic live ${store.air?.home_next ? "again" : ""}" title="${store.air?.home_next ? "Panic again: the home face" : "Panic"} (Shift Backspace)" @pointerdown=${panic.down} @click=${panic.click}>${this.#panicWord}</button>
      ${this.learning ? html`<omote-learn-mode inline .context=${this.context} .page=${this.renderRoot} @close=${this.#learn} @devices=${this.#openDevices}></omote-learn-mode>` : nothing}</header>`;
  }

  /** What panic does now: its second press brings the home face, and one that nobody has heard says so. */
  get #panicWord(): string {
    const { online, panicIsLate, air } = this.store;
    if (!online || panicIsLate) return "NOT HEARD";
    return air?.home_next ? "HOME FACE" : "PANIC";
  }

  /** What is shown below the face of a phone on its side, where there is room for one: looks, lines or the head. */
  #rows() {
    const chosen = SOLO_PARTS.filter((part) => this.store.arrangement.solo[part]);
    return html`<span class="rows" role="group" aria-label="Below the face">${chosen.map(
      (part) => html`<button data-row=${part} aria-pressed=${part === this.#row} title=${PART_LABELS[part]}
        @click=${() => (this.row = part)}>${ROW_LABELS[part]}</button>`,
    )}</span>`;
  }

  /** The part that is shown there. */
  get #row(): SoloPart | undefined {
    const { solo } = this.store.arrangement;
    return [this.row, ...SOLO_PARTS].find((part) => solo[part]);
  }

  #characters() {
    const { state: shown, played } = this.store;
    const all = Object.entries(shown?.characters ?? {});
    return all.length < 2
      ? nothing
      : html`<span role="group" aria-label="Characters">${all.map(
          ([
            name,
            { label },
          ]) => html`<button data-character=${name} aria-pressed=${played.names.includes(name)} title="Play ${label}; with Shift beside the others"
            @click=${(event: MouseEvent) => this.store.play(played.pressed(name, event.shiftKey))}>${label}</button>`,
        )}</span>`;
  }

  /** Who is on air. */
  get #airWords(): string {
    const { air, bus, goesBlack } = this.store;
    if (air === null) return "…";
    const [face = ""] = Object.entries(air.faces).reduce((best, next) => (next[1] > best[1] ? next : best), ["", 0]);
    const target = this.store.callOf("face")?.target ?? face;
    const where = bus === "preview" ? "PREVIEW" : goesBlack ? "BLACK" : "ON AIR";
    return `${where} · ${air.label} · ${this.store.label("face", target)}`;
  }

  /** What the page shows, and the layout that keeps it. */
  #choice() {
    const { store, context } = this;
    const { solo } = store.arrangement;
    const { layouts } = context;
    return html`<div class="chosen" role="group" aria-label="What this page shows">
      ${SOLO_PARTS.map((part) => html`<label><input type="checkbox" .checked=${solo[part]} @change=${() => store.arrange({ solo: { ...solo, [part]: !solo[part] } })} />${PART_LABELS[part]}</label>`)}
      <omote-liveliness .context=${context}></omote-liveliness>
      <button data-do="save" title="Every page of the show can open with it: /solo?layout=${layouts.chosen}" @click=${() => this.#saveLayout(layouts.chosen)}>Save as layout ${layouts.chosen}</button>
      <button data-do="learn" title="Dials, sticks and keys of devices (Z)" @click=${this.#learn}>Learn a device</button>
      <button class="keys" @click=${this.#showHelp}>Keys</button>
      <span @click=${this.#closeChoice}><a href="/console" target="omote-console">Console</a><a href="/cues" target="omote-cues">Cues</a></span></div>`;
  }

  /** The pad of one side, and the choice of another. */
  #pad(side: (typeof SIDES)[number], at: number) {
    const pads = padsOf(this.store);
    const shown = this.#places.names[at] as string;
    const pad = pads.find(({ name }) => name === shown);
    if (shown === "") return html`<div class="${side} panel empty">No pad: make one at the console (Shift H).</div>`;
    const choice = html`<select data-place=${at} aria-label="The ${side} pad" @change=${(event: Event) => this.#choosePad(at, textOf(event))}>
        ${pad === undefined ? html`<option value="" disabled>Choose a pad</option>` : nothing}${pads.map(({ name }) => html`<option value=${name}>${name}</option>`)}</select>`;
    return pad === undefined
      ? html`<div class="${side} panel empty" role="alert">The pad ${shown} is gone: choose another.${pads.length === 0 ? nothing : choice}</div>`
      : html`<omote-blend-pad bare class="${side} panel live" data-pad=${shown} .context=${this.context} .pad=${pad}>${choice}</omote-blend-pad>`;
  }

  #choosePad(at: number, name: string): void {
    this.#places = withChosen(this.#places, at, name);
    this.store.arrange({ pads: this.#places.chosen });
  }

  protected override willUpdate(): void {
    const { arrangement } = this.store;
    const list = this.store.newest("pad_list");
    if (list !== null) this.#places = placesAfter(this.#places, list.pads, arrangement.pads);
  }

  /** A choice has its value once its options are there; what is chosen has its new names. */
  protected override updated(): void {
    for (const choice of this.renderRoot.querySelectorAll<HTMLSelectElement>("select[data-place]")) {
      const name = this.#places.names[Number(choice.dataset.place)] as string;
      choice.value = this.#places.pads.some((pad) => pad.name === name) ? name : "";
    }
    const { chosen } = this.#places;
    if (this.#places !== NO_PLACES && chosen !== this.store.arrangement.pads) this.store.arrange({ pads: chosen });
  }

  #saveLayout(name: string): void {
    void this.context.layouts.save(name);
    this.#closeChoice();
  }

  readonly #closeChoice = (): void => {
    this.choosing = false;
  };

  /** What is chosen lies over keys that play: it goes where anything else is pressed. */
  readonly #pressElsewhere = (event: PointerEvent): void => {
    const isInside = (target: EventTarget): boolean => target instanceof Element && target.matches(".chosen, .show");
    if (!event.composedPath().some(isInside)) this.#closeChoice();
  };

  readonly #learn = (): void => {
    this.learning = !this.learning;
    this.#closeChoice();
  };

  readonly #showHelp = (): void => {
    [this.help, this.choosing] = [true, false];
  };

  readonly #openDevices = (): void => void open("/devices", "omote-devices");

  readonly #keyEverywhere = (event: KeyboardEvent): boolean => {
    if (isPanic(event) && !event.repeat) this.store.panic(event.ctrlKey);
    return isPanic(event);
  };

  readonly #key = (event: KeyboardEvent, typing: boolean): void => {
    const step = typing ? null : stepOf(event);
    const command = step === null ? soloCommandOf(event, typing) : null;
    if (event.key === "Escape" || step !== null || command !== null) this.#closeChoice();
    if (step === null && command === null) return;
    event.preventDefault();
    if (step !== null && !event.repeat) this.store[step]();
    else if (command !== null) this.#obey(command);
  };

  #obey(command: SoloCommand): void {
    const { store } = this;
    if (command.do === "go") this.cues.go();
    else if (command.do === "back") this.cues.back();
    else if (command.do === "look") this.memories?.press(command.name);
    else if (command.do === "line") this.#playLine(command.index);
    else if (command.do === "still") toggleStill(store);
    else if (command.do === "centre") store.centre();
    else if (command.do === "learn") this.#learn();
    else if (command.do === "help") this.#showHelp();
    else if (command.do === "black") store.callBlack(command.seconds);
    else if (command.do === "focus") this.#focusOn(command.place);
  }

  #playLine(index: number): void {
    const clip = clipsFound(this.store, "")[index];
    if (clip !== undefined) pressClip(this.store, clip);
  }

  #focusOn(place: "left" | "right" | "head"): void {
    if (place === "head") this.renderRoot.querySelector<HTMLElement>("omote-pad")?.focus();
    else this.renderRoot.querySelector<BlendPad>(`omote-blend-pad.${place}`)?.focus();
  }

  /** The space bar is GO alone: the button in focus is not pressed by it too. */
  readonly #spaceUp = (event: KeyboardEvent): void => {
    const [element] = event.composedPath();
    if (event.code === "Space" && element instanceof HTMLButtonElement) event.preventDefault();
  };
}
