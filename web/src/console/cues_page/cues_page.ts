/** The cue page: the list, what is on air of it, GO, and the editing of cues. */

import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { keyed } from "lit/directives/keyed.js";
import { readRecordings } from "../../rehearsal/recordings";
import type { FramePainter } from "../../ui/frame_painter";
import { pressed } from "../../ui/gestures";
import { focusedElement, hasFieldFocus, isBox, listenToKeys } from "../../ui/key_presses";
import { base, palette, toolPage } from "../../ui/theme";
import type { Thumbnails } from "../../ui/thumbnails";
import { hearWhileShown, whileShown } from "../../ui/topic_element";
import { CueElement, warning } from "../cues/cue_element";
import type { CueFormKind } from "../cues/cue_forms";
import { CUE_KEYS, type CueCommand, cueCommandOf } from "../cues/cue_keys";
import type { CueListView } from "../cues/cue_list";
import { cueBeside } from "../cues/cue_order";
import type { CueTopic } from "../cues/cue_store";
import { offersOf, offersStyle } from "../panels/offers";
import { changeBus } from "../panels/preview_bar";
import { isPanic, stepOf } from "../store/keys";
import { cuesPageStyle } from "./cues_page_style";
import "../clips/record_light";
import "../cues/cue_air";
import "../cues/cue_editor";
import "../cues/cue_forms";
import "../cues/cue_go";
import "../cues/cue_list";
import "../cues/cue_tabs";
import "../cues/far_view";
import "../../ui/keys_help";

/** The parameter of the address that says which cue is edited once the page is there. */
export const EDITED = "edited";

@customElement("omote-cues-page")
export class CuesPage extends CueElement {
  @property({ attribute: false }) thumbnails!: Thumbnails;
  @property({ attribute: false }) painter!: FramePainter;
  /** The view for two metres. */
  @property({ type: Boolean, reflect: true }) far = false;
  @state() private form: CueFormKind | null = null;
  @state() private help = false;
  @state() private printed = "";
  @query("omote-cue-list") private rows!: CueListView | null;

  static override styles = [palette, base, toolPage, warning, offersStyle, cuesPageStyle];

  protected override readonly topics: readonly CueTopic[] = ["cues", "list", "view", "link", "notice"];

