/** The seconds and the easing of the next call. */

import { css, html } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { EASING_NAMES } from "../../link/constants";
import { base } from "../../ui/theme";
import type { Axis } from "../store/axis";
import type { Topic } from "../store/console_store";
import { CHOICES, EASING_CURVES, type EasingName, parseSeconds, type Seconds, secondsLabel } from "../store/timing";
import { ConsoleElement } from "./console_element";

/** The seconds and the easing of an axis's next call. */
@customElement("omote-timing")
export class TimingRow extends ConsoleElement {
  @property() axis: Axis = "face";
  @state() private wrong: string | null = null;

  static override styles = [
    base,
    css`
      :host {
        display: flex;
        flex-wrap: wrap;
        gap: 4px;
      }
      .row {
        display: flex;
        flex: 1 1 210px;
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
        user-select: text;
        -webkit-user-select: text;
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
      svg {
        width: 20px;
        height: 12px;
        fill: none;
        stroke: currentColor;
        stroke-width: 1.6;
        vertical-align: middle;
        overflow: visible;
      }
    `,
  ];

  protected override topics(): readonly Topic[] {
    return ["timing"];
  }

  #choose(seconds: Seconds): void {
    this.wrong = null;
    this.store.setTiming(this.axis, { seconds });
  }

  #type(event: Event): void {
    const input = event.target as HTMLInputElement;
    const seconds = parseSeconds(input.value);
    if (typeof seconds === "number") this.#choose(seconds);
    else if (input.value.trim() === "") this.wrong = null;
    else {
      this.wrong = seconds;
      this.store.say(seconds);
    }
  }

  override render() {
    const { seconds, easing } = this.store.timing[this.axis];
    const free = seconds !== null && !CHOICES.includes(seconds);
    return html`
      <div class="row" role="radiogroup" aria-label="Seconds of a call (${this.axis})">
        ${CHOICES.map((choice) => this.#choice(choice, seconds))}
        <input
          class="${free ? "chosen" : ""} ${this.wrong === null ? "" : "wrong"}"
          aria-label="Other seconds (${this.axis})"
          inputmode="decimal"
          placeholder="s"
          .value=${free ? secondsLabel(seconds) : ""}
          @change=${this.#type}
        />
        <button role="radio" aria-checked=${seconds === null} data-seconds="hand" title="By hand: the T-bar moves it" @click=${() => this.#choose(null)}>
          hand
        </button>
      </div>
      <div class="row" role="radiogroup" aria-label="Easing of a call (${this.axis})">
        ${EASING_NAMES.map((name) => this.#easing(name, easing === name))}
      </div>
    `;
  }

  #choice(choice: number, seconds: Seconds) {
    return html`<button
      role="radio"
      data-seconds=${choice}
      aria-checked=${seconds === choice}
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
