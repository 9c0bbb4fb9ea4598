/** The cues in the console's bar, once the show has a list: which was called, which stands by, and GO. */

import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { CueListStatus, CueName } from "../../link/messages";
import { pressed } from "../../ui/gestures";
import { base, ellipsis } from "../../ui/theme";
import { ConsoleElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";

const style = css`
  :host {
    display: flex;
    align-items: center;
    gap: 8px;
    flex: 0 1 auto;
    min-width: 0;
    font-size: 12px;
  }
  :host([none]) {
    display: none;
  }
  a {
    display: grid;
    min-width: 0;
    max-width: 190px;
    color: var(--dim);
    text-decoration: none;
    line-height: 1.25;
  }
  a span {
    ${ellipsis}
  }
  a .next {
    color: var(--coming);
  }
  button {
    flex: none;
    min-height: 34px;
    padding: 0 12px;
    font-weight: 800;
    color: #03150a;
    background: var(--coming);
    border: 0;
    touch-action: none;
  }
  button:is(.end, :disabled) {
    color: var(--text);
    background: #2a2d31;
  }
  button.paused {
    color: #1c1500;
    background: var(--attention);
  }
  @media (pointer: coarse) {
    button {
      min-height: 40px;
    }
  }
  @media (max-width: 1280px) {
    a {
      max-width: 110px;
    }
  }
  @media (max-width: 1100px) {
    a {
      display: none; /* GO bears the number of the next */
    }
  }
  @media (max-width: 899px) {
    :host {
      display: none; /* the cue page has a view of its own there */
    }
  }
`;

@customElement("omote-cue-line")
export class CueLine extends ConsoleElement {
  /** Its person may only look. */
  @property({ type: Boolean }) restricted = false;
  #shown = "";

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["state", "link"];

  /** States come sixty times a second. */
  protected override changed(): void {
    const { online, state } = this.store;
    const way = this.#way;
    const shown = JSON.stringify([online, state?.cues?.chosen, state?.cues?.rate === 1, way?.current, way?.standby]);
    if (shown !== this.#shown) this.requestUpdate();
    this.#shown = shown;
  }

  /** How far the chosen list is; null in a show that has none. */
  get #way(): CueListStatus | null {
    const { cues } = this.store.state ?? {};
    return cues?.lists[cues.chosen] ?? null;
  }

  override render() {
    const way = this.#way;
    const none = way === null || (way.current === null && way.standby === null);
    this.toggleAttribute("none", none);
    if (none) return nothing;
    const { current, standby } = way;
    const paused = this.store.state?.cues?.rate !== 1;
    const press = pressed(() => this.go());
    const look = paused ? "paused" : standby === null ? "end" : "";
    return html`<a href="/cues" target="omote-cues" title="Open the cues">
        <span class="current">${current === null ? "no cue yet" : `● ${titleOf(current)}`}</span>
        <span class="next">${standby === null ? "end of the list" : `▶ ${titleOf(standby)}`}</span></a>
      <button class=${look} title="GO of the cues (\`)" ?disabled=${this.restricted || !this.store.online}
        @pointerdown=${press.down} @click=${press.click}>${paused ? "GO ON" : `GO ${standby?.number ?? ""}`}</button>`;
  }

  /** GO: the cue that stands by here; where another one does by now, nothing is called, and the bar says so. */
  go(): void {
    const { cues } = this.store.state ?? {};
    const way = this.#way;
    if (this.restricted || !this.store.online || way === null || cues === undefined || cues === null) return;
    if (way.standby === null && cues.rate === 1) this.store.say("No cue stands by: choose one at the cue page.");
    else this.store.ask({ type: "go", seen: way.standby?.identity ?? "", cue_list: cues.chosen }, {});
  }
}

const titleOf = ({ number, label }: CueName): string => `${number} ${label}`.trim();
