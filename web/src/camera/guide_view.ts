/** The step of a calibration, under the picture: a drawn face, what to do, and how long. */

import { css, html, nothing, svg } from "lit";
import { customElement } from "lit/decorators.js";
import { base, flow, palette } from "../ui/theme";
import { CameraElement } from "./camera_element";
import { mainButton } from "./camera_page_style";
import { drawStep } from "./step_picture";

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
  .offer {
    grid-template-columns: minmax(0, 1fr);
    border-top-color: var(--attention);
  }
  .ready {
    border-top-color: var(--attention);
  }
  svg {
    height: clamp(84px, 17vh, 128px);
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

@customElement("omote-guide")
export class GuideView extends CameraElement {
  static override styles = [palette, base, mainButton, style];

  override render() {
    const guide = this.session.status?.guide ?? null;
    if (guide === null || (guide.of === 1 && this.session.status?.unused)) return this.#offer();
    const [last, only] = [guide.done.at(-1), guide.of === 1];
    const share = 1 - guide.left / guide.seconds;
    const word = guide.phase === "ready" ? "Get ready" : "Hold it";
    return html`<section class=${guide.phase} aria-label="Calibration">
      <svg viewBox="0 0 120 140" role="img" aria-label=${guide.advice}>${svg`${drawStep(guide.step)}`}</svg>
      <div>
        <p role="status" aria-live="polite">${guide.advice}</p>
        <small>${this.session.status?.found ? word : "Your face is not seen: the step waits"}${only ? "" : ` – ${guide.number} of ${guide.of}`}</small>
        <progress max="1" .value=${guide.phase === "hold" ? share : 0} aria-label="This step"></progress>
      </div>
      <span class="count" aria-hidden="true">${Math.max(1, Math.ceil(guide.left))}</span>
      ${
        only
          ? nothing
          : html`<div class="buttons">
        <button ?disabled=${last === undefined} @click=${() => last && this.session.send({ type: "redo_step", step: last })}>The last one again</button>
        <button title="The faces made so far are kept" @click=${() => this.session.send({ type: "cancel_guide" })}>Stop (Esc)</button>
      </div>`
      }
    </section>`;
  }

  /** What can be done with the faces of a minute that was ended. */
  #offer() {
    const { status, noPicture } = this.session;
    if (!status?.unused) return nothing;
    const madeCount = status.redoable.length;
    return html`<section class="offer" aria-label="Calibration">
      <div><p role="status">${madeCount} of ${madeCount + status.missing.length} faces made</p>
        <small>They are kept while this page is open, and not used yet.</small></div>
      <div class="buttons">
        <button class="main" ?disabled=${noPicture !== ""} title=${noPicture} @click=${() => this.session.send({ type: "continue_guide" })}>Go on at ${madeCount + 1}</button>
        <button @click=${() => this.session.send({ type: "use_faces" })}>Use the ${madeCount === 1 ? "face" : `${madeCount} faces`} made</button>
      </div>
    </section>`;
  }
}
