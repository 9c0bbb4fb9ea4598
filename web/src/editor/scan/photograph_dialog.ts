/** Photographs of a person on their way to a face: looked at for landmarks here, fitted, corrected, taken or thrown away. */

import { html, nothing, type TemplateResult } from "lit";
import { customElement, state } from "lit/decorators.js";
import { CancelledError } from "../../ui/long_requests";
import { textOf } from "../../ui/topic_element";
import { FaceDialog } from "./face_dialog";
import type { SeenPhotographs } from "./photographs/photograph_document";
import { MOST_PHOTOGRAPHS, readPhotograph } from "./photographs/photograph_files";
import { PhotographFinder } from "./photographs/photograph_finder";
import { HANDLES } from "./photographs/photograph_handles";
import { type FoundPhotograph, PhotographPoints } from "./photographs/photograph_points";
import {
  bringPhotographs,
  decodePhotograph,
  fitPhotographsAgain,
  PHOTOGRAPH_TITLE,
} from "./photographs/photograph_requests";
import { knowledgeOf, noFace, photographAdvice } from "./photographs/photograph_words";
import "./photographs/photograph_view";
import "./turn/turn_view";
import "./views/scan_views";

/** What is seen: a photograph by its place, or the face. */
type PictureChoice = number | "face";

/** Files: one to eight photographs of one person; none: the camera takes them. */
@customElement("omote-photographs")
export class PhotographDialog extends FaceDialog<SeenPhotographs> {
  /** Takes the pictures of a turn before the camera; null: no turn is under way. */
  @state() private turned: ((files: readonly File[]) => void) | null = null;
  /** What the page itself does now, before it asks; empty: it has asked. */
  @state() private looking = "It begins";
  @state() private place: PictureChoice = "face";
  @state() private share = 0;
  @state() private heat = false;
  @state() private handle = 0;
  /** Raised where points change: they are not Lit's. */
  @state() private step = 0;
  #points = new PhotographPoints([]);
  #left: readonly string[] = [];
  readonly #finder = new PhotographFinder((share) => {
    this.looking = `The face model is loaded: ${Math.round(100 * share)} %`;
  });
  protected readonly words = {
    title: PHOTOGRAPH_TITLE,
    source: "these photographs",
    thrown: "Throw the photographs and their points away? What came from your disk stays there.",
  };

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#finder.close();
    for (const { address } of this.#points.all) URL.revokeObjectURL(address);
  }

  // --- what is asked --------------------------------------------------------------------------------------------------

  protected override async begin(): Promise<SeenPhotographs> {
    if (this.files.length === 0) this.files = await this.#turn();
    if (this.files.length > MOST_PHOTOGRAPHS)
      throw new Error(`${this.files.length} pictures came; bring at most ${MOST_PHOTOGRAPHS} of one person.`);
    const photographs: FoundPhotograph[] = [];
    const left: string[] = [];
    for (const [at, file] of this.files.entries()) {
      this.looking = `Photograph ${at + 1} of ${this.files.length} is looked at`;
      const photograph = await this.#look(file, at);
      if (photograph === null) left.push(noFace(file.name));
      else photographs.push(photograph);
    }
    this.#finder.close(); // its memory is needed for the fit
    if (photographs.length === 0) throw new Error(left.join(" "));
    [this.#points, this.#left, this.looking] = [new PhotographPoints(photographs), left, ""];
    return await this.#kept(bringPhotographs(this.#points, this.store.longRequests));
  }

  /** The pictures of a turn before the camera; none come where the dialog is left. */
  async #turn(): Promise<readonly File[]> {
    const files = await new Promise<readonly File[]>((taken) => {
      this.turned = taken;
    });
    this.turned = null; // the camera's view goes, and the camera with it
    await this.updateComplete;
    return files;
  }

  /** A photograph with its landmarks; null where there is no face in it. */
  async #look(file: File, at: number): Promise<FoundPhotograph | null> {
    const { picture, bitmap } = await readPhotograph(file, (unread) =>
      decodePhotograph(unread, this.store.longRequests),
    );
    if (!this.isConnected) throw new CancelledError("closed meanwhile");
    const { width, height } = bitmap;
    const points = await this.#finder.find(bitmap);
    if (points.length === 0) return null;
    const address = URL.createObjectURL(picture);
    return { name: file.name, file: `${at + 1}.jpg`, picture, address, width, height, points };
  }

  /** What was left out is said with every fit. */
  async #kept(coming: Promise<SeenPhotographs>): Promise<SeenPhotographs> {
    const seen = await coming;
    return { ...seen, notes: [...seen.notes, ...this.#left] };
  }

  protected override fitAgain(seen: SeenPhotographs): Promise<SeenPhotographs> {
    return this.#kept(fitPhotographsAgain(seen, this.#points, this.store.longRequests));
  }

  protected override fitted(): void {
    this.#points.fitted();
    this.place = "face";
  }

  protected override isChanged(): boolean {
    return this.#points.changed;
  }

  // --- what is seen ---------------------------------------------------------------------------------------------------

  protected override beginning(): TemplateResult {
    const { turned } = this;
    if (turned === null) return super.beginning();
    return html`<omote-turn @leave=${() => this.close()}
      @use=${(event: CustomEvent<readonly File[]>) => turned(event.detail)}></omote-turn>`;
  }

  protected override progress(): TemplateResult {
    if (this.looking === "") return super.progress();
    return html`<p role="status">${this.looking} …</p><progress aria-label=${PHOTOGRAPH_TITLE}></progress>
      <button @click=${() => this.escape()}>Cancel</button>`;
  }

  protected override advice(seen: SeenPhotographs) {
    return { advice: photographAdvice(seen, this.#points.changed), note: knowledgeOf(seen) };
  }

  protected override views(seen: SeenPhotographs) {
    const button = (place: PictureChoice, label: string) =>
      html`<button aria-pressed=${this.place === place} @click=${() => (this.place = place)}>${label}</button>`;
    return html`<div class="views">
      ${this.place === "face" ? this.#face(seen) : this.#photograph(this.place)} ${this.waiting()}
      <div class="row show" role="group" aria-label="What is seen">
        ${this.#points.all.map((_, at) => button(at, `Photograph ${at + 1}`))} ${button("face", "Face")}
        ${this.place === "face" ? this.#shares() : html`<b class="grow">${this.#points.all[this.place]?.name}</b>`}
      </div>
      <p id="keys" class="note">${
        this.place === "face"
          ? "Drag to turn it (with Shift: to shift it), wheel or two fingers: closer. Keys: V the next side, + and −."
          : "Drag a round point to where it belongs: what is around it goes along. Keys: Tab to the next point, arrows move it (Shift: further)."
      }</p>
    </div>`;
  }

  #face(seen: SeenPhotographs) {
    return html`<omote-scan-views .scan=${seen} .meshes=${this.store.library?.meshes ?? []}
      .shown=${{ share: this.heat ? 1 : this.share, heat: this.heat }}></omote-scan-views>`;
  }

  #photograph(at: number) {
    return html`<omote-photograph .points=${this.#points} .photograph=${at} .chosen=${this.handle} .step=${this.step}
      @set=${() => this.#changed()} @choose=${(event: CustomEvent<number>) => (this.handle = event.detail)}></omote-photograph>`;
  }

  #shares() {
    const to = (share: number, label: string) =>
      html`<button ?disabled=${this.heat} aria-pressed=${!this.heat && this.share === share} @click=${() => (this.share = share)}>${label}</button>`;
    return html`${to(0, "Colours")}<input type="range" min="0" max="1" step="0.05" aria-label="From the photographs to the plain face" ?disabled=${this.heat}
        .value=${String(this.share)} @input=${(event: Event) => (this.share = Number(textOf(event)))} />${to(1, "Plain")}
      <button aria-pressed=${this.heat} title="Blue: a photograph shows it; grey: it is made up" @click=${() => (this.heat = !this.heat)}>Seen</button>
      ${this.heat ? html`<span class="note">blue: a photograph shows it; grey: made up</span>` : nothing}`;
  }

  protected override corrections() {
    const act = (does: () => void) => () => {
      does();
      this.#changed();
    };
    return html`<header><h2>Points</h2><span class="note">left is the person's own</span></header>
      <p class="note">${this.place === "face" ? "Choose a photograph to see its points." : (HANDLES[this.handle]?.[0] ?? "")}</p>
      <div class="row">
        <button class="grow" ?disabled=${!this.#points.canUndo} @click=${act(() => this.#points.undo())}>Undo</button>
        <button class="grow" ?disabled=${!this.#points.canRedo} @click=${act(() => this.#points.redo())}>Redo</button>
      </div>`;
  }

  #changed(): void {
    this.step += 1;
  }
}
