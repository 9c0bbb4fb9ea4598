/** The page of clips: the list, the time line of one with its lanes, and the transport. */

import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { FramePainter } from "../../ui/frame_painter";
import { pressed } from "../../ui/gestures";
import { listenToKeys } from "../../ui/key_presses";
import { base, palette, toolPage } from "../../ui/theme";
import { hearWhileShown, whileShown } from "../../ui/topic_element";
import { ClipElement } from "../clips/clip_element";
import { CLIP_KEYS, type ClipCommand, clipCommandOf } from "../clips/clip_keys";
import type { ClipList } from "../clips/clip_list";
import type { ClipTopic } from "../clips/clip_store";
import type { ClipTimeline } from "../clips/clip_timeline";
import { offersOf, offersStyle } from "../panels/offers";
import { isPanic, stepOf } from "../store/keys";
import { clipsPageStyle } from "./clips_page_style";
import "../clips/clip_list";
import "../clips/clip_settings";
import "../clips/clip_timeline";
import "../clips/clip_transport";
import "../clips/record_light";
import "../../ui/keys_help";

@customElement("omote-clips-page")
export class ClipsPage extends ClipElement {
  @property({ attribute: false }) painter!: FramePainter;
  @state() private help = false;
  @query("omote-clip-list") private list!: ClipList;
  @query("omote-clip-timeline") private line!: ClipTimeline;

  static override styles = [palette, base, toolPage, offersStyle, clipsPageStyle];

  protected override readonly topics: readonly ClipTopic[] = ["view", "link", "notice", "undo", "work"];

  constructor() {
    super();
    const everywhere = (event: KeyboardEvent): boolean => isPanic(event) && this.#panic(event.repeat);
    whileShown(this, () => listenToKeys({ everywhere, page: this.#key }));
    hearWhileShown<KeyboardEvent>(this, window, ["keyup"], this.#spaceUp, true);
    hearWhileShown<DragEvent>(this, window, ["dragover"], (event) => event.preventDefault());
    hearWhileShown<DragEvent>(this, window, ["drop"], this.#dropFile);
  }

  override render() {
    const { clips } = this;
    return html`${this.#header()}
      <omote-clip-list class="panel" .clips=${clips}></omote-clip-list>
      <omote-clip-settings class="panel" .clips=${clips}></omote-clip-settings>
      <div class="line panel"><omote-clip-timeline .clips=${clips} .painter=${this.painter}></omote-clip-timeline>${this.#count()}</div>
      <omote-clip-transport class="panel" .clips=${clips} .painter=${this.painter}></omote-clip-transport>
      ${this.help ? html`<omote-keys-help .keys=${CLIP_KEYS} @close=${() => this.#showHelp(false)}></omote-keys-help>` : nothing}`;
  }

  #header() {
    const { show } = this.clips;
    const panic = pressed(() => this.#panic());
    return html`<header><div class="bar">
      <h1>CLIPS</h1><nav><a href="/console" target="omote-console">Console</a><a href="/solo" target="omote-solo" title="The page for one person alone">Solo</a><a href="/cues" target="omote-cues">Cues</a></nav>
      <omote-record-light words .context=${{ store: show, painter: this.painter }}></omote-record-light>
      ${show.online ? nothing : html`<span class="lost" role="alert">LINK LOST</span>`}
      <span class="notice ${show.tone}" role="status">${show.notice ?? ""} ${offersOf(show)}</span>
      ${this.#step("undo", "↶", "Ctrl Z")}${this.#step("redo", "↷", "Ctrl Y")}
      <button class="help" aria-label="Keys" title="Keys (?)" @click=${() => this.#showHelp(true)}>?</button>
      </div><button class="panic" title="Panic of all characters (Shift Backspace)" @pointerdown=${panic.down} @click=${panic.click}>PANIC</button></header>`;
  }

  #step(way: "undo" | "redo", sign: string, keys: string) {
    const { show } = this.clips;
    const step = show.history.next(way);
    const word = way === "undo" ? "Undo" : "Redo";
    return html`<button aria-label="${word}${step === null ? "" : `: ${step.what}`}" title="${word}${step === null ? "" : `: ${step.what}`} (${keys})" ?disabled=${step === null} @click=${() => show[way]()}>${sign}</button>`;
  }

  #count() {
    const { counting } = this.clips;
    return counting === null
      ? nothing
      : html`<div class="count" role="alert">${counting}<small>Esc or Discard: not now</small></div>`;
  }

  /** A sound that is dropped anywhere on the page. */
  readonly #dropFile = (event: DragEvent): void => {
    event.preventDefault();
    const [file] = event.dataTransfer?.files ?? [];
    if (file !== undefined) void this.clips.bringSound(file);
  };

  #showHelp(on: boolean): void {
    this.help = on;
  }

  readonly #key = (event: KeyboardEvent, typing: boolean): void => {
    if (event.defaultPrevented) return;
    const step = typing ? null : stepOf(event);
    if (step !== null) {
      event.preventDefault();
      if (!event.repeat) this.clips.show[step]();
      return;
    }
    if (isFader(event) && MOVES.has(event.code) && !event.altKey) return;
    const command = clipCommandOf(event, typing);
    if (command === null) return;
    event.preventDefault();
    this.#obey(command);
  };

  /** The space bar plays alone: the button in focus is not pressed by it too. */
  readonly #spaceUp = (event: KeyboardEvent): void => {
    const [element] = event.composedPath();
    if (event.code === "Space" && element instanceof HTMLButtonElement) event.preventDefault();
  };

  #obey(command: ClipCommand): void {
    const { clips } = this;
    if (command.do === "play") clips.togglePlay();
    else if (command.do === "record") clips.record();
    else if (command.do === "keep") clips.keep();
    else if (command.do === "discard") clips.discard();
    else if (command.do === "again") clips.recordAgain();
    else if (command.do === "count_in") clips.setCountIn(!clips.countsIn);
    else if (command.do === "slow") clips.setPassSpeed(clips.passSpeed === 1 ? 0.5 : 1);
    else if (command.do === "arm") clips.arm(command.part, command.how);
    else if (command.do === "arm_all") clips.armAll();
    else if (command.do === "mark") clips.mark(command.end);
    else if (command.do === "step") clips.seek(clips.cursor + command.seconds);
    else if (command.do === "go") clips.seek(clips.outline?.[command.end] ?? 0);
    else this.#obeyEdit(command);
  }

  #obeyEdit(command: ClipCommand): void {
    const { clips } = this;
    if (command.do === "lane") clips.chooseLane(clips.lane + command.way);
    else if (command.do === "shift") clips.shift(clips.lane, command.seconds);
    else if (command.do === "mute") clips.toggleMute(clips.lane);
    else if (command.do === "loop" && clips.outline !== null) clips.editClip({ loop: !clips.outline.loop });
    else if (command.do === "zoom") this.line.zoom(command.way);
    else if (command.do === "new") this.list.begin();
    else if (command.do === "search") this.list.search();
    else if (command.do === "help") this.#showHelp(true);
  }

  /** Of all characters: this page plays none of them alone. */
  #panic(held = false): boolean {
    if (!held) this.clips.show.panic(true);
    return true;
  }
}

/** What a fader does by itself where it has the focus. */
const MOVES = new Set(["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End"]);

const isFader = (event: Event): boolean =>
  event.composedPath().some((target) => target instanceof HTMLInputElement && target.type === "range");
