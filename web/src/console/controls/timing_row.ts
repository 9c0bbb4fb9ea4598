/** The seconds and the easing of the next call. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { EASING_NAMES } from "../../link/constants";
import { base, selectable } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import type { Axis } from "../store/axis";
import type { Topic } from "../store/page_store";
import { CHOICES, EASING_CURVES, type EasingName, MANY_CHOICES, parseSeconds, secondsLabel } from "../store/timing";
import { ConsoleElement } from "./console_element";

const style = css`
  :host {
    display: flex;
    flex-wrap: wrap;
    gap: 4px;
    container-type: inline-size;
  }
  .row {
    display: flex;
    flex: 1 1 290px;
    min-width: 0;
    gap: 2px;
  }
  button,
  input {
    flex: 1 0 auto;
    min-width: 0;
    padding: 0 2px;
    font-size: 12px;
  }
  input {
    width: 0;
    flex: 1.2 1 14px;
    font: inherit;
    font-size: 12px;
    color: var(--text);
    background: #000;
    border: 1px solid var(--line);
    border-radius: 4px;
    text-align: center;
    ${selectable}
  }
  input::placeholder {
    color: var(--faint);
  }
  input.chosen {
    border-color: var(--text);
  }
  input.wrong {
    border-color: var(--attention);
    color: var(--attention);
  }
  .lists {
    display: none;
  }
  select {
    flex: 1 1 0;
    min-width: 0;
  }
  select.resting {
    color: var(--faint);
  }
  @media (pointer: coarse) {
    .lists {
      display: flex;
      gap: 4px;
    }
    .chips,
    .curves {
      display: none;
    }
  }
  @container (max-width: 230px) {
    .lists {
      display: flex;
      gap: 4px;
    }
    .chips,
    .curves {
      display: none;
    }
  }
  .curve {
    position: relative;
    flex: 1 1 0;
    min-width: 0;
    display: grid;
  }
  .curve svg {
    display: none;
  }
  @container (max-width: 240px) {
    .curve {
      flex: 0 0 40px; /* no room for a word: its curve */
    }
    .lists button {
      flex: 0 1 52px;
    }
    .lists {
      gap: 2px;
    }
    .lists > select {
      min-width: 40px;
    }
    .curve select {
      appearance: none;
      color: transparent;
    }
    .curve svg {
      position: absolute;
      inset: 0;
      display: block;
      width: 24px;
      height: 15px;
      margin: auto;
      color: var(--text);
      pointer-events: none;
    }
    .curve option {
      color: var(--text);
      background: #000;
    }
  }
  svg {
    width: 20px;
    height: 12px;
    fill: none;
    stroke: currentColor;
    stroke-width: 1.6;
    vertical-align: middle;
    overflow: visible;
  }
