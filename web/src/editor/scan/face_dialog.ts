/** What the dialogs share in which somebody's face is made: waited for, looked at, corrected, taken or thrown away. */

import { html, nothing, type TemplateResult } from "lit";
import { property, query, state } from "lit/decorators.js";
import { curtain } from "../../ui/dialog_style";
import { layerWhileShown } from "../../ui/key_presses";
import { CancelledError } from "../../ui/long_requests";
import { base } from "../../ui/theme";
import { hearWhileShown, textOf, whileShown } from "../../ui/topic_element";
import { controls } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import type { Topic } from "../session/draft_store";
import { freeLabel, openItem } from "../session/item_commands";
import { nameOf } from "./data/dropped_files";
import type { Drawable, HairChoice } from "./data/scan_document";
import { dropScan, sentence, type Taken, takeFace } from "./data/scan_requests";
import { style } from "./scan_style";
import { hairChoice, nameNote, placeChoice } from "./taking_form";

/** What a fit shows. */
export type SeenFace = Drawable & {
  readonly token: string;
  readonly doubts: readonly { readonly sentence: string }[];
  readonly notes: readonly string[];
  readonly hair: HairChoice;
};

/** What a dialog says of what it works on. */
export interface Words {
  /** The title of the dialog, and of a fit among the long requests. */
  readonly title: string;
  /** "the face of ... now". */
  readonly source: string;
  /** What is asked before work is lost. */
  readonly thrown: string;
}

/** Tells `close` when there is nothing more to do. */
export abstract class FaceDialog<Seen extends SeenFace> extends EditorElement {
  /** What came from the desk. */
  @property({ attribute: false }) files!: readonly File[];
  @state() protected seen: Seen | null = null;
  /** What is under way: a fit, the taking; empty: nothing. */
  @state() protected busy: "" | "fit" | "take" = "";
  @state() protected failed = "";
  @state() private leaving = false;
  @state() private label = "";
  /** What was chosen; null: what is proposed. */
  @state() private chosenHair: HairChoice | null = null;
  @state() private replaced: number | null = null;
  @query(".acts button") private first!: HTMLElement | null;
  @query(".panel") private panel!: HTMLElement | null;
  protected abstract readonly words: Words;
  /** What it is called where nobody says so. */
  #proposed = "";

  static override styles = [base, controls, curtain, style];

  constructor() {
    super();
    layerWhileShown(this, "dialog", () => this.escape());
    whileShown(this, () => this.store.longRequests.listen(() => this.requestUpdate()));
    hearWhileShown(this, window, ["pagehide"], () => this.#drop());
  }

  /** Asks for the first fit. */
  protected abstract begin(): Promise<Seen>;
  /** Takes note of a fit that has come, after the one before. */
  protected abstract fitted(seen: Seen, before: Seen | null): void;
  /** Asks for another fit. */
  protected abstract fitAgain(seen: Seen): Promise<Seen>;
  /** Whether a fit would now be another than that which is shown. */
  protected abstract isChanged(seen: Seen): boolean;
  /** What to do now, and what is known of the fit. */
  protected abstract advice(seen: Seen): { readonly advice: string; readonly note: string };
  /** What lies to the left, and under the verdict. */
  protected abstract views(seen: Seen): TemplateResult;
  protected abstract corrections(seen: Seen): unknown;

  protected override readonly topics: readonly Topic[] = ["items", "cast"];

  override firstUpdated(): void {
    this.#proposed = nameOf(this.files.map(({ name }) => name));
    this.label = freeLabel(this.store, "face", this.#proposed);
    void this.#fit(() => this.begin());
  }

  get #hair(): HairChoice {
    return this.chosenHair ?? this.seen?.hair ?? { style: "", colour: "#000000" };
  }

  /** The name that was typed. */
  get #typed(): string {
    return this.label.trim().replace(/\s+/g, " ") || this.#proposed;
  }

