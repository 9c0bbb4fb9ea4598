/** What the camera is looked at for. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { base, flow, palette } from "../ui/theme";
import { CameraElement } from "./camera_element";
import type { Tracked } from "./session/camera_session";

const TRACKED: readonly (readonly [Tracked, string])[] = [
  ["face", "Face"],
  ["hand", "Hand"],
  ["both", "Face and hand"],
  ["body", "Body alone"],
];

const style = css`
  section {
    display: grid;
    gap: 8px;
    padding: 12px;
    margin-top: 8px;
  }
  .row {
    ${flow}
    gap: 6px;
  }
  button {
    min-height: 34px;
  }
  label {
    display: flex;
    gap: 8px;
    align-items: center;
    min-height: 34px;
  }
`;

@customElement("omote-tracked")
export class TrackedPanel extends CameraElement {
  static override styles = [palette, base, style];

  override render() {
    const { session } = this;
    const { tracked } = session;
    return html`<section class="panel" aria-label="Tracked"><h2>The camera is for</h2>
      <div class="row" role="group" aria-label="The camera is for">${TRACKED.map(
        ([name, label]) =>
          html`<button aria-pressed=${tracked === name} @click=${() => session.track(name)}>${label}</button>`,
      )}</div>
      ${
        tracked === "body"
          ? nothing
          : html`<label><input type="checkbox" role="switch" .checked=${session.tracksBody}
        @change=${(event: Event) => session.trackBody((event.target as HTMLInputElement).checked)} />Body too: arms, shoulders, lean</label>`
      }</section>`;
  }
}
