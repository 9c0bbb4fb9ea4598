/** The row of keys that call lights, and black. */

import { css, html } from "lit";
import { customElement, query } from "lit/decorators.js";
import { base, ellipsis, flow } from "../../ui/theme";
import type { Topic } from "../store/page_store";
import { AnimatedElement } from "./console_element";
import { short } from "./screen_sizes";

const style = css`
  .row {
    ${flow}
    gap: 4px;
    padding: 4px 10px;
  }
  .row > span {
    color: var(--dim);
  }
  button {
    position: relative;
    flex: 1 1 auto;
    min-width: 0;
    ${ellipsis}
  }
  @media (max-width: 1100px) {
    .row > span {
      display: none;
    }
    button {
      padding: 0 4px;
    }
  }
  @media ${short} {
    .row {
      padding: 3px;
    }
    .row > span {
      display: none;
    }
  }
  button i {
    position: absolute;
    inset: auto 0 0;
    height: 4px;
    transform-origin: left;
    transform: scaleX(0);
    background: var(--air);
  }
  .black {
    display: flex;
    flex: 1 1 auto;
  }
  .black button {
    min-width: var(--finger);
  }
  .black button + button {
    margin-left: -1px;
    border-radius: 0 4px 4px 0;
  }
  .black button:first-child {
    border-radius: 4px 0 0 4px;
  }
  .black button[aria-pressed="true"] {
    color: #fff;
    background: #b3261a; /* as the tally */
    border-color: var(--air);
  }
  button.coming {
    border-color: var(--coming);
  }
  button.coming i {
    background: var(--coming);
  }
`;

/**
 * A key for each light: which are on air and how much, which is coming; and two for black, lit while it is on. A call
 * takes the time of a face's call.
 */
@customElement("omote-lights")
export class LightRow extends AnimatedElement {
  @query(".row") private row!: HTMLElement;

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["manifest"];

  /** To the first key. */
  override focus(): void {
    this.row.querySelector("button")?.focus();
  }

  override render() {
    return html`<div class="row" role="group" aria-label="Light">
      <span>Light</span>
      ${this.store.lights.map(
        ({ name, label }) => html`<button data-light=${name} title=${label} @click=${() => this.store.callLight(name)}>
          ${label}<i></i>
        </button>`,
      )}
      <div class="black" role="group" aria-label="Black">
        <button data-black aria-label="Fade to black" title="Fades all stages to black, and up (Shift B)"
          @click=${() => this.store.callBlack()}>Black<i></i></button>
        <button data-black aria-label="Cut to black" title="Blackout: all stages black at once, and up at once (Shift V)"
          @click=${() => this.store.callBlack(0)}>Cut</button>
      </div>
    </div>`;
  }

  paint(): void {
    const { state } = this.store;
    for (const button of this.row.querySelectorAll<HTMLElement>("[data-light]")) {
      const name = button.dataset.light as string;
      const weight = state?.light[name] ?? 0;
      const coming = state?.light_call?.target === name;
      this.write.style(button.querySelector("i") as HTMLElement, "transform", `scaleX(${weight.toFixed(3)})`);
      this.write.flag(button, "coming", coming);
      this.write.attribute(button, "aria-pressed", String(!coming && weight > 0.5));
    }
    this.#paintBlack();
  }

  /** Lit from the press on: whoever looks here knows what the audience sees next. */
  #paintBlack(): void {
    const { state, goesBlack } = this.store;
    const [black, goal] = [state?.black ?? 0, state?.black_goal ?? 0];
    for (const button of this.row.querySelectorAll<HTMLElement>("[data-black]")) {
      this.write.flag(button, "coming", black !== goal);
      this.write.attribute(button, "aria-pressed", String(goesBlack));
    }
    const bar = this.row.querySelector(".black i") as HTMLElement;
    this.write.style(bar, "transform", `scaleX(${black.toFixed(3)})`);
  }
}
