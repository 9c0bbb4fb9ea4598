/** The notes page: a director types what has to be better, while the show plays, and reads it afterwards. */

import { html, LitElement, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { keep, readKept } from "../../ui/browser_storage";
import { sinceOf } from "../../ui/show_times";
import { base, palette, toolPage } from "../../ui/theme";
import { hearWhileShown, textOf } from "../../ui/topic_element";
import { WakeLock } from "../../ui/wake_lock";
import { NoteBook } from "../note_book";
import { notesAsTable, notesAsText, type TimedNote } from "../note_texts";
import { dayOf } from "../recordings";
import { notesPageStyle } from "./notes_page_style";
import { Stamp } from "./stamp";
import "../note_list";

const NAME = "omote-notes-name";

@customElement("omote-notes-page")
export class NotesPage extends LitElement {
  static override styles = [palette, base, toolPage, notesPageStyle];
  @state() private shown: number | "all" | undefined;
  @state() private who = readKept(() => localStorage, NAME);
  @query("#note") private field!: HTMLInputElement | null;
  readonly book = new NoteBook(this);
  readonly #stamp = new Stamp(() => performance.now());

  constructor() {
    super();
    new WakeLock(); // a tablet's screen stays on
    hearWhileShown<KeyboardEvent>(this, window, ["keydown"], this.#key);
  }

  override firstUpdated(): void {
    if (matchMedia("(pointer: fine)").matches) this.field?.focus(); // no keyboard jumps up on a tablet
  }

  override render() {
    const { book } = this;
    const { document, failure } = book;
    const starts = [...new Set(document.spans.map(({ start }) => start))].reverse();
    const notes = this.#notes();
    return html`<header>
        <h1>NOTES</h1>
        <nav>${book.live ? html`<a href="/console" target="omote-console">Console</a>` : html`<a href="/replay" target="omote-replay">Replay</a>`}<a href="/runs" target="omote-runs">Runs</a></nav>
        <span class="air">${book.live ? html`${document.cue === "" ? "No cue yet" : html`Cue <b>${document.cue}</b>`}` : "A replay"}</span>
      </header>
      ${failure === "" ? nothing : html`<p class="lost" role="alert">${failure}</p>`}
      ${book.live ? this.#form() : nothing}
      <div class="row tools">
        <select aria-label="Which show" @change=${this.#choose}>
          ${starts.map((start, place) => html`<option value=${start} ?selected=${start === this.#start()}>${place === 0 ? "The last start" : this.#day(start)}</option>`)}
          <option value="all" ?selected=${this.shown === "all"}>All</option>
        </select>
        <span class="count">${notes.length === 1 ? "1 note" : `${notes.length} notes`}</span>
        <button ?disabled=${notes.length === 0} @click=${() => save("notes.txt", notesAsText(notes))}>Text</button>
        <button ?disabled=${notes.length === 0} @click=${() => save("notes.csv", notesAsTable(notes))}>CSV</button>
        <button ?disabled=${notes.length === 0} @click=${() => print()}>Print</button>
        ${book.deleted === undefined ? nothing : html`<button class="restore" @click=${() => book.restore()}>Bring back “${book.deleted.name}”</button>`}
      </div>
      <omote-note-list .notes=${book.live ? [...notes].reverse() : notes} .mayChange=${book.mayChange} ?seeks=${!book.live}
        @seek=${(event: CustomEvent<TimedNote>) => book.seek(event.detail)}
        @delete=${(event: CustomEvent<TimedNote>) => book.delete(event.detail)}
        @rename=${(event: CustomEvent<{ note: TimedNote; name: string }>) => book.rename(event.detail.note, event.detail.name)}
      ></omote-note-list>`;
  }

  #form() {
    const { name } = this.book.document;
    const begun = this.#stamp.seconds();
    return html`<form @submit=${this.#add}>
      <label class="note">Note
        <input id="note" maxlength="400" autocomplete="off" enterkeyhint="send" placeholder="What has to be better?" @input=${this.#typed}>
      </label>
      ${name === "" ? html`<label>Your name <input class="who" maxlength="40" autocomplete="name" .value=${this.who} @change=${this.#called}></label>` : nothing}
      <button class="add" title="Note it (Enter)">Note</button>
      <span class="stamp" role="status">${begun === undefined ? "" : "stamped when you began to type"}</span>
    </form>`;
  }

  /** The start of the show whose notes are shown; undefined for all. */
  #start(): number | undefined {
    if (this.shown === "all") return undefined;
    return this.shown ?? this.book.document.spans.at(-1)?.start;
  }

  #notes(): TimedNote[] {
    return this.book.notes(this.#start());
  }

  #day(start: number): string {
    const span = this.book.document.spans.find((each) => each.start === start);
    return span === undefined ? "" : `${dayOf(span.written)}, ${sinceOf(span.seconds)}`;
  }

  readonly #choose = (event: Event): void => {
    const chosen = textOf(event);
    this.shown = chosen === "all" ? "all" : Number(chosen);
  };

  readonly #called = (event: Event): void => {
    this.who = textOf(event).trim();
    keep(() => localStorage, NAME, this.who);
  };

  readonly #typed = (event: Event): void => {
    this.#stamp.type(textOf(event));
    this.requestUpdate();
  };

  readonly #add = async (event: Event): Promise<void> => {
    event.preventDefault();
    const { field } = this;
    const words = field?.value.trim() ?? "";
    if (field === null || words === "") return;
    const before = this.#stamp.seconds() ?? 0;
    field.value = ""; // the next one can begin while this one is on its way
    this.#stamp.type("");
    const written = await this.book.add(words, before, this.who);
    if (!written && field.value === "") {
      field.value = words; // nothing that was typed is lost
      this.#stamp.begin(before);
    }
    field.focus();
  };

  /** A slash goes to the field, as on other pages to the search. */
  readonly #key = (event: KeyboardEvent): void => {
    const [element] = event.composedPath();
    if (event.key !== "/" || element instanceof HTMLInputElement || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    this.field?.focus();
  };
}

/** Gives a text to the browser to save. */
function save(name: string, text: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/plain;charset=utf-8" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 0);
}
