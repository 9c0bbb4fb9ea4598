import { html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { base, palette } from "../ui/theme";
import { EditorCanvas } from "./canvas/editor_canvas";
import { controls } from "./controls/controls_style";
import { BenchElement } from "./controls/editor_element";
import { style } from "./editor_page_style";
import type { Heading } from "./page/heading";
import { hintOf } from "./page/hints";
import { type Command, commandOf, type View } from "./page/keys";
import type { LibraryPanel } from "./page/library";
import type { Topic } from "./session/draft_store";
import { type Kind, redo, undo } from "./session/item_commands";
import "./page/heading";
import "./page/help";
import "./page/notices_view";
import "./panels/item_panels";
import "./page/library";
import "./page/tools";

/** The editor: what there is on the left, the face under work and its company between, what it is made of on the right. */
@customElement("omote-editor")
export class EditorPage extends BenchElement {
  @state() private helping = false;
  @query("canvas") private canvas!: HTMLCanvasElement;
  @query("omote-library") private library!: LibraryPanel;
  @query("omote-heading") private heading!: Heading;
  #view: EditorCanvas | null = null;
  /** The item that was open when the page was last drawn. */
  #open = -1;

  static override styles = [palette, base, controls, style];

  protected override topics(): readonly Topic[] {
    return ["draft", "options", "cast", "link"];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener("keydown", this.#key);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener("keydown", this.#key);
    this.#view?.dispose();
  }

  override updated(): void {
    const open = this.bench.draft?.item ?? -1;
    if (open >= 0 && open !== this.#open) this.scrollIntoView({ block: "start" }); // on a phone the faces may be far above
    this.#open = open;
    this.classList.toggle("lost", !this.bench.online);
    if (this.#view === null && this.bench.library !== null) this.#view = new EditorCanvas(this.canvas, this.bench);
  }

  override render() {
    const { bench, rig } = this;
    return html`
      <omote-heading class="panel" .rig=${rig} @help=${this.#toggleHelp}></omote-heading>
      <omote-library class="panel" .rig=${rig}></omote-library>
      <main class="panel">
        <omote-tools .rig=${rig} @view=${(event: CustomEvent<View>) => this.#view?.view(event.detail)}></omote-tools>
        <div class="work">
          <canvas tabindex="0" aria-label="The face under work and the faces beside it" aria-describedby="hint"></canvas>
          ${bench.look === null ? nothing : this.#looking()}
        </div>
        <p id="hint" class="hint">${hintOf(bench, matchMedia("(pointer: coarse)").matches)}</p>
      </main>
      <div class="side">
        <omote-panels class="panel" .rig=${rig}
          @make=${(event: CustomEvent<Kind>) => this.library.make({}, event.detail)}></omote-panels>
        <omote-notices .rig=${rig}></omote-notices>
      </div>
      ${this.helping ? html`<omote-editor-help .rig=${rig} @close=${this.#toggleHelp}></omote-editor-help>` : nothing}
    `;
  }

  #looking() {
    return html`<div class="looking" role="status">You look at an old revision, not at your draft.
      <button @click=${() => this.bench.setLook(null)}>Back to my draft</button></div>`;
  }

  readonly #toggleHelp = (): void => {
    this.helping = !this.helping;
  };

  readonly #key = (event: KeyboardEvent): void => {
    const command = commandOf(event, isTyping(event));
    if (command === null) return;
    if (command.do !== "leave") event.preventDefault();
    this.#obey(command);
  };

  #obey(command: Command): void {
    const { bench } = this;
    if (command.do === "undo") undo(bench);
    else if (command.do === "redo") redo(bench);
    else if (command.do === "save") this.#save();
    else if (command.do === "help") this.#toggleHelp();
    else if (command.do === "search") this.library.focus();
    else if (command.do === "leave") this.#leave();
    else if (command.do === "tool") bench.setOptions({ tool: command.tool });
    else if (command.do === "view") this.#view?.view(command.view);
    else bench.setOptions({ [command.do]: !bench.options[command.do] });
  }

  #save(): void {
    const active = this.heading.shadowRoot?.activeElement;
    if (active instanceof HTMLElement) active.blur(); // what is being typed belongs to it
    if (this.bench.draft !== null) this.heading.save();
  }

  /** One step out: of the help, a drag, the old revision, the selection. */
  #leave(): void {
    const { bench } = this;
    if (this.helping) this.helping = false;
    else if (bench.dragging) bench.cancel();
    else if (bench.look !== null) bench.setLook(null);
    else if (bench.selection.size > 0) bench.select([]);
  }
}

/** True while a key press belongs to a field for text. */
function isTyping(event: KeyboardEvent): boolean {
  const typed = (target: EventTarget): boolean =>
    target instanceof HTMLTextAreaElement ||
    (target instanceof HTMLInputElement && !["range", "checkbox", "radio"].includes(target.type));
  return event.composedPath().some(typed);
}
