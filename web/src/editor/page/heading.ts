/** The heading of the editor: the open item, whether it is saved, who else edits it. */

import { html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { live } from "lit/directives/live.js";
import type { DraftState, ItemDocument } from "../../link/editing_messages";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { controls } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import type { Topic } from "../session/draft_store";
import { describe, nextUndo, othersOf, redo, save, undo } from "../session/item_commands";
import { style } from "./heading_style";

/** The head of the page: what is open, whether it is saved, who else is at it. */
@customElement("omote-heading")
export class Heading extends EditorElement {
  @state() private note = "";

  static override styles = [base, controls, style];

  protected override readonly topics: readonly Topic[] = ["draft", "items", "link", "options"];

  override render() {
    const { store } = this;
    const { item, draft } = store;
    return html`
      <div class="mark ${draft === null ? "" : "beside"}">OMOTE <small>EDITOR</small></div>
      ${store.online ? nothing : html`<div class="lost" role="alert">LINK LOST – what you do waits here</div>`}
      ${item === null || draft === null ? html`<span class="grow"></span>${nextUndo(store) === "" ? nothing : this.#steps(0)}` : this.#open(item, draft)}
      <label class="you" title="Other editors read this name">You:
        <input aria-label="Your name" maxlength="64" .value=${this.context.name()} @change=${this.#rename} /></label>
      <a class="console" href="/console" target="_blank" title="Play what is saved">Console</a>
      <button class="icon" title="Keys (?)" aria-label="Keys" @click=${() => this.tell("help")}>?</button>
    `;
  }

  #open(item: ItemDocument, draft: DraftState) {
    const { store } = this;
    const { dirty } = draft;
    const others = othersOf(item.editors, this.context.name());
    return html`
      <span class="dot ${dirty ? "dirty" : ""}" role="img" title=${dirty ? "Not saved yet" : "Saved"}
        aria-label=${dirty ? "Not saved yet" : "Saved"}></span>
      <input class="label" aria-label="Name" title="Rename" maxlength="64" .value=${live(item.label)}
        @change=${(event: Event) => this.#relabel(item, textOf(event))} />
      <input class="tags" aria-label="Tags" placeholder="tags" title="Tags to find it by, with commas between them" .value=${item.tags.join(", ")}
        @change=${(event: Event) => void describe(store, item, { tags: tagsOf(textOf(event)) })} />
      ${others.length === 0 ? nothing : html`<span class="others" role="status">${others.join(", ")} ${others.length === 1 ? "is" : "are"} at it too</span>`}
      <span class="grow"></span>
      ${this.#steps(draft.redo)}
      <input class="remark" aria-label="Note" title="What you say of this save, if you like" placeholder="note" maxlength="200" .value=${this.note}
        @input=${(event: Event) => (this.note = textOf(event))}
        @keydown=${(event: KeyboardEvent) => (event.key === "Enter" ? this.save() : nothing)} />
      <button class="main save" title="Save (Ctrl S): it plays from now on" ?disabled=${!dirty && item.head > 0}
        @click=${() => this.save()}>Save</button>
    `;
  }

  #steps(forward: number) {
    const what = nextUndo(this.store);
    const next = this.store.undone.at(-1) ?? "";
    return html`<div class="steps">
      <button data-step="undo" ?disabled=${what === ""} title=${what === "" ? "Nothing to undo" : `Undo: ${what} (Ctrl Z)`} aria-label=${what === "" ? "Undo" : `Undo: ${what}`}
        @click=${() => undo(this.store)}>↶ <span>${what === "" ? "Undo" : what}</span></button>
      <button data-step="redo" ?disabled=${forward === 0} title=${forward === 0 ? "Nothing to redo" : `Redo: ${next} (Ctrl Shift Z)`} aria-label=${forward === 0 ? "Redo" : `Redo: ${next}`}
        @click=${() => redo(this.store)}>↷ <span>${forward === 0 ? "Redo" : next || "Redo"}</span></button>
    </div>`;
  }

  save(): void {
    void save(this.store, this.note);
    this.note = "";
  }

  #relabel(item: ItemDocument, label: string): void {
    if (label.trim() === "") this.requestUpdate();
    else void describe(this.store, item, { label: label.trim() });
  }

  readonly #rename = (event: Event): void => {
    const name = textOf(event).trim();
    if (name !== "") this.context.rename(name);
  };
}

/** Tags as they are typed: between commas, each once. */
export const tagsOf = (text: string): string[] => [
  ...new Set(
    text
      .split(",")
      .map((tag) => tag.trim())
      .filter(Boolean),
  ),
];
