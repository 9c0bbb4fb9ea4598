/** The lists of cues, one of which this page shows and plays. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { base, flow } from "../../ui/theme";
import { CueElement } from "./cue_element";
import type { CueTopic } from "./cue_store";

const style = css`
  :host {
    ${flow}
    gap: 4px;
    min-width: 0;
  }
  button {
    min-height: var(--finger, 32px);
    max-width: 180px;
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  button:not([aria-pressed="true"]) {
    color: var(--text);
  }
  small {
    color: var(--attention);
  }
  @media (pointer: coarse) {
    :host {
      --finger: 44px;
    }
  }
`;

@customElement("omote-cue-tabs")
export class CueTabs extends CueElement {
  static override styles = [base, style];

  protected override readonly topics: readonly CueTopic[] = ["cues", "view"];

  override render() {
    const { names, name, editing, status, show } = this.cues;
    if (names.length === 1 && !editing) return nothing;
    const drop = (): void => {
      if (this.cues.change({ type: "drop_cue_list", cue_list: name }))
        show.say(`The list ${name} is deleted.`, "done", [{ label: "Undo", act: () => this.cues.undo("undo") }]);
    };
    return html`${names.map((each) => html`<button aria-pressed=${each === name} @click=${() => this.cues.choose(each)}>${each}</button>`)}
      ${
        name === status.chosen
          ? nothing
          : html`<button class="elsewhere" title="GO by OSC, MIDI and programs plays ${status.chosen}. Press: it plays this list" @click=${() => this.cues.play({ type: "choose_cue_list", cue_list: name })}><small>GO elsewhere: ${status.chosen}</small></button>`
      }
      ${
        editing
          ? html`<button aria-label="A new list" title="A new list" @click=${() => this.tell("add_list")}>+</button>
            <button title="Rename the list ${name}" @click=${() => this.tell("rename_list")}>Rename</button>
            <button title="Delete the list ${name} with its cues" ?disabled=${names.length === 1} @click=${drop}>Delete list</button>`
          : nothing
      }`;
  }
}
