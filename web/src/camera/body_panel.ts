/** How the body is read, and whose figure it plays. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { base, flow, palette } from "../ui/theme";
import { CameraElement } from "./camera_element";
import { adviseOnBody } from "./session/body_session";
import type { BodyChoice } from "./session/camera_messages";

/** Pictures a second below which arms are seen to lag. */
const FEW = 10;
const REGIONS: readonly (readonly [string, string])[] = [
  ["arm_left", "left arm"],
  ["arm_right", "right arm"],
  ["trunk", "trunk"],
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
  p {
    line-height: 1.35;
    color: var(--dim);
  }
  .warn {
    color: var(--attention);
  }
  .regions {
    display: grid;
    grid-template-columns: auto minmax(60px, 1fr);
    gap: 1px 8px;
    align-items: center;
    font-size: 12px;
  }
  meter {
    width: 100%;
    height: 9px;
  }
`;

@customElement("omote-body")
export class BodyPanel extends CameraElement {
  static override styles = [palette, base, style];

  override render() {
    const { session } = this;
    if (!session.tracksBody) return nothing;
    const known = session.status?.body;
    const { model } = session.body;
    return html`<section class="panel" aria-label="Body"><h2>How your body is read</h2>
        ${
          model?.kind === "failed"
            ? html`<p class="warn" role="alert">${model.reason}</p>`
            : html`<p role="status">${this.#say(known?.known ?? false)}</p>`
        }
        ${this.#advice()}
        ${known && model?.kind !== "failed" ? this.#regions(known) : nothing}
        <div class="row"><button ?disabled=${session.noBody !== ""} title=${session.noBody} @click=${() => session.send({ type: "rest_body" })}>Body at rest now</button></div></section>
      ${known ? this.#plays(known) : nothing}`;
  }

  #say(known: boolean): string {
    const { noBody, body } = this.session;
    const { model, rate } = body;
    if (noBody !== "") return model?.kind === "loading" ? `Loading ${model.what} …` : noBody;
    if (!known) return "Stand or sit as you do when nothing happens, arms hanging, for two seconds.";
    const speed = rate > 0 && rate < FEW ? ` ${rate.toFixed(0)} pictures a second: that lags.` : "";
    return `Arms, shoulders and trunk are read; where one is not seen, what is called plays.${speed}`;
  }

  #advice() {
    const advice = adviseOnBody(this.session.body.seen);
    return advice ? html`<p class="warn">${advice}</p>` : nothing;
  }

  #regions({ shares }: BodyChoice) {
    return html`<div class="regions">${REGIONS.map(
      ([region, label]) =>
        html`<span>${label}</span><meter min="0" max="1" .value=${shares[region] ?? 0} aria-label=${label}></meter>`,
    )}</div>`;
  }

  #plays({ characters }: BodyChoice) {
    const played = characters.filter((character) => character.played).map(({ name }) => name);
    const toggle = (name: string): void => {
      const chosen = played.includes(name) ? played.filter((other) => other !== name) : [...played, name];
      this.session.send({ type: "play_body", characters: chosen });
    };
    return html`<section class="panel" aria-label="Body plays"><h2>Your body plays</h2>
      <div class="row">${characters.map(
        ({ name, label, played: on }) =>
          html`<button aria-pressed=${on} @click=${() => toggle(name)}>${label}</button>`,
      )}</div>
      <p>Its legs, and the head's direction, stay with whoever has them. A figure is seen where the framing shows it: half or full.</p></section>`;
  }
}
