/** The guided minute of the hand, under the picture: the drawn hand that is followed, what to do, how long. */

import { css, html, nothing, svg } from "lit";
import { customElement } from "lit/decorators.js";
import { base, flow, palette } from "../ui/theme";
import { CameraElement } from "./camera_element";
import { drawHand } from "./hand_picture";

const style = css`
  section {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr) auto;
    gap: 4px 14px;
    align-items: center;
    padding: 10px 14px;
    background: var(--panel);
    border: 1px solid var(--line);
    border-top: 2px solid var(--coming);
    border-radius: 6px;
  }
  .ready,
  .lost {
    border-top-color: var(--attention);
  }
  svg {
    height: clamp(110px, 24vh, 190px);
    color: var(--hand);
  }
  p {
    font-size: clamp(16px, 2.2vw, 22px);
    line-height: 1.2;
  }
  small {
    color: var(--dim);
    font-size: 13px;
  }
  progress {
    width: 100%;
    height: 8px;
    accent-color: var(--coming);
  }
  .count {
    min-width: 2ch;
    font-size: clamp(28px, 5vw, 46px);
    font-weight: 700;
    text-align: right;
  }
  .buttons {
    grid-column: 1 / -1;
    ${flow}
    gap: 6px;
  }
`;

const SAID = {
  ready: "Get ready: do what the drawn hand does, when it does it",
  moves: "Follow the drawn hand",
  lost: "Your hand is not seen: the minute waits",
} as const;

@customElement("omote-hand-guide")
export class HandGuideView extends CameraElement {
  static override styles = [palette, base, style];

  override render() {
    const { minute } = this.session.hand;
    if (minute === null) return nothing;
    requestAnimationFrame(() => this.#next()); // the drawn hand moves with the screen
    const { phase, left, advice, targets, share } = minute.state;
    return html`<section class=${phase} aria-label="Guided minute of the hand">
      <svg viewBox="0 0 220 140" role="img" aria-label=${advice}>${svg`${drawHand(targets)}`}</svg>
      <div>
        <p role="status" aria-live="polite">${advice}</p>
        <small>${SAID[phase]}</small>
        <progress max="1" .value=${share} aria-label="The minute"></progress>
      </div>
      <span class="count" aria-hidden="true">${Math.max(1, Math.ceil(left))}</span>
      <div class="buttons"><button @click=${() => this.session.hand.cancelMinute()}>Stop (Esc)</button></div>
    </section>`;
  }

  #next(): void {
    this.session.hand.minute?.pass(performance.now() / 1000);
    this.requestUpdate();
  }
}
