/** The notes of a show, the newest last as they were said: each is read, changed, deleted, and looked at in a replay. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { clockOf, sinceOf } from "../ui/show_times";
import { base, entry } from "../ui/theme";
import type { TimedNote } from "./note_texts";

const style = css`
  li {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr) auto;
    align-items: center;
    gap: 2px 10px;
    padding: 4px 0;
    border-bottom: 1px solid var(--line);
  }
  .when {
    display: grid;
    align-content: center;
    justify-items: start;
    min-width: 76px;
    min-height: 44px;
    padding: 0 8px;
    color: var(--text);
    text-align: left;
  }
  .when small {
    color: var(--dim);
  }
  span.when {
    padding-left: 0;
  }
  p {
    font-size: 16px;
    line-height: 1.35;
    overflow-wrap: anywhere;
    user-select: text;
    -webkit-user-select: text;
  }
  p small {
    color: var(--dim);
    white-space: nowrap;
  }
  .tools {
    display: flex;
    gap: 4px;
  }
  .tools button {
    min-width: 44px;
    min-height: 44px;
  }
  input {
    ${entry}
    width: 100%;
    min-height: 44px;
    font-size: 16px;
  }
  .none {
    padding: 14px 0;
    color: var(--dim);
  }
  @media print {
    .tools {
      display: none;
    }
    li {
      break-inside: avoid;
    }
  }
`;

/**
 * Tells `seek` (the note), `rename` ({ note, name }) and `delete` (the note). `mayChange`: whose notes may be changed;
 * `seeks`: whether there is a replay that goes to a note.
 */
@customElement("omote-note-list")
export class NoteList extends LitElement {
  static override styles = [base, style];
  @property({ attribute: false }) notes: readonly TimedNote[] = [];
  @property({ attribute: false }) mayChange: (note: TimedNote) => boolean = () => false;
  @property({ type: Boolean }) seeks = false;
  @state() private edited: number | undefined;

  override render() {
    if (this.notes.length === 0) return html`<p class="none">No notes yet.</p>`;
    return html`<ul aria-label="Notes">${repeat(
      this.notes,
      ({ id }) => id,
      (note) => this.#row(note),
    )}</ul>`;
  }

  #row(note: TimedNote) {
    const since = sinceOf(note.since);
    const when = html`${since}<small>${note.cue === "" ? clockOf(new Date(note.written * 1000)) : `cue ${note.cue}`}</small>`;
    return html`<li>
      ${
        this.seeks
          ? html`<button class="when" title="Look at it" aria-label="Look at ${since}: ${note.name}" @click=${() => this.#tell("seek", note)}>${when}</button>`
          : html`<span class="when">${when}</span>`
      }
      ${
        this.edited === note.id
          ? html`<input aria-label="What it says" maxlength="400" .value=${note.name} @keydown=${(event: KeyboardEvent) => this.#key(event, note)} @change=${(event: Event) => this.#rename(event, note)}>`
          : html`<p>${note.name} <small>${note.who}</small></p>`
      }
      ${this.mayChange(note) ? this.#tools(note) : nothing}
    </li>`;
  }

  #tools(note: TimedNote) {
    const edits = this.edited === note.id;
    return html`<span class="tools">
      <button aria-label="Change: ${note.name}" aria-pressed=${edits} title="Change what it says" @click=${() => this.#edit(edits ? undefined : note.id)}>✎</button>
      <button aria-label="Delete: ${note.name}" title="Delete" @click=${() => this.#tell("delete", note)}>✕</button>
    </span>`;
  }

  #edit(id: number | undefined): void {
    this.edited = id;
    void this.updateComplete.then(() => this.renderRoot.querySelector("input")?.focus());
  }

  /** Escape leaves it as it was; the field is then gone before it tells of a change. */
  #key(event: KeyboardEvent, note: TimedNote): void {
    if (event.key === "Escape") {
      (event.target as HTMLInputElement).value = note.name;
      this.#edit(undefined);
    } else if (event.key === "Enter" && !event.isComposing) (event.target as HTMLInputElement).blur();
  }

  #rename(event: Event, note: TimedNote): void {
    const name = (event.target as HTMLInputElement).value.trim();
    this.edited = undefined;
    if (name !== "" && name !== note.name) this.#tell("rename", { note, name });
  }

  #tell(what: string, detail: unknown): void {
    this.dispatchEvent(new CustomEvent(what, { detail }));
  }
}
