/** The replay page: the stage of a recording over its line of time, with pause, seek, rate, loop and moments. */

import { html, LitElement, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { NoteBook } from "../rehearsal/note_book";
import type { TimedNote } from "../rehearsal/note_texts";
import { listenToKeys } from "../ui/key_presses";
import { sinceOf } from "../ui/show_times";
import { base, palette } from "../ui/theme";
import { whileShown } from "../ui/topic_element";
import { pageStyle } from "./replay_page_style";
import { type Asked, askedBy, type Moment, RATES, type Transport, within, wordsOf } from "./transport";
import "../rehearsal/note_list";

const TRANSPORT = "/replay/transport";
const MOMENTS = "/replay/moments";
/** Milliseconds between two questions of how far it is. */
const POLL = 200;

@customElement("omote-replay-page")
export class ReplayPage extends LitElement {
  static override styles = [palette, base, pageStyle];
  @state() private accessor now: Transport | undefined;
  @state() private accessor moments: Moment[] = [];
  @state() private accessor failure = "";
  @state() private accessor under: number | undefined;
  /** Whether the notes stand beside the picture. */
  @state() private accessor notes = false;
  private readonly book = new NoteBook(this);
  #momentsOf = "";

  constructor() {
    super();
    whileShown(this, () => listenToKeys({ page: (event, typing) => !typing && this.#press(event) }));
    whileShown(this, () => {
      const polling = setInterval(() => void this.#ask(), POLL);
      return () => clearInterval(polling);
    });
  }

  /** Moments are read again where another start plays, and where notes have changed. */
  protected override updated(): void {
    const of = JSON.stringify([this.now?.start, this.now?.first, this.book.document.markers]);
    if (this.now === undefined || of === this.#momentsOf) return;
    this.#momentsOf = of;
    void this.#read<Moment[]>(MOMENTS).then((moments) => {
      this.moments = moments ?? this.moments;
    });
  }

  override render() {
    const now = this.now;
    return html`<div class="picture"><iframe src="/stage" title="The recording"></iframe>${this.notes ? this.#notes() : nothing}</div>
      <footer>
        <div class="row">
          <button class="play" aria-pressed=${now?.playing ?? false} title="Play or pause (space bar)"
            @click=${() => this.#ask({ playing: !this.now?.playing })}>${now?.playing ? "Pause" : "Play"}</button>
          <button title="The moment before (,)" @click=${() => this.#do("Comma")}>◂◂</button>
          <button title="The next moment (.)" @click=${() => this.#do("Period")}>▸▸</button>
          <span class="time">${sinceOf(now?.position ?? 0)} / ${sinceOf(now?.seconds ?? 0)}</span>
          <select aria-label="Rate" @change=${this.#setRate}>${RATES.map(
            (rate) => html`<option value=${rate} ?selected=${rate === (now?.rate ?? 1)}>×${rate}</option>`,
          )}</select>
          <button title="The loop begins here (I)" @click=${() => this.#do("KeyI")}>Loop from</button>
          <button title="The loop ends here (O)" @click=${() => this.#do("KeyO")}>to</button>
          <button title="No loop (L)" ?disabled=${!now?.loop.length} @click=${() => this.#do("KeyL")}>No loop</button>
          <button title="Notes (N)" aria-pressed=${this.notes} @click=${() => this.#do("KeyN")}>Notes</button>
          <a href="/runs" target="omote-runs" title="Compare it with another run">Runs</a>
          ${this.#said(now)}
        </div>
        ${now === undefined ? nothing : this.#line(now)}
      </footer>`;
  }

  #notes() {
    const { book } = this;
    return html`<aside>
      <form @submit=${this.#add}><input aria-label="A note of this moment" placeholder="A note of this moment" maxlength="400" autocomplete="off"><button>Note</button></form>
      ${book.failure === "" ? nothing : html`<p class="wrong" role="alert">${book.failure}</p>`}
      ${book.deleted === undefined ? nothing : html`<button @click=${() => book.restore()}>Bring back “${book.deleted.name}”</button>`}
      <omote-note-list .notes=${book.notes(this.now?.start)} .mayChange=${book.mayChange} seeks
        @seek=${(event: CustomEvent<TimedNote>) => book.seek(event.detail)}
        @delete=${(event: CustomEvent<TimedNote>) => book.delete(event.detail)}
        @rename=${(event: CustomEvent<{ note: TimedNote; name: string }>) => book.rename(event.detail.note, event.detail.name)}
      ></omote-note-list>
    </aside>`;
  }

  readonly #add = async (event: Event): Promise<void> => {
    event.preventDefault();
    const field = (event.target as HTMLFormElement).querySelector("input");
    const { now } = this;
    if (field === null || field.value.trim() === "" || now === undefined) return;
    if (await this.book.addAt(field.value.trim(), now.start, now.first + now.position, "")) field.value = "";
  };

  #said(now: Transport | undefined) {
    const wrong = this.failure || now?.failure || differenceOf(now);
    if (wrong) return html`<span class="said wrong" role="alert" title=${wrong}>${wrong}</span>`;
    const last = this.moments.filter(({ at }) => at <= (this.under ?? now?.position ?? 0)).pop();
    return html`<span class="said">${last === undefined ? "" : `${sinceOf(last.at)} ${wordsOf(last)}`}</span>`;
  }

  #line(now: Transport) {
    const at = (seconds: number) => `left: ${(100 * seconds) / (now.seconds || 1)}%`;
    const [begin, end] = now.loop;
    return html`<div class="line" role="slider" tabindex="0" aria-label="Time" aria-valuemin="0"
      aria-valuemax=${now.seconds} aria-valuenow=${now.position} aria-valuetext=${sinceOf(now.position)}
      @pointerdown=${this.#seek} @pointermove=${this.#point} @pointerleave=${() => {
        this.under = undefined;
      }}>
      <div class="played" style="transform: scaleX(${now.position / (now.seconds || 1)})"></div>
      ${
        begin === undefined || end === undefined
          ? nothing
          : html`<div class="loop" style="${at(begin)}; right: ${100 - (100 * end) / (now.seconds || 1)}%"></div>`
      }
      ${this.moments.map((moment) => html`<div class="moment ${moment.what}" style=${at(moment.at)} title=${wordsOf(moment)}></div>`)}
      <div class="here" style=${at(now.position)}></div>
    </div>`;
  }

  #place(event: PointerEvent): number {
    const { left, width } = (event.currentTarget as HTMLElement).getBoundingClientRect();
    const now = this.now;
    return now === undefined ? 0 : within(((event.clientX - left) / width) * now.seconds, now);
  }

  #seek = (event: PointerEvent): void => {
    void this.#ask({ position: this.#place(event) });
  };

  #point = (event: PointerEvent): void => {
    this.under = this.#place(event);
  };

  #setRate = (event: Event): void => {
    void this.#ask({ rate: Number((event.target as HTMLSelectElement).value) });
  };

  #press(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || (event.repeat && event.code === "Space")) return;
    if (this.#do(event.code, event.shiftKey)) event.preventDefault();
  }

  #do(code: string, shiftKey = false): boolean {
    if (code === "KeyN") {
      this.notes = !this.notes;
      return true;
    }
    const asked = this.now && askedBy({ code, shiftKey }, this.now, this.moments);
    if (asked === undefined) return false;
    void this.#ask(asked);
    return true;
  }

  /** Asks for something, or only how far it is. */
  async #ask(asked?: Asked): Promise<void> {
    const request = asked && { method: "POST", body: JSON.stringify(asked) };
    const now = await this.#read<Transport>(TRANSPORT, request);
    if (now !== undefined) this.now = now;
  }

  async #read<Read>(path: string, request?: RequestInit): Promise<Read | undefined> {
    try {
      const response = await fetch(path, request);
      if (!response.ok) throw new Error(await response.text());
      this.failure = "";
      return (await response.json()) as Read;
    } catch (error) {
      this.failure =
        error instanceof TypeError ? "The replay has ended: start it again." : String((error as Error).message);
      return undefined;
    }
  }
}

/** Where a replay is not the show that was, in words; "" where it is. */
const differenceOf = (now: Transport | undefined): string =>
  now === undefined || now.different === null
    ? ""
    : `From ${sinceOf(now.different)} on this is not to the bit what was on air.`;
