/** The guided minute of the hand, under the picture: the drawn hand that is followed, what to do, how long. */

import { css, html, nothing, svg } from "lit";
import { customElement } from "lit/decorators.js";
import { adviseOnAbsence } from "../hands/hand_tracker";
import { base, palette } from "../ui/theme";
import { CameraElement } from "./camera_element";
import { guideStyle } from "./guide_style";
import { drawHand } from "./hand_picture";

const style = css`
  .lost {
    border-top-color: var(--attention);
  }
  .warn {
    display: block;
    color: var(--attention);
  }
  svg {
    height: clamp(110px, 24vh, 190px);
  }
`;

const SAID = {
  ready: "Get ready: do what the drawn hand does, when it does it",
  moves: "Follow the drawn hand",
  lost: "Your hand is not seen: the minute waits",
} as const;

@customElement("omote-hand-guide")
export class HandGuideView extends CameraElement {
  static override styles = [palette, base, guideStyle, style];

  /** Whether the performer's hand points left in the mirror above: then the drawn one does. */
  #leftward = false;

  override render() {
    const { minute, reading } = this.session.hand;
    if (minute === null) return nothing;
    requestAnimationFrame(() => this.#next()); // the drawn hand moves with the screen
    const { phase, left, advice, targets, share } = minute.state;
    this.#leftward = reading?.leftward ?? this.#leftward;
    const away = adviseOnAbsence(reading?.away ?? 0);
    return html`<section class=${phase} aria-label="Guided minute of the hand">
      <svg viewBox="0 0 220 140" role="img" aria-label=${advice}>${svg`${drawHand(targets, this.#leftward)}`}</svg>
      <div>
        <p role="status" aria-live="polite">${advice}</p>
        <small>${SAID[phase]}</small>
        ${phase === "lost" && away ? html`<small class="warn">${away}</small>` : nothing}
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
