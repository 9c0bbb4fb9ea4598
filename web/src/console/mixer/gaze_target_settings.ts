/** Whom or what the character looks at: nothing, a camera, another character, a point of the house that has a name. */

import { css, html } from "lit";
import { customElement, state } from "lit/decorators.js";
import { base, entry, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { AnimatedElement } from "../controls/console_element";
import { AHEAD } from "../store/layer_state";
import type { Topic } from "../store/page_store";
import { choicesFor, GazeTargetCommands, isSame, type TargetChoice, targetOf } from "./gaze_target_commands";
import { groupStyle } from "./group_style";

/** Where a point is: its label, lowest, highest, and in words. */
const SLIDERS = [
  ["x", "Across", -6, 6, "Metres to the picture's right"],
  ["y", "Height", -3, 4, "Metres above the character's eyes"],
  ["z", "Ahead", 0.5, 20, "Metres before the front line"],
] as const;
type Axis = (typeof SLIDERS)[number][0];

const style = css`
  .row {
    ${flow}
    gap: 4px;
  }
  .point {
    display: inline-flex;
  }
  .point button:first-child {
    border-radius: 6px 0 0 6px;
  }
  .point .delete {
    border-left: 0;
    border-radius: 0 6px 6px 0;
    min-width: 28px;
    padding: 0;
  }
  label {
    display: grid;
    grid-template-columns: 52px minmax(0, 1fr) 46px;
    align-items: center;
    gap: 6px;
  }
  output {
    text-align: right;
    color: var(--dim);
  }
  input[type="range"] {
    width: 100%;
  }
  input[name="name"] {
    ${entry}
    flex: 1 1 80px;
    min-height: 28px;
  }
  @media (pointer: coarse) {
    input[type="range"] {
      height: var(--finger);
    }
    .point .delete {
      min-width: var(--finger);
    }
  }
`;

@customElement("omote-gaze-target-settings")
export class GazeTargetSettings extends AnimatedElement {
  @state() private point: Record<Axis, number> = { x: 0, y: 0, z: 3 };
  @state() private open = false;
  #shown = "";

  static override styles = [base, groupStyle, style];

  protected override readonly topics: readonly Topic[] = ["characters", "crew"];

  get #commands(): GazeTargetCommands {
    return new GazeTargetCommands(this.store);
  }

  get #target() {
    return this.store.air?.motion?.target ?? AHEAD;
  }

  get #choices(): TargetChoice[] {
    const { state, crew, played } = this.store;
    const points = Object.keys(state?.gaze_points ?? {});
    const stages = (crew?.stages ?? []).map((stage) => stage?.name ?? "");
    return choicesFor(played.lead, state?.characters ?? {}, points, stages);
  }

  override render() {
    return html`<div class="row" role="group" aria-label="Looks at">${this.#choices.map((choice) => this.#choice(choice))}
        <button data-point aria-pressed=${this.#target.kind === "point"} aria-expanded=${this.open} @click=${this.#toggle} title="Look at a point of the house, and give it a name">Point …</button></div>
      ${this.open ? this.#editor() : ""}`;
  }

  #choice(choice: TargetChoice) {
    const { label, title, target } = choice;
    const button = html`<button aria-pressed=${isSame(target, this.#target)} title=${title}
      @click=${() => this.#commands.choose(choice)}>${label}</button>`;
    if (target.kind !== "gaze_point") return button;
    return html`<span class="point">${button}<button class="delete" aria-label="Delete the point ${label}" title="Delete this point"
      @click=${() => this.#commands.delete(target.name)}>×</button></span>`;
  }

  #editor() {
    return html`${SLIDERS.map(
      ([axis, label, low, high, title]) =>
        html`<label title=${title}>${label}<input type="range" name=${axis} min=${low} max=${high} step="0.1"
          .value=${String(this.point[axis])} @change=${(event: Event) => this.#move(axis, event)} />
          <output>${this.point[axis].toFixed(1)} m</output></label>`,
    )}
      <form class="row" @submit=${this.#keep}>
        <input name="name" maxlength="40" required aria-label="Name of the point" placeholder="Seat, row, box …" />
        <button type="submit">Keep</button>
      </form>`;
  }

  readonly #toggle = (): void => {
    this.open = !this.open;
    const target = this.#target;
    const kept = target.kind === "gaze_point" ? this.store.state?.gaze_points[target.name] : undefined;
    if (kept !== undefined) this.point = { x: kept[0], y: kept[1], z: kept[2] };
    if (this.open) this.#look();
  };

  #move(axis: Axis, event: Event): void {
    this.point = { ...this.point, [axis]: Number(textOf(event)) };
    this.#look();
  }

  #look(): void {
    const target = targetOf({ kind: "point", ...this.point });
    this.#commands.choose({ label: "a point of the house", title: "", target });
  }

  readonly #keep = (event: SubmitEvent): void => {
    event.preventDefault();
    const form = event.target as HTMLFormElement;
    const name = String(new FormData(form).get("name") ?? "").trim();
    if (name === "") return;
    const { x, y, z } = this.point;
    this.#commands.keep(name, [x, y, z]);
    this.#commands.choose({ label: name, title: "", target: targetOf({ kind: "gaze_point", name }) });
    this.open = false;
  };

  paint(): void {
    if (this.store.air === null || this.offsetParent === null) return;
    const { played, state, air } = this.store;
    const shown = JSON.stringify([played.lead, air.motion?.target, state?.gaze_points]);
    if (shown !== this.#shown) this.requestUpdate();
    this.#shown = shown;
  }
}
