/** The step of a calibration, under the picture: a drawn face, what to do, and how long. */

import { css, html, nothing, svg } from "lit";
import { customElement } from "lit/decorators.js";
import { base, palette } from "../ui/theme";
import { CameraElement } from "./camera_element";
import { mainButton } from "./camera_page_style";
import { guideStyle } from "./guide_style";
import { drawStep } from "./step_picture";

const style = css`
  .offer {
    grid-template-columns: minmax(0, 1fr);
    border-top-color: var(--attention);
  }
  svg {
    height: clamp(84px, 17vh, 128px);
  }
`;

@customElement("omote-guide")
export class GuideView extends CameraElement {
  static override styles = [palette, base, mainButton, guideStyle, style];

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