  constructor() {
    super();
    const everywhere = (event: KeyboardEvent): boolean => isPanic(event) && this.#panic(event.repeat);
    whileShown(this, () => listenToKeys({ everywhere, page: this.#key }));
    hearWhileShown<KeyboardEvent>(this, window, ["keyup"], this.#spaceUp, true);
    // where the focus moves inside one element no page hears of it but by the key or press that moved it
    const noteFocus = (): void => this.cues.setTyping(hasFieldFocus());
    hearWhileShown(this, window, ["focusin", "focusout", "keyup", "pointerup"], noteFocus);
  }

  override render() {
    if (this.far) return html`<omote-cues-far .cues=${this.cues}>${this.#panicKey()}</omote-cues-far>${this.#help()}`;
    const { editing } = this.cues;
    this.toggleAttribute("editing", editing);
    this.toggleAttribute("opened", this.cues.find(this.cues.edited) !== null);
    return html`${this.#header()}
      ${this.form === null ? nothing : keyed(this.form, html`<omote-cue-form class="panel form" .cues=${this.cues} .kind=${this.form} @close=${this.#closeForm}></omote-cue-form>`)}
      <omote-cue-list class="panel" .cues=${this.cues} .thumbnails=${this.thumbnails}>
        ${editing ? html`<button @click=${() => this.#open("record")}>Record</button><button title="An empty cue behind the one that is edited" @click=${() => this.cues.begin()}>New</button><button @click=${() => this.#open("renumber")}>Renumber</button><button title="Takes a list in as text (TOML)" @click=${() => this.#open("take_in")}>Import</button>` : nothing}
        <button @click=${() => this.#open("go_to")}>Go to…</button>
      </omote-cue-list>
      ${editing ? html`<omote-cue-editor class="panel" .cues=${this.cues}></omote-cue-editor>` : html`<omote-cue-air class="panel" .cues=${this.cues}></omote-cue-air>`}
      <omote-cue-go class="panel" .cues=${this.cues}></omote-cue-go>${this.#help()}`;
  }

  #header() {
    const { cues } = this;
    const { notice, tone } = cues.show;
    return html`<header><div class="bar">
      <h1>CUES <span>${cues.name}</span></h1><span class="printed">${this.printed}</span><nav><a href="/console" target="omote-console">Console</a><a href="/solo" target="omote-solo" title="The page for one person alone">Solo</a><a href="/clips" target="omote-clips">Clips</a><a href="/console?bus=preview" target="omote-preview" title="The console of what is built up unseen">Preview</a><a href="?far${cues.names.length > 1 ? `&list=${encodeURIComponent(cues.name)}` : ""}" target="_blank">Far</a></nav>
      <omote-record-light .context=${{ store: cues.show, painter: this.painter }}></omote-record-light>
      <omote-cue-tabs .cues=${cues} @add_list=${() => this.#open("add_list")} @rename_list=${() => this.#open("rename_list")}></omote-cue-tabs>
      <span class="notice ${tone}" role="status">${notice ?? ""} ${offersOf(cues.show)}</span>
      ${cues.editing ? html`${this.#step("undo", "↶", "Ctrl Z")}${this.#step("redo", "↷", "Ctrl Y")}` : nothing}
      ${this.#modes()}
      <button class="help" aria-label="Keys" title="Keys (?)" @click=${() => this.#showHelp(true)}>?</button>
      <button class="print" title="Print the running order" @click=${() => void this.#print()}>Print</button>
      </div>${this.#panicKey()}</header>`;
  }

  /** What stands on paper beside the name of the list: of which show; another print is another day's. */
  readonly #print = async (): Promise<void> => {
    const date = new Intl.DateTimeFormat(undefined, { dateStyle: "long", timeStyle: "short" }).format(new Date());
    const [show = ""] = await readRecordings().then(
      ({ files = [] }) => files,
      () => [], // one that is not recorded is printed without
    );
    this.printed = [show, ...Object.values(this.cues.labels), date].filter((word) => word !== "").join(" · ");
    await this.updateComplete;
    print();
  };

  #panicKey() {
    const panic = pressed(() => this.#panic());
    return html`<button class="panic" title="Panic of all characters (Shift Backspace)" @pointerdown=${panic.down} @click=${panic.click}>PANIC</button>`;
  }

  #step(way: "undo" | "redo", sign: string, keys: string) {
    const what = this.cues.status[way];
    const word = way === "undo" ? "Undo" : "Redo";
    return html`<button class="step" aria-label="${word}${what === "" ? "" : `: ${what}`}" title="${word}${what === "" ? "" : `: ${what}`} (${keys})" ?disabled=${what === ""}
      @click=${() => this.cues.undo(way)}>${sign} <span>${what}</span></button>`;
  }

  #modes() {
    const { cues } = this;
    const { locked } = cues.status;
    const lock = (): void => void cues.play({ type: "set_show_mode", on: !locked });
    return html`<button class="edit" title=${cues.locked || (cues.editing ? "Back to playing (Esc)" : "Record and edit cues (E)")} aria-pressed=${cues.editing} ?disabled=${cues.locked !== ""} @click=${() => cues.setEditing(!cues.editing)}>${locked ? "Locked" : "Edit"}</button>
      ${cues.mayLock ? html`<button class="lock" title="Show mode: nobody edits cues" aria-pressed=${locked} @click=${lock}>Show mode</button>` : locked ? html`<span class="locked">SHOW MODE</span>` : nothing}`;
  }

  #help() {
    return this.help
      ? html`<omote-keys-help .keys=${CUE_KEYS} @close=${() => this.#showHelp(false)}></omote-keys-help>`
      : nothing;
  }

  #showHelp(on: boolean): void {
    this.help = on;
  }

  #open(form: CueFormKind): void {
    this.form = this.form === form ? null : form;
  }

  readonly #closeForm = (): void => {
    this.form = null;
  };

  readonly #key = (event: KeyboardEvent, typing: boolean): void => {
    const step = typing ? null : stepOf(event);
    if (step !== null) {
      event.preventDefault();
      if (!event.repeat) this.cues.undo(step);
      return;
    }
    const place = typing || (event.key !== "Escape" && event.composedPath().some(isBox)) ? "field" : this.#place;
    const command = cueCommandOf(event, place, this.cues.keysPlay);
    if (command === null) return;
    event.preventDefault();
    this.#obey(command);
  };

  get #place(): "playing" | "editing" {
    return this.cues.editing ? "editing" : "playing";
  }

  /** The space bar is GO alone: the button in focus is not pressed by it too. */
  readonly #spaceUp = (event: KeyboardEvent): void => {
    const [element] = event.composedPath();
    if (event.code === "Space" && element instanceof HTMLButtonElement) event.preventDefault();
  };

  #obey(command: CueCommand): void {
    const { cues } = this;
    if (command === "go") cues.go();
    else if (command === "back") cues.back();
    else if (command === "earlier" || command === "later") cues.stepStandby(command === "earlier" ? -1 : 1);
    else if (command === "pause") cues.pause();
    else if (command === "assert") cues.assertLook();
    else if (command === "bus") this.#changeBus();
    else if (command === "help") this.#showHelp(!this.help);
    else if (command === "search") this.rows?.search();
    else if (command === "leave") this.#leave();
    else if (command === "edit") {
      if (!this.far) cues.setEditing(!cues.editing);
    } else if (cues.editing && cues.edited !== null) this.#obeyEditing(command, cues.edited);
  }

  /** The page that comes for the other bus goes on editing where this one did. */
  #changeBus(): void {
    const { editing, edited, show } = this.cues;
    const address = new URL(location.href);
    if (editing) address.searchParams.set(EDITED, edited ?? "");
    history.replaceState(null, "", address);
    changeBus(show);
  }

  /** Out of what is innermost: a box that has the focus, the form, editing. */
  #leave(): void {
    const focused = focusedElement();
    if (focused !== null && isBox(focused)) focused.blur();
    else if (this.form !== null) this.#closeForm();
    else this.cues.setEditing(false);
  }

  #obeyEditing(command: CueCommand, edited: string): void {
    if (command === "update") this.cues.change({ type: "update_cue", cue: edited, cue_list: this.cues.name });
    else if (command === "move_up" || command === "move_down") this.rows?.move(edited, command === "move_up" ? -1 : 1);
    else if (command === "edit_before" || command === "edit_behind") {
      const beside = cueBeside(this.cues.list, edited, command === "edit_before" ? -1 : 1);
      if (beside !== null) this.cues.edit(beside.identity);
    }
  }

  #panic(held = false): boolean {
    if (!held) this.cues.panic();
    return true;
  }
}
