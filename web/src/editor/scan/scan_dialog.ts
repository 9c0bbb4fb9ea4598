/** A scan on its way to a face: waited for, looked at, corrected by clicks, taken or thrown away. */

import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { curtain } from "../../ui/dialog_style";
import { layerWhileShown } from "../../ui/key_presses";
import { CancelledError } from "../../ui/long_requests";
import { base } from "../../ui/theme";
import { controls } from "../controls/controls_style";
import { EditorElement, textOf } from "../controls/editor_element";
import type { Topic } from "../session/draft_store";
import { freeLabel, openItem } from "../session/item_commands";
import { nameOf } from "./data/dropped_files";
import { type Hair, quarterTurned, type SeenScan } from "./data/scan_document";
import { ScanPoints } from "./data/scan_points";
import { bringScan, dropScan, FIT_TITLE, fitAgain, sentence, takeFace } from "./data/scan_requests";
import { adviceOf, asksEyes, nearnessOf } from "./data/scan_words";
import { pointList } from "./point_list";
import { style } from "./scan_style";
import { HEAT_STOPS, heatGradient } from "./views/heat_scale";
import type { Shown } from "./views/scan_painter";
import "./views/scan_views";

/** Tells `close` when there is nothing more to do. */
@customElement("omote-scan")
export class ScanDialog extends EditorElement {
  /** The scan and what lies beside it, from the desk. */
  @property({ attribute: false }) files!: readonly File[];
  @state() private scan: SeenScan | null = null;
  /** What is under way: a fit, the taking; empty: nothing. */
  @state() private busy: "" | "fit" | "take" = "";
  @state() private failed = "";
  @state() private leaving = false;
  @state() private shown: Shown = { share: 0.5, heat: false };
  @state() private shut: boolean | null = null;
  @state() private label = "";
  /** What was chosen; null: what is proposed. */
  @state() private chosenHair: Hair | null = null;
  @state() private replaced: number | null = null;
  /** Raised where points change: they are not Lit's. */
  @state() private step = 0;
  @query(".acts button") private first!: HTMLElement | null;
  readonly #points = new ScanPoints();
  #deaf: () => void = () => undefined;
  readonly #left = (): void => this.#drop();

  static override styles = [base, controls, curtain, style];

  constructor() {
    super();
    layerWhileShown(this, "dialog", () => this.#escape());
  }

  protected override topics(): readonly Topic[] {
    return ["items", "cast"];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#deaf = this.store.longRequests.listen(() => this.requestUpdate());
    window.addEventListener("pagehide", this.#left);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#deaf();
    window.removeEventListener("pagehide", this.#left);
  }

  override firstUpdated(): void {
    this.label = freeLabel(this.store.items, nameOf(this.files.map(({ name }) => name)));
    void this.#fit(() => bringScan(this.files, this.store.longRequests));
  }

  get #hair(): Hair {
    return this.chosenHair ?? this.scan?.hair ?? { style: "", colour: "#000000" };
  }

  // --- what is asked --------------------------------------------------------------------------------------------------

  async #fit(ask: () => Promise<SeenScan>): Promise<void> {
    [this.busy, this.failed, this.leaving] = ["fit", "", false];
    try {
      const before = this.scan;
      this.scan = await ask();
      this.#points.fitted();
      this.shut = this.scan.shut;
      if (before?.face === null || before === null)
        this.shown = { ...this.shown, share: this.scan.face === null ? 0 : 0.5 };
    } catch (error) {
      if (error instanceof CancelledError && this.scan === null) this.#close();
      else if (!(error instanceof CancelledError)) this.failed = (error as Error).message;
    } finally {
      this.busy = "";
    }
    await this.updateComplete;
    this.first?.focus();
  }

  #fitAgain(): void {
    const { scan } = this;
    if (scan !== null) void this.#fit(() => fitAgain(scan, this.#points.given, this.shut, this.store.longRequests));
  }

