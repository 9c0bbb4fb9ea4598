/** A field of a cue: what is typed is kept until the show has it, with the reason beside it where it has not. */

import { css, html, LitElement, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { base, entry } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";

/** Sends what was typed; an Error, or `failed` later, says why it cannot be. */
export type SaveField = (text: string, failed: (reason: string) => void) => unknown;

const style = css`
  :host {
    display: block;
    min-width: 0;
  }
  label {
    display: grid;
    gap: 2px;
    font-size: 11px;
    color: var(--dim);
  }
  input,
  textarea,
  select {
    ${entry}
    width: 100%;
    min-height: 32px;
    font-size: 14px;
    line-height: 1.3;
  }
  textarea {
    padding: 5px 8px;
    resize: vertical;
  }
  .wrong :is(input, textarea, select) {
    border-color: var(--attention);
  }
  p {
    margin-top: 3px;
    font-size: 12px;
    color: var(--attention);
    overflow-wrap: anywhere;
  }
  @media (pointer: coarse) {
    :is(input, textarea, select) {
      min-height: 44px !important;
      font-size: 16px !important; /* below that a phone zooms in */
    }
  }
`;

@customElement("omote-cue-field")
export class CueField extends LitElement {
  @property() label = "";
  @property() value = "";
  /** `number`: the keyboard of a phone; `lines`: a text of several lines. */
  @property() kind: "text" | "number" | "lines" = "text";
  @property({ type: Boolean }) disabled = false;
  /** What it can be, and how that is read, where it is a choice. */
  @property({ attribute: false }) choices: readonly (readonly [string, string])[] | null = null;
  /** What is offered for a text. */
  @property({ attribute: false }) offered: readonly string[] = [];
  /** Of what it is a field, where that changes under it: what was typed for another is forgotten. */
  @property() of = "";
  @property({ attribute: false }) save: SaveField = () => undefined;
  /** What was typed, and is not what the show has; null where nothing is. */
  @state() private typed: string | null = null;
  @state() private error = "";

  static override styles = [base, style];

  /** What was typed has not been sent yet. */
  #unsent = false;

  /** Puts the cursor into it. */
  enter(): void {
    void this.updateComplete.then(() => this.renderRoot.querySelector<HTMLElement>("input, textarea")?.focus());
  }

  /** What is typed as another cue comes into the form is sent as if the field had been left. */
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    if (this.#unsent && this.typed !== null) this.#send(this.typed);
  }

  /** What the show has is another: what was typed is that, or was thrown over by somebody else. */
  override willUpdate(changed: PropertyValues): void {
    if (!this.hasUpdated) return;
    if (changed.has("of")) [this.typed, this.error, this.#unsent] = [null, "", false];
    if (!changed.has("value")) return;
    const typing = this.renderRoot.querySelector(":focus") !== null;
    if (typing && this.error === "" && this.typed !== null && this.typed !== this.value) return;
    [this.typed, this.error, this.#unsent] = [null, "", false];
  }

  override render() {
    return html`<label class=${this.error === "" ? "" : "wrong"}>${this.label}${this.#control()}</label>
      ${this.error === "" ? nothing : html`<p role="alert">${this.error}</p>`}`;
  }

  #control() {
    const shown = this.typed ?? this.value;
    const { label, disabled } = this;
    if (this.choices !== null)
      return html`<select aria-label=${label} ?disabled=${disabled} .value=${shown} @change=${this.#save}>${this.choices.map(
        ([value, words]) => html`<option value=${value} ?selected=${value === shown}>${words}</option>`,
      )}</select>`;
    if (this.kind === "lines")
      return html`<textarea aria-label=${label} rows="2" ?disabled=${disabled} .value=${shown} @input=${this.#type} @change=${this.#save}></textarea>`;
    return html`<input aria-label=${label} autocomplete="off" spellcheck="false" ?disabled=${disabled} list="offered"
        inputmode=${this.kind === "number" ? "decimal" : "text"} .value=${shown} @input=${this.#type} @change=${this.#save}>
      ${this.offered.length === 0 ? nothing : html`<datalist id="offered">${this.offered.map((each) => html`<option value=${each}></option>`)}</datalist>`}`;
  }

  readonly #type = (event: Event): void => {
    this.typed = textOf(event);
    this.#unsent = true;
  };

  readonly #save = (event: Event): void => this.#send(textOf(event));

  #send(text: string): void {
    [this.typed, this.error, this.#unsent] = [text, "", false];
    if (this.typed === this.value) {
      this.typed = null;
      return;
    }
    const failed = (reason: string): void => {
      this.error = reason;
    };
    try {
      this.save(this.typed, failed);
    } catch (error) {
      failed((error as Error).message);
    }
  }
}

/** The seconds that a text says, nothing being none; an Error where it says none. */
export function secondsIn(text: string): number {
  const seconds = Number(text.trim().replace(",", "."));
  if (!Number.isFinite(seconds)) throw new Error(`"${text}" is no time; give seconds such as 1.5.`);
  return seconds;
}
