/** The panel that turns eyeballs and sets pupils. */

import { html } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { Recipe } from "../../link/editing_messages";
import { base } from "../../ui/theme";
import { GAZE_PITCH, GAZE_YAW } from "../../ui/travel";
import { amountOf } from "../controls/amount";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { DEGREES, PERCENT } from "../controls/units";
import type { Topic } from "../session/draft_store";

/** Which of left yaw, left pitch, right yaw, right pitch a slider turns; several turn together. */
const TOGETHER: readonly (readonly [string, readonly number[]])[] = [
  ["Sideways", [0, 2]],
  ["Up", [1, 3]],
];
const APART: readonly (readonly [string, readonly number[]])[] = [
  ["Left eye, sideways", [0]],
  ["Left eye, up", [1]],
  ["Right eye, sideways", [2]],
  ["Right eye, up", [3]],
];

/** Eyeballs and pupils: what the expression adds to where the show looks. */
@customElement("omote-eyes")
export class EyesPanel extends EditorElement {
  @state() private together = true;

  static override styles = [base, controls, panel];

  protected override readonly topics: readonly Topic[] = ["draft", "live"];

  override render() {
    const { pupil } = this.store.liveEyes;
    return html`
      <p>What this expression adds to the gaze. Sideways is + towards the character's own left, which is on the right of the picture.</p>
      <label class="row"><input type="checkbox" .checked=${this.together}
        @change=${() => (this.together = !this.together)} /> Both eyes together</label>
      ${(this.together ? TOGETHER : APART).map(([label, parts]) => this.#slider(label, parts))}
      <omote-amount label="Pupils" .unit=${PERCENT} .low=${-1} .high=${1} .value=${pupil}
        hint="100 % as wide as they go, -100 % as narrow"
        @live=${(event: Event) => this.#turn([], 0, amountOf(event))}
        @done=${(event: Event) => this.#send([], 0, amountOf(event))}></omote-amount>
      <button @click=${() => this.#send([0, 1, 2, 3], 0, 0)}>Straight ahead</button>
    `;
  }

  #slider(label: string, parts: readonly number[]) {
    const range = (parts[0] as number) % 2 === 0 ? GAZE_YAW : GAZE_PITCH;
    const value = this.store.liveEyes.turns[parts[0] as 0];
    return html`<omote-amount label=${label} .unit=${DEGREES} .low=${range.low} .high=${range.high} .value=${value}
      @live=${(event: Event) => this.#turn(parts, amountOf(event))}
      @done=${(event: Event) => this.#send(parts, amountOf(event))}></omote-amount>`;
  }

  #turn(parts: readonly number[], angle: number, pupil = this.store.liveEyes.pupil): void {
    const turns = [...this.store.liveEyes.turns] as Recipe["eyes"];
    for (const part of parts) turns[part as 0] = angle;
    this.store.turnEyes(turns, pupil);
  }

  #send(parts: readonly number[], angle: number, pupil = this.store.liveEyes.pupil): void {
    this.#turn(parts, angle, pupil);
    this.store.sendEyes();
  }
}
