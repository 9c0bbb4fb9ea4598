/** The panel that exports the open item as downloads, and takes files in. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { ACCEPTED, type ImportKind } from "../../ui/file_import";
import { CancelledError } from "../../ui/long_requests";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import type { Topic } from "../session/draft_store";
import { takeIn } from "../session/item_commands";
import { credit, download, type Export, exportsOf, IMPORT_COMMAND, LICENCES } from "./exports";

const style = css`
  .command {
    display: grid;
    grid-template-columns: 1fr auto;
    gap: 4px;
  }
  .credit {
    display: grid;
    grid-template-columns: 1fr 1fr;
    gap: 4px;
    grid-column: 1 / -1;
  }
  .refused {
    grid-column: 1 / -1;
    color: var(--attention);
  }
  .button {
    position: relative;
    display: grid;
    place-content: center;
    min-height: 26px;
    padding: 0 8px;
    border: 1px solid var(--line);
    border-radius: 4px;
    color: var(--dim);
    background: var(--raised);
    overflow: hidden;
  }
  .button:focus-within {
    outline: 2px solid var(--focus);
    outline-offset: 1px;
  }
  .button input {
    position: absolute;
    inset: 0;
    opacity: 0;
    cursor: pointer;
  }
  @media (pointer: coarse) {
    .button {
      min-height: 40px;
    }
  }
  code {
    font-size: 11.5px;
    overflow-wrap: anywhere;
    user-select: text;
  }
`;

/** How the open item gets out of the show, and others in. */
@customElement("omote-exchange")
export class ExchangePanel extends EditorElement {
  static override styles = [base, controls, panel, style];

  /** The address of the export, or the kind of import, that is under way; empty: none. */
  @state() private busy = "";
  /** What an avatar names: its author, by commas, and who may use it. */
  @state() private author = "";
  @state() private licence = LICENCES[0]?.[0] ?? "";

  protected override readonly topics: readonly Topic[] = ["draft", "items", "cast"];

  override render() {
    const { draft, item, work } = this.store;
    return html`
      ${item?.head === 0 ? html`<p class="note">Save first: only what is saved goes out.</p>` : nothing}
      ${draft?.dirty === true && (item?.head ?? 0) > 0 ? html`<p class="note behind">What goes out is your last save: save first for what you see.</p>` : nothing}
      ${item === null ? nothing : exportsOf(item, work, this.store.unwritable).map((exported) => this.#export(exported, item.head === 0))}
      <p>In, from files by other crews and other programs; or drop them on this page:</p>
      ${this.#import("expression", "Expressions: documents (JSON), heads with shapes (GLB)")}
      ${this.#import("face", "A face: a head of Omote at rest (GLB, OBJ)")}
      <div class="command"><span class="note">A person: a scan, any mesh of a head (PLY, STL, OBJ, GLB, VRM, XYZ)</span>
        <omote-scan-button></omote-scan-button></div>
      <div class="command"><span class="note">A person: one to eight photographs (JPEG, PNG)</span>
        <omote-scan-button of="photographs"></omote-scan-button></div>
      <div class="command"><span class="note">A person: a turn of the head before this computer's camera</span>
        <omote-scan-button of="camera"></omote-scan-button></div>
      <p class="note">A head at rest and a shape each as OBJ come in together, on the show's computer while no show plays: <code>${IMPORT_COMMAND}</code></p>
    `;
  }

  #import(kind: ImportKind, what: string) {
    return html`<div class="command">
      <span class="note">${what}</span>
      <label class="button" ?inert=${this.busy !== ""}>${this.busy === kind ? "Importing ..." : "Import"}<input
        type="file" multiple aria-label="Import ${kind === "face" ? "faces" : "expressions"}" accept=${ACCEPTED[kind]}
        @change=${(event: Event) => this.#take(event, kind)} /></label>
    </div>`;
  }

  async #take(event: Event, kind: ImportKind): Promise<void> {
    const field = event.target as HTMLInputElement;
    this.busy = kind;
    await takeIn(this.store, [...(field.files ?? [])], kind);
    this.busy = "";
    field.value = ""; // the same file again is a change too
  }

  #export(exported: Export, unsaved: boolean) {
    const busy = this.busy === exported.address;
    return html`<div class="command">
      <span class="note">${exported.what}</span>
      <button aria-label="Download ${exported.file}" ?disabled=${unsaved || this.busy !== "" || exported.unwritable !== undefined} @click=${() => this.#download(exported)}>
        ${busy ? "Exporting ..." : `Download ${exported.file.slice(exported.file.lastIndexOf("."))}`}
      </button>
      ${exported.unwritable === undefined ? nothing : html`<span class="note refused">Not on the show's computer: ${exported.unwritable}.</span>`}
      ${exported.credited ? this.#credit() : nothing}
    </div>`;
  }

  #credit() {
    return html`<div class="credit">
      <input type="text" aria-label="Author of the avatar" placeholder="Its author" maxlength="200" .value=${this.author}
        @input=${(event: Event) => (this.author = textOf(event))} />
      <select aria-label="Who may use the avatar" @change=${(event: Event) => (this.licence = textOf(event))}>
        ${LICENCES.map(([value, what]) => html`<option value=${value} ?selected=${value === this.licence}>${what}</option>`)}
      </select>
    </div>`;
  }

  async #download(exported: Export): Promise<void> {
    this.busy = exported.address;
    try {
      await download(credit(exported, { author: this.author, licence: this.licence }), this.store.longRequests);
      this.store.say(`${exported.file} is in your downloads.`, "done");
    } catch (error) {
      this.store.say((error as Error).message, error instanceof CancelledError ? "done" : "refusal");
    } finally {
      this.busy = "";
    }
  }
}