`;

/** The seconds and the easing of an axis's next call. */
@customElement("omote-timing")
export class TimingRow extends ConsoleElement {
  @property() axis: Axis = "face";
  @state() private wrong: string | null = null;

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["timing"];

  #choose(seconds: number): void {
    this.wrong = null;
    this.store.setTiming(this.axis, { seconds });
  }

  /** What was typed, once it is finished (Enter, or the field is left): the seconds of the next calls, or why not. */
  #typed(event: Event): void {
    const input = event.target as HTMLInputElement;
    const before = this.wrong;
    this.wrong = null;
    const seconds = input.value.trim() === "" ? this.store.timing[this.axis].seconds : parseSeconds(input.value);
    if (typeof seconds === "string") {
      this.wrong = `${seconds} Calls go on taking ${this.#effective()}.`;
      this.store.say(this.wrong);
    } else if (input.value.trim() !== "") this.#choose(seconds);
    if (this.wrong === null && this.store.notice === before) this.store.say(null);
  }

  /** Leaves the field showing the seconds that count, whatever was typed. */
  #left(event: Event): void {
    this.wrong = null;
    (event.target as HTMLInputElement).value = this.#free;
  }

  #keyed(event: KeyboardEvent): void {
    if (event.key !== "Enter") return;
    const input = event.target as HTMLInputElement;
    this.#typed(event);
    if (this.wrong === null) input.blur();
    else input.select();
  }

  #effective(): string {
    const { seconds, byHand } = this.store.timing[this.axis];
    return byHand ? "the T-bar" : seconds === 0 ? "no time (cut)" : `${secondsLabel(seconds)} s`;
  }

  /** Seconds for which there is no button. */
  get #free(): string {
    const { seconds, byHand } = this.store.timing[this.axis];
    return byHand || CHOICES.includes(seconds) ? "" : secondsLabel(seconds);
  }

  override render() {
    return html`${this.#chips()} ${this.#easings()} ${this.#lists()}`;
  }

  #chips() {
    const { seconds, byHand } = this.store.timing[this.axis];
    return html`<div class="row chips" role="radiogroup" aria-label="Seconds of a call (${this.axis})">
      ${CHOICES.map((choice) => this.#choice(choice, !byHand && seconds === choice))}
      <input
        class="${this.#free === "" ? "" : "chosen"} ${this.wrong === null ? "" : "wrong"}"
        aria-label="Other seconds (${this.axis})"
        inputmode="decimal"
        placeholder="s"
        .value=${this.#free}
        @focus=${(event: Event) => (event.target as HTMLInputElement).select()}
        @change=${this.#typed}
        @keydown=${this.#keyed}
        @blur=${this.#left}
      />
      ${this.#hand(byHand, "radio")}
    </div>`;
  }

  #easings() {
    const { easing } = this.store.timing[this.axis];
    return html`<div class="row curves" role="radiogroup" aria-label="Easing of a call (${this.axis})">
      ${EASING_NAMES.map((name) => this.#easing(name, easing === name))}
    </div>`;
  }

  /** For fingers: two lists and a switch, each as large as a finger. */
  #lists() {
    const { seconds, easing, byHand } = this.store.timing[this.axis];
    const times = MANY_CHOICES.includes(seconds) ? MANY_CHOICES : [...MANY_CHOICES, seconds];
    return html`<div class="row lists">
      <select aria-label="Seconds (${this.axis})" class=${byHand ? "resting" : ""} @change=${(event: Event) => this.#choose(Number(textOf(event)))}>
        ${times.map((time) => html`<option value=${time} .selected=${time === seconds}>${time === 0 ? "cut" : `${secondsLabel(time)} s`}</option>`)}
      </select>
      <div class="curve"><select class="easing" title=${easing} aria-label="Easing (${this.axis})" @change=${(event: Event) => this.store.setTiming(this.axis, { easing: textOf(event) })}>
        ${EASING_NAMES.map((name) => html`<option value=${name} .selected=${name === easing}>${name}</option>`)}
      </select><svg viewBox="0 0 20 12" aria-hidden="true"><path d=${EASING_CURVES[easing as EasingName]} /></svg></div>
      ${this.#hand(byHand, "button")}
    </div>`;
  }

  #hand(byHand: boolean, role: "radio" | "button") {
    const [checked, pressed] = role === "radio" ? [String(byHand), nothing] : [nothing, String(byHand)];
    return html`<button role=${role} aria-checked=${checked} aria-pressed=${pressed} data-seconds="hand"
      title="By hand: the T-bar moves it" @click=${() => this.store.setTiming(this.axis, { byHand: !byHand })}>
      hand
    </button>`;
  }

  #choice(choice: number, chosen: boolean) {
    return html`<button
      role="radio"
      data-seconds=${choice}
      aria-checked=${chosen}
      @click=${() => this.#choose(choice)}
    >
      ${secondsLabel(choice)}
    </button>`;
  }

  #easing(name: EasingName, chosen: boolean) {
    return html`<button
      role="radio"
      title=${name}
      aria-label=${name}
      data-easing=${name}
      aria-checked=${chosen}
      @click=${() => this.store.setTiming(this.axis, { easing: name })}
    >
      <svg viewBox="0 0 20 12" aria-hidden="true"><path d=${EASING_CURVES[name]} /></svg>
    </button>`;
  }
}
