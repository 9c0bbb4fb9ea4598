/** The editor's page: library, canvas and panels. */

import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { keyed } from "lit/directives/keyed.js";
import { type ImportKind, onFileDrop } from "../ui/file_import";
import { listenToKeys } from "../ui/key_presses";
import type { ShowNoticesView } from "../ui/show_notices_view";
import { base, palette } from "../ui/theme";
import { whileShown } from "../ui/topic_element";
import { exposeProbe } from "./canvas/canvas_probe";
import { EditorCanvas } from "./canvas/editor_canvas";
import { controls } from "./controls/controls_style";
import { EditorElement } from "./controls/editor_element";
import { style } from "./editor_page_style";
import type { Heading } from "./page/heading";
import { hintOf } from "./page/hints";
import type { ItemListPanel } from "./page/item_list";
import { commandOf, type EditorCommand, type ViewKey } from "./page/keys";
import type { PoseWork } from "./pose/pose_work";
import { arePhotographs, comingOf } from "./scan/data/dropped_files";
import type { Topic } from "./session/draft_store";
import { type Kind, redo, takeIn, takeInHead, undo } from "./session/item_commands";
import type { EditorNotice } from "./session/notices";
import "./page/heading";
import "./page/help";
import "./page/loading_view";
import "./page/notices_view";
import "./panels/item_panels";
import "./page/item_list";
import "./page/tools";
import "./pose/pose_work";
import "./scan/photograph_dialog";
import "./scan/scan_button";
import "./scan/scan_dialog";

const OLD = "You look at an old revision, not at your draft.";

/** The editor: what there is on the left, the face under work and those beside it between, what it is made of on the right. */
@customElement("omote-editor")
export class EditorPage extends EditorElement {
  /** The notices of the show, which have their place above those of the work. */
  @property({ attribute: false }) notices!: ShowNoticesView;
  @state() private helping = false;
  /** The files of the scan, or the photographs, that are looked at, none where the camera takes them; null: no dialog. */
  @state() private scan: readonly File[] | null = null;
  /** Whether what is open is drawn, with all faces beside it. */
  @state() private loaded = false;
  /** Whether the face on the canvas is the one before a change of its mix. */
  @state() private making = false;
  @query("canvas") private canvas!: HTMLCanvasElement;
  @query("omote-pose-work") private figure!: PoseWork | null;
  @query("omote-item-list") private library!: ItemListPanel;
  @query("omote-heading") private heading!: Heading;
  @query("omote-scan, omote-photographs") private dialog!: { refuse(sentence: string): void } | null;
  #view: EditorCanvas | null = null;
  /** The item that was open when the page was last drawn. */
  #open = -1;

  static override styles = [palette, base, controls, style];

  protected override readonly topics: readonly Topic[] = ["draft", "options", "cast", "link"];

