/** How the cue that is edited plays a clip: from where, how fast, how often, and which parts of it. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { LAYER_PARTS } from "../../link/constants";
import { base, flow } from "../../ui/theme";
import { type ClipCall, type ClipPart, clipCallOf, goalOfClip, withPart } from "./clip_goal";
import { CueElement } from "./cue_element";
import { secondsIn } from "./cue_field";
import "./cue_field";
import type { Goal } from "./goal_text";

type Failed = (reason: string) => void;

const LOOPS = [
  ["", "as the clip says"],
  ["on", "again and again"],
  ["off", "once"],
] as const;

const style = css`
  :host {
    display: grid;
    grid-template-columns: 58px 58px minmax(0, 1fr);
    gap: 4px 6px;
    grid-column: 1 / -1;
    align-items: end;
  }
  fieldset {
    ${flow}
    gap: 2px 12px;
    grid-column: 1 / -1;
    min-width: 0;
    margin: 0;
    padding: 0;
    border: 0;
  }
  label {
    ${flow}
    gap: 5px;
    min-height: var(--finger, 28px);
    font-size: 13px;
    color: var(--text);
  }
  label input {
    width: 18px;
    height: 18px;
  }
`;

@customElement("omote-clip-fields")
export class ClipFields extends CueElement {
  @property({ attribute: false }) goal: Goal = {};
  /** The goal with what was sent of it and is not in the list yet. */
  @property({ attribute: false }) newest: () => Goal = () => this.goal;
  /** Sends another goal; `failed` is told why it was not taken. */
  @property({ attribute: false }) save: (goal: Record<string, number>, failed: Failed) => unknown = () => undefined;

  static override styles = [base, style];

  override render() {
    const call = clipCallOf(this.goal);
    if (call === null) return html``;
    const put = (change: Partial<ClipCall>, failed: Failed) =>
      this.save(goalOfClip({ ...(clipCallOf(this.newest()) ?? call), ...change }), failed);
    return html`<omote-cue-field label="From, s" kind="number" .value=${String(call.start)}
        .save=${(text: string, failed: Failed) => put({ start: secondsIn(text) }, failed)}></omote-cue-field>
      <omote-cue-field label="Speed" kind="number" .value=${call.speed === null ? "" : String(call.speed)}
        title="1 is as it was recorded; empty: as the clip says"
        .save=${(text: string, failed: Failed) => put({ speed: speedIn(text) }, failed)}></omote-cue-field>
      <omote-cue-field label="It plays" .choices=${LOOPS} .value=${call.loop === null ? "" : call.loop ? "on" : "off"}
        .save=${(text: string, failed: Failed) => put({ loop: text === "" ? null : text === "on" }, failed)}></omote-cue-field>
      <fieldset aria-label="Parts of the clip that play">${LAYER_PARTS.map((part) => this.#part(call, part))}</fieldset>`;
  }

  #part(call: ClipCall, part: ClipPart) {
    const weight = call.weights === null ? 1 : call.weights[part];
    const change = (event: Event): void => {
      const box = event.target as HTMLInputElement;
      const failed = (reason: string): void => {
        box.checked = weight !== undefined;
        this.cues.show.say(reason);
      };
      const changed = withPart(clipCallOf(this.newest()) ?? call, part, box.checked);
      if (changed === null) failed("A clip plays one part at least: to play none of it, delete its move.");
      else this.save(goalOfClip(changed), failed);
    };
    const less = weight === undefined || weight === 1 ? "" : ` ${weight}`;
    return html`<label><input type="checkbox" .checked=${weight !== undefined} @change=${change}>${part}${less}</label>`;
  }
}

function speedIn(text: string): number | null {
  if (text.trim() === "") return null;
  const speed = Number(text.trim().replace(",", "."));
  if (!Number.isFinite(speed)) throw new Error(`"${text}" is no speed; give 0.5 for half, 2 for double.`);
  return speed;
}