  /** What a new face will be called: no two have one name. */
  get #called(): string {
    return freeLabel(this.store, "face", this.#typed);
  }

  /** Says in the dialog why something is not done now; the page's own notices lie behind it. */
  refuse(sentence: string): void {
    this.failed = sentence;
  }

  // --- what is asked --------------------------------------------------------------------------------------------------

  async #fit(ask: () => Promise<Seen>): Promise<void> {
    [this.busy, this.failed, this.leaving] = ["fit", "", false];
    try {
      const before = this.seen;
      this.seen = await ask();
      if (this.isConnected) this.fitted(this.seen, before);
      else this.#drop(); // closed meanwhile
    } catch (error) {
      if (error instanceof CancelledError && this.seen === null) this.close();
      else if (!(error instanceof CancelledError)) this.failed = (error as Error).message;
    } finally {
      this.busy = "";
    }
    await this.updateComplete;
    const { seen } = this;
    if (seen !== null && !this.#isSure(seen))
      this.panel?.focus(); // what is doubtful is not one Enter away
    else this.first?.focus();
  }

  async #take(): Promise<void> {
    const { seen, store } = this;
    if (seen === null) return;
    [this.busy, this.failed] = ["take", ""];
    const taking = {
      label: this.#called,
      hair_style: this.#hair.style,
      hair: this.#hair.colour,
      replaced: this.replaced,
    };
    try {
      const taken = await takeFace(seen, taking, store.longRequests);
      this.seen = null; // the server has let go of it
      this.#sayTaken(taken);
      this.close();
    } catch (error) {
      if (!(error instanceof CancelledError)) this.failed = (error as Error).message;
    } finally {
      this.busy = "";
    }
  }

  #sayTaken({ name, label }: Taken): void {
    const { store } = this;
    const behind = store.draft?.item === this.replaced && store.draft?.dirty === true;
    const draft = behind
      ? " Your draft is still of that one: Bring back in the history puts the new face into it."
      : "";
    const what =
      this.replaced === null
        ? `"${label}" plays, with all expressions: consoles have it among their faces, under Own.`
        : `"${label}" is the face of ${this.words.source} now, wherever it plays; its history has the one before.${draft}`;
    const open = (): void => {
      const item = store.items.find((candidate) => candidate.kind === "face" && candidate.name === name);
      if (item !== undefined) void openItem(store, item.id);
    };
    store.say(what, "done", [
      { label: "Open it here", act: open },
      { label: "Open the console", act: () => void window.open("/console", "_blank") },
    ]);
  }

  // --- what is seen ---------------------------------------------------------------------------------------------------

  override render() {
    const { title } = this.words;
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label=${title} tabindex="-1">
      <header><h2>${title}</h2><b>${this.files.map(({ name }) => name).join(", ") || "A turn of the head"}</b></header>
      ${this.seen === null ? this.beginning() : [this.views(this.seen), this.#side(this.seen)]}
    </section>`;
  }

  /** What is seen before the first fit has come. */
  protected beginning(): TemplateResult {
    if (this.busy !== "") return html`<div class="waiting">${this.progress()}${this.#refusal()}</div>`;
    return html`<div class="waiting">${this.#refusal()}
      <div class="acts"><button @click=${() => this.close()}>Close</button></div></div>`;
  }

  /** How far the fit is; the page stays usable, and so does the show. */
  protected progress(): TemplateResult {
    const { title } = this.words;
    const request = this.store.longRequests.all.find((longRequest) => longRequest.title === title);
    const { done = 0, total = 0, what = "", ending = false } = request ?? {};
    const words = ending ? "It is being cancelled" : what === "" ? "It begins" : what;
    return html`<p role="status">${words.charAt(0).toUpperCase() + words.slice(1)} …${total > 0 ? ` ${Math.round((100 * done) / total)} %` : ""}</p>
      <progress aria-label=${title} max=${Math.max(1, total)} .value=${total === 0 ? null : done}></progress>
      <button ?disabled=${ending || request === undefined} @click=${() => request && this.store.longRequests.cancel(request.id)}>Cancel</button>`;
  }

  /** The progress of another fit over what is seen. */
  protected waiting(): unknown {
    return this.busy === "fit" ? html`<div class="waiting over">${this.progress()}</div>` : nothing;
  }

  #side(seen: Seen) {
    const { advice, note } = this.advice(seen);
    const said = [...seen.doubts.map((doubt) => doubt.sentence), ...seen.notes.map(sentence)];
    return html`<div class="side">
      <div class="verdict ${this.#isSure(seen) ? "" : "unsure"}" role="status">
        <p>${advice}</p>
        ${said.length === 0 ? nothing : html`<ul>${said.map((doubt) => html`<li>${doubt}</li>`)}</ul>`}
        <span class="note">${note}</span>
      </div>
      ${this.#refusal()}
      ${this.corrections(seen)} ${this.#takingForm()} ${this.#acts(seen)}
    </div>`;
  }

  #refusal() {
    return this.failed === "" ? nothing : html`<p class="failed" role="alert">${this.failed}</p>`;
  }

  #isSure({ doubts, face }: Seen): boolean {
    return doubts.length === 0 && face !== null;
  }

  #takingForm() {
    const own = this.store.items.find(({ id }) => id === this.replaced);
    return html`<h2>Take it as</h2><div class="taking">
      ${placeChoice(this.store.items, this.replaced, (id) => {
        this.replaced = id;
      })}
      <label for="label">Name</label><input id="label" maxlength="64" placeholder=${freeLabel(this.store, "face", this.#proposed)} ?disabled=${own !== undefined}
        .value=${own?.label ?? this.label}
        @input=${(event: Event) => (this.label = textOf(event))} />
      ${own !== undefined || this.#called === this.#typed ? nothing : nameNote(this.#typed, this.#called)}
      ${hairChoice(
        (this.store.library?.manifest.hair ?? []).map(({ name }) => name),
        this.#hair,
        (hair) => {
          this.chosenHair = hair;
        },
      )}
    </div>`;
  }

  #acts(seen: Seen) {
    if (this.leaving)
      return html`<div class="acts" role="alertdialog" aria-label="Throw it away?"><p>${this.words.thrown}</p>
        <button @click=${() => this.#throwAway()}>Throw away</button>
        <button @click=${() => this.escape()}>Keep looking</button></div>`;
    const again = this.isChanged(seen);
    const [sure, hasFace] = [seen.doubts.length === 0, seen.face !== null];
    const take = html`<button class=${again || !hasFace || !sure ? "" : "main"} ?disabled=${!hasFace || this.busy !== "" || again}
      @click=${() => this.#take()}>${this.busy === "take" ? "Taking it …" : sure || !hasFace ? "Take it" : "Take it as it is"}</button>`;
    return html`<div class="acts">
      ${again ? html`<button class="main" ?disabled=${this.busy !== ""} @click=${() => this.#fit(() => this.fitAgain(seen))}>Fit again</button>` : nothing}
      ${take}<button ?disabled=${this.busy === "take"} @click=${() => this.escape()}>Throw away</button></div>`;
  }

  // --- the end --------------------------------------------------------------------------------------------------------

  /** Escape asks before work is lost; while nothing has come it cancels. */
  protected escape(): void {
    const request = this.store.longRequests.all.find(({ title }) => title === this.words.title);
    if (this.busy === "fit" && request !== undefined) this.store.longRequests.cancel(request.id);
    else if (this.seen === null) this.close();
    else if (this.busy === "") this.leaving = !this.leaving;
  }

  #throwAway(): void {
    this.#drop();
    this.close();
  }

  #drop(): void {
    if (this.seen !== null) dropScan(this.seen);
    this.seen = null;
  }

  protected override readonly close = (): void => {
    if (this.isConnected) this.tell("close");
  };
}