  async #take(): Promise<void> {
    const { scan, store } = this;
    if (scan === null) return;
    [this.busy, this.failed] = ["take", ""];
    const taking = {
      label: this.label.trim() || nameOf([scan.file]),
      hair_style: this.#hair.style,
      hair: this.#hair.colour,
      replaced: this.replaced,
    };
    try {
      const name = await takeFace(scan, taking, store.longRequests);
      this.scan = null; // the server has let go of it
      this.#sayTaken(name, taking.label);
      this.#close();
    } catch (error) {
      if (!(error instanceof CancelledError)) this.failed = (error as Error).message;
    } finally {
      this.busy = "";
    }
  }

  #sayTaken(name: string, label: string): void {
    const { store } = this;
    const own = store.items.find(({ id }) => id === this.replaced);
    const what =
      own === undefined
        ? `"${label}" plays, with all expressions: consoles have it among the faces.`
        : `"${own.label}" is the face of this scan now, wherever it plays; its history has the one before.`;
    const open = (): void => {
      const item = store.items.find((each) => each.kind === "face" && each.name === name);
      if (item !== undefined) void openItem(store, item.id);
    };
    store.say(what, "done", [
      { label: "Open it here", act: open },
      { label: "Open the console", act: () => void window.open("/console", "_blank") },
    ]);
  }

  // --- what is seen ---------------------------------------------------------------------------------------------------

  override render() {
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="A face from a scan">
      <header><h2>A face from a scan</h2><b>${this.scan?.file ?? this.files.map(({ name }) => name).join(", ")}</b></header>
      ${this.scan === null ? this.#beginning() : [this.#views(this.scan), this.#side(this.scan)]}
    </section>`;
  }

  #beginning() {
    if (this.busy !== "") return html`<div class="waiting">${this.#progress()}</div>`;
    return html`<div class="waiting"><p class="failed" role="alert">${this.failed}</p>
      <div class="acts"><button @click=${() => this.#close()}>Close</button></div></div>`;
  }

  /** How far the fit is; the page stays usable, and so does the show. */
  #progress() {
    const request = this.store.longRequests.all.find(({ title }) => title === FIT_TITLE);
    const { done = 0, total = 0, what = "", ending = false } = request ?? {};
    const words = ending ? "It is being cancelled" : what === "" ? "It begins" : what;
    return html`<p role="status">${words.charAt(0).toUpperCase() + words.slice(1)} …${total > 0 ? ` ${Math.round((100 * done) / total)} %` : ""}</p>
      <progress aria-label=${FIT_TITLE} max=${Math.max(1, total)} .value=${total === 0 ? null : done}></progress>
      <button ?disabled=${ending || request === undefined} @click=${() => request && this.store.longRequests.cancel(request.id)}>Cancel</button>`;
  }

  #views(scan: SeenScan) {
    const put = (shown: Partial<Shown>): void => {
      this.shown = { ...this.shown, ...shown };
    };
    return html`<div class="views">
      <omote-scan-views .scan=${scan} .points=${this.#points} .meshes=${this.store.library?.meshes ?? []} .shown=${this.shown}
        .step=${this.step} @set=${() => this.#changed()}></omote-scan-views>
      ${this.busy === "fit" ? html`<div class="waiting over">${this.#progress()}</div>` : nothing}
      <div class="row show">
        <button ?disabled=${scan.face === null} aria-pressed=${this.shown.share === 0} @click=${() => put({ share: 0 })}>Scan</button>
        <input type="range" min="0" max="1" step="0.05" aria-label="From the scan to the face" ?disabled=${scan.face === null}
          .value=${String(this.shown.share)} @input=${(event: Event) => put({ share: Number(textOf(event)) })} />
        <button ?disabled=${scan.face === null} aria-pressed=${this.shown.share === 1} @click=${() => put({ share: 1 })}>Face</button>
        <button ?disabled=${scan.face === null} aria-pressed=${this.shown.heat}
          @click=${() => put({ heat: !this.shown.heat, share: this.shown.heat ? this.shown.share : 1 })}>Distance</button>
        ${this.shown.heat ? this.#legend() : nothing} ${scan.face === null ? this.#turns(scan) : nothing}
      </div>
      <p id="keys" class="note">Click the scan to set a point, drag to turn it (with Shift: to shift it), wheel or two fingers: closer. Keys: 1 to 7 choose a point, arrows move it (Alt: turn), V the next side, + and −.</p>
    </div>`;
  }

  /** Nobody knows which way up it is before it is fitted. */
  #turns(scan: SeenScan) {
    const button = (way: "tip" | "roll", label: string) =>
      html`<button @click=${() => {
        this.scan = quarterTurned(scan, way);
      }}>${label}</button>`;
    return [button("tip", "Tip forward"), button("roll", "Roll over")];
  }

  #legend() {
    return html`<div class="legend grow"><div style="background:${heatGradient()}"></div>
      <p>${HEAT_STOPS.map(([stop], at) => html`<span>${stop}${at === HEAT_STOPS.length - 1 ? " mm and more" : ""}</span>`)}</p></div>`;
  }

  #side(scan: SeenScan) {
    const sure = scan.doubts.length === 0 && scan.face !== null;
    return html`<div class="side">
      <div class="verdict ${sure ? "" : "unsure"}" role="status">
        <p>${adviceOf(scan, this.#points.changed)}</p>
        ${scan.doubts.length + scan.notes.length === 0 ? nothing : html`<ul>${[...scan.doubts.map((doubt) => doubt.sentence), ...scan.notes.map(sentence)].map((doubt) => html`<li>${doubt}</li>`)}</ul>`}
        <span class="note">${nearnessOf(scan)}</span>
      </div>
      ${this.failed === "" ? nothing : html`<p class="failed" role="alert">${this.failed}</p>`}
      ${pointList({ points: this.#points, found: scan.found, changed: () => this.#changed() })} ${this.#eyes(scan)} ${this.#takingForm()} ${this.#acts(scan)}
    </div>`;
  }

  #eyes(scan: SeenScan) {
    const said = this.shut === null ? "" : this.shut ? "shut" : "open";
    const choices = { "": "Its eyes: look", open: "Its eyes are open", shut: "Its eyes are shut" };
    return html`<select class=${asksEyes(scan) && this.shut === null ? "asked" : ""} aria-label="Eyes of the scan"
      @change=${(event: Event) => {
        this.shut = { shut: true, open: false }[textOf(event)] ?? null;
      }}>
      ${Object.entries(choices).map(([value, label]) => html`<option value=${value} ?selected=${value === said}>${label}</option>`)}
    </select>`;
  }

  #takingForm() {
    const faces = this.store.items.filter(({ kind, deleted, head }) => kind === "face" && !deleted && head > 0);
    const styles = (this.store.library?.manifest.hair ?? []).map(({ name }) => name);
    return html`<h2>Take it as</h2><div class="taking">
      ${
        faces.length === 0
          ? nothing
          : html`<label for="replaced">Place</label><select id="replaced" @change=${(event: Event) => {
              this.replaced = textOf(event) === "" ? null : Number(textOf(event));
            }}>
              <option value="">A new face</option>
              ${faces.map(({ id, label }) => html`<option value=${id} ?selected=${id === this.replaced}>Instead of ${label}</option>`)}
            </select>`
      }
      <label for="label">Name</label><input id="label" maxlength="64" ?disabled=${this.replaced !== null}
        .value=${this.store.items.find(({ id }) => id === this.replaced)?.label ?? this.label}
        @input=${(event: Event) => {
          this.label = textOf(event);
        }} />
      <label for="hair">Hair</label><div class="row"><select id="hair" class="grow" @change=${(event: Event) => {
        this.chosenHair = { ...this.#hair, style: textOf(event) };
      }}>
        ${["", ...styles].map((name) => html`<option value=${name} ?selected=${name === this.#hair.style}>${name === "" ? "none" : name}</option>`)}
      </select><input type="color" aria-label="Colour of the hair" .value=${this.#hair.colour} @input=${(
        event: Event,
      ) => {
        this.chosenHair = { ...this.#hair, colour: textOf(event) };
      }} /></div>
    </div>`;
  }

  #acts(scan: SeenScan) {
    if (this.leaving)
      return html`<div class="acts" role="alertdialog" aria-label="Throw it away?"><p>Throw the scan and its points away? It stays on your disk.</p>
        <button @click=${() => this.#throwAway()}>Throw away</button>
        <button @click=${() => this.#escape()}>Keep looking</button></div>`;
    const again = this.#points.changed || this.shut !== scan.shut;
    const sure = scan.doubts.length === 0;
    const take = html`<button class=${again || scan.face === null || !sure ? "" : "main"} ?disabled=${scan.face === null || this.busy !== "" || again}
      @click=${() => this.#take()}>${this.busy === "take" ? "Taking it …" : sure || scan.face === null ? "Take it" : "Take it as it is"}</button>`;
    return html`<div class="acts">
      ${again ? html`<button class="main" ?disabled=${this.busy !== ""} @click=${() => this.#fitAgain()}>Fit again</button>` : nothing}
      ${take}<button ?disabled=${this.busy === "take"} @click=${() => this.#escape()}>Throw away</button></div>`;
  }

  // --- the end --------------------------------------------------------------------------------------------------------

  #changed(): void {
    this.step += 1;
  }

  /** Escape asks before work is lost; while nothing has come it cancels. */
  #escape(): void {
    const request = this.store.longRequests.all.find(({ title }) => title === FIT_TITLE);
    if (this.busy === "fit" && request !== undefined) this.store.longRequests.cancel(request.id);
    else if (this.scan === null) this.#close();
    else if (this.busy === "") this.leaving = !this.leaving;
  }

  #throwAway(): void {
    this.#drop();
    this.#close();
  }

  #drop(): void {
    if (this.scan !== null) dropScan(this.scan);
    this.scan = null;
  }

  #close(): void {
    this.dispatchEvent(new CustomEvent("close"));
  }
}