  constructor() {
    super();
    whileShown(this, () => listenToKeys({ page: this.#key }));
    whileShown(this, () =>
      onFileDrop(
        (files) => void this.#receive(files),
        (sentence) => this.store.say(sentence),
      ),
    );
    whileShown(this, () => () => this.#view?.dispose());
  }

  override updated(): void {
    const open = this.store.draft?.item ?? -1;
    if (open >= 0 && open !== this.#open) this.scrollIntoView({ block: "start" }); // on a phone the faces may be far above
    this.#open = open;
    this.classList.toggle("lost", !this.store.online);
    if (this.#view === null && this.store.library !== null) {
      const shows = (whole: boolean): void => {
        this.loaded = whole;
      };
      const makes = (still: boolean): void => {
        this.making = still;
      };
      this.#view = new EditorCanvas(this.canvas, this.store, shows, makes);
      exposeProbe(this.#view);
    }
  }

  override render() {
    const { store, context } = this;
    return html`
      <omote-heading class="panel" .context=${context} @help=${this.#toggleHelp}></omote-heading>
      <omote-item-list class="panel" .context=${context}
        @scan=${(event: CustomEvent<readonly File[]>) => this.#openScan(event.detail)}></omote-item-list>
      <main class="panel">
        <omote-tools .context=${context} @view=${(event: CustomEvent<ViewKey>) => this.#look(event.detail)}></omote-tools>
        <div class="work">
          <canvas tabindex="0" aria-label="The face under work and the faces beside it" aria-describedby="hint"></canvas>
          ${store.pose === null ? nothing : html`<omote-pose-work .context=${context}></omote-pose-work>`}
          ${this.loaded || store.pose !== null ? nothing : html`<omote-loading .faces=${store.face === null ? 1 + store.neighbours.length : 1}></omote-loading>`}
          ${this.loaded && this.making ? html`<omote-making></omote-making>` : nothing}
          ${store.look === null && store.layerPreview.solo.size === 0 ? nothing : this.#looking()}
        </div>
        <p id="hint" class="hint">${hintOf(store, matchMedia("(pointer: coarse)").matches)}</p>
      </main>
      <div class="side">
        <omote-panels class="panel" .context=${context}
          @make=${(event: CustomEvent<Kind>) => this.library.make({}, event.detail)}
          @scan=${(event: CustomEvent<readonly File[]>) => this.#openScan(event.detail)}></omote-panels>
        <div class="told">${this.notices}<omote-notices .context=${context}></omote-notices></div>
      </div>
      ${this.scan === null ? nothing : this.#person(this.scan)}
      ${this.helping ? html`<omote-editor-help .context=${context} @close=${this.#toggleHelp}></omote-editor-help>` : nothing}
    `;
  }

  /** The dialog in which somebody's face is made. */
  #person(files: readonly File[]) {
    const close = (): void => {
      this.scan = null;
    };
    const instead = (event: CustomEvent<readonly File[]>): void => {
      this.scan = event.detail;
    };
    return files.length === 0 || arePhotographs(files.map(({ name }) => name))
      ? keyed(
          files,
          html`<omote-photographs .context=${this.context} .files=${files} @close=${close} @scan=${instead}></omote-photographs>`,
        )
      : html`<omote-scan .context=${this.context} .files=${files} @close=${close}></omote-scan>`;
  }

  /** Takes in what is dropped; a head that is not of our topology is a scan. */
  async #receive(files: readonly File[]): Promise<void> {
    const open = importable(this.store.item?.kind);
    const kind = open ?? importable(this.library.kind) ?? "expression";
    const names = files.map(({ name }) => name);
    const coming = comingOf(names, open);
    if (coming === "scan") this.#openScan(files);
    else if (coming === "import") await takeIn(this.store, files, kindOf(files, kind), this.#otherwise(files));
    else if (!(await takeInHead(this.store, files[0] as File, kind))) this.#openScan(files);
  }

  /** What else can be done with a head that is no expression. */
  #otherwise(files: readonly File[]): EditorNotice["actions"] {
    const names = files.map(({ name }) => name);
    const isHead = comingOf(names, null) !== "import";
    return isHead ? [{ label: "Make a face of it", act: () => this.#openScan(files) }] : [];
  }

  #openScan(files: readonly File[]): void {
    if (this.scan === null) this.scan = files;
    else this.dialog?.refuse("Somebody's face is being made here: take it or throw it away first.");
  }

  #looking() {
    const { look, recipe, layerPreview } = this.store;
    const alone = [...layerPreview.solo].map((place) => `"${recipe?.layers[place]?.label ?? ""}"`).join(", ");
    const what = look === null ? `Solo: you see ${alone} alone, without needles and muscles.` : OLD;
    return html`<div class="looking" role="status">${what}
      <button @click=${() => this.#showDraft()}>Back to my draft</button></div>`;
  }

  #showDraft(): void {
    this.store.layerPreview.end();
    this.store.setLook(null);
  }

  readonly #toggleHelp = (): void => {
    this.helping = !this.helping;
  };

  readonly #key = (event: KeyboardEvent, typing: boolean): void => {
    const command = commandOf(event, typing);
    if (command === null) return;
    if (command.do !== "leave") event.preventDefault();
    this.#obey(command);
  };

  #obey(command: EditorCommand): void {
    const { store } = this;
    if (command.do === "undo") undo(store);
    else if (command.do === "redo") redo(store);
    else if (command.do === "save") this.#save();
    else if (command.do === "help") this.#toggleHelp();
    else if (command.do === "search") this.library.focus();
    else if (command.do === "leave") this.#leave();
    else if (command.do === "tool") store.setOptions({ tool: command.tool });
    else if (command.do === "view") this.#look(command.view);
    else store.setOptions({ [command.do]: !store.options[command.do] });
  }

  /** Shows what is under work from a side. */
  #look(key: ViewKey): void {
    if (this.figure === null) this.#view?.view(key);
    else this.figure.view(key);
  }

  #save(): void {
    const active = this.heading.shadowRoot?.activeElement;
    if (active instanceof HTMLElement) active.blur(); // what is being typed belongs to it
    if (this.store.draft !== null) this.heading.save();
  }

  /** One step out: of a drag, the old revision, the selection. */
  #leave(): void {
    const { store } = this;
    if (store.dragging) store.cancel();
    else if (store.look !== null || store.layerPreview.solo.size > 0) this.#showDraft();
    else if (store.selection.size > 0) store.select([]);
  }
}

/** What files can bring: poses come in with whole shows. */
const importable = (kind: Kind | undefined): ImportKind | null => (kind === undefined || kind === "pose" ? null : kind);

/** Documents are expressions; a head is what is under work. */
const kindOf = (files: readonly File[], open: ImportKind): ImportKind =>
  files.some(({ name }) => name.toLowerCase().endsWith(".json")) ? "expression" : open;
