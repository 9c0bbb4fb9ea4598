/** How the shown clip is played: where it begins and ends, how it comes and goes, its speed, and whether it begins again. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { base, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { ClipElement, clipControls, numberIn } from "./clip_element";
import type { ClipTopic } from "./clip_store";

const style = css`
  :host {
    ${flow}
    gap: 4px 12px;
    min-height: 40px;
    padding: 4px 8px;
  }
  input {
    width: 62px;
  }
  b {
    overflow-wrap: anywhere;
    font-size: 15px;
  }
  @media (max-width: 899px) {
    b {
      display: none;
    }
    :host {
      gap: 4px 8px;
    }
    input {
      width: 56px;
    }
  }
  @media (max-width: 599px) {
    :host {
      flex-wrap: nowrap;
      overflow-x: auto;
    }
    label {
      flex-wrap: nowrap;
    }
  }
`;

/** Each field: its name in messages, what people read, and what it is. */
const FIELDS = [
  ["start", "Start", "Where it begins, seconds of its lanes"],
  ["stop", "Stop", "Where it ends, seconds of its lanes"],
  ["blend_in", "In", "Seconds in which it comes"],
  ["blend_out", "Out", "Seconds in which it goes"],
  ["speed", "Speed", "1 is as it was recorded"],
] as const;

@customElement("omote-clip-settings")
export class ClipSettings extends ClipElement {
  static override styles = [base, clipControls, style];

  protected override readonly topics: readonly ClipTopic[] = ["clips", "view", "link"];

  override render() {
    const { outline, name, locked } = this.clips;
    if (outline === null) return html`<b>${name}</b>`;
    return html`<b>${name}</b>${FIELDS.map(
      ([
        field,
        label,
        title,
      ]) => html`<label title=${title}>${label}<input inputmode="decimal" ?disabled=${locked !== ""}
        .value=${shown(outline[field])} @change=${(event: Event) => this.#set(field, event)}></label>`,
    )}
      <button aria-pressed=${outline.loop} title=${locked || "Begins again at its end (L)"} ?disabled=${locked !== ""}
        @click=${() => this.clips.editClip({ loop: !outline.loop })}>Loop</button>${nothing}`;
  }

  #set(field: (typeof FIELDS)[number][0], event: Event): void {
    const { outline } = this.clips;
    const number = numberIn(textOf(event));
    if (number !== null && number !== outline?.[field]) this.clips.editClip({ [field]: number });
    if (number !== null || outline === null) return;
    (event.target as HTMLInputElement).value = shown(outline[field]);
    this.clips.show.say("Give a number, as 1.5.");
  }
}

const shown = (number: number): string => String(Math.round(number * 1000) / 1000);
