/** A scan on its way to a face: waited for, looked at, corrected by clicks, taken or thrown away. */

import { html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { textOf } from "../../ui/topic_element";
import { quarterTurned, type SeenScan } from "./data/scan_document";
import { ScanPoints } from "./data/scan_points";
import { bringScan, FIT_TITLE, fitAgain } from "./data/scan_requests";
import { adviceOf, asksEyes, nearnessOf } from "./data/scan_words";
import { FaceDialog } from "./face_dialog";
import { pointList } from "./point_list";
import { HEAT_STOPS, heatGradient } from "./views/heat_scale";
import type { ScanMix } from "./views/scan_painter";
import "./views/scan_views";

/** Files: the scan and what lies beside it. */
@customElement("omote-scan")
export class ScanDialog extends FaceDialog<SeenScan> {
  @state() private shown: ScanMix = { share: 0.5, heat: false };
  @state() private shut: boolean | null = null;
  /** Raised where points change: they are not Lit's. */
  @state() private step = 0;
  readonly #points = new ScanPoints();
  protected readonly words = {
    title: FIT_TITLE,
    source: "this scan",
    thrown: "Throw the scan and its points away? It stays on your disk.",
  };

  // --- what is asked --------------------------------------------------------------------------------------------------

  protected override begin(): Promise<SeenScan> {
    return bringScan(this.files, this.store.longRequests);
  }

  protected override fitted(scan: SeenScan, before: SeenScan | null): void {
    this.#points.fitted();
    this.shut = scan.shut;
    if (before?.face === null || before === null) this.shown = { ...this.shown, share: scan.face === null ? 0 : 0.5 };
  }

  protected override fitAgain(scan: SeenScan): Promise<SeenScan> {
    return fitAgain(scan, this.#points.given, this.shut, this.store.longRequests);
  }

  protected override isChanged(scan: SeenScan): boolean {
    return this.#points.changed || this.shut !== scan.shut;
  }

  // --- what is seen ---------------------------------------------------------------------------------------------------

  protected override advice(scan: SeenScan) {
    return { advice: adviceOf(scan, this.#points.changed), note: nearnessOf(scan) };
  }

  protected override views(scan: SeenScan) {
    const put = (shown: Partial<ScanMix>): void => {
      this.shown = { ...this.shown, ...shown };
    };
    return html`<div class="views">
      <omote-scan-views .scan=${scan} .points=${this.#points} .meshes=${this.store.library?.meshes ?? []} .shown=${this.shown}
        .step=${this.step} @set=${() => this.#changed()}></omote-scan-views>
      ${this.waiting()}
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
      html`<button @click=${() => (this.seen = quarterTurned(scan, way))}>${label}</button>`;
    return [button("tip", "Tip forward"), button("roll", "Roll over")];
  }

  #legend() {
    return html`<div class="legend grow"><div style="background:${heatGradient()}"></div>
      <p>${HEAT_STOPS.map(([stop], at) => html`<span>${stop}${at === HEAT_STOPS.length - 1 ? " mm and more" : ""}</span>`)}</p></div>`;
  }

  protected override corrections(scan: SeenScan) {
    return [
      pointList({ points: this.#points, foundPoints: scan.found, changed: () => this.#changed() }),
      this.#eyes(scan),
    ];
  }

  #eyes(scan: SeenScan) {
    const said = this.shut === null ? "" : this.shut ? "shut" : "open";
    const choices = { "": "Its eyes: open or shut?", open: "Its eyes are open", shut: "Its eyes are shut" };
    return html`<select class=${asksEyes(scan) && this.shut === null ? "asked" : ""} aria-label="Eyes of the scan"
      @change=${(event: Event) => (this.shut = { shut: true, open: false }[textOf(event)] ?? null)}>
      ${Object.entries(choices).map(([value, label]) => html`<option value=${value} ?selected=${value === said}>${label}</option>`)}
    </select>`;
  }

  #changed(): void {
    this.step += 1;
  }
}
