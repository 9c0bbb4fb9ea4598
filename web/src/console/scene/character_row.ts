/** The characters of the scene, beside the picture: which of them this console plays. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import type { CharacterState } from "../../link/messages";
import { base, ellipsis } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import { low, narrow } from "../controls/screen_sizes";
import type { Topic } from "../store/page_store";
import { standing } from "../store/played_characters";
import { isStill, toggleStill } from "../store/stillness";
import { SceneCommands } from "./scene_commands";

const style = css`
  :host {
    z-index: 2;
    min-width: 0;
    padding: 6px;
    pointer-events: none;
  }
  .row,
  .names,
  .tools {
    display: flex;
    justify-content: flex-end;
    gap: 4px;
    min-width: 0;
  }
  .row {
    flex-wrap: wrap; /* where all does not fit beside each other, names have a line of their own */
  }
  .names,
  .tools {
    justify-content: safe flex-end;
    max-width: 100%;
    overflow-x: auto;
    scrollbar-width: none;
    pointer-events: auto;
  }
  .names {
    flex: 1 1 auto;
  }
  .tools button {
    padding: 0 6px;
  }
  @media (max-width: 1279px) {
    .tools {
      gap: 1px;
    }
    .tools button {
      padding: 0 3px;
    }
  }
  button {
    pointer-events: auto;
    min-height: 30px;
    min-width: 30px;
    max-width: 120px;
    ${ellipsis}
    flex: none;
  }
  .names button {
    flex: 1 1 38px;
    width: 38px; /* whatever its label is: nothing moves when one is renamed, enters or leaves */
    min-width: 26px;
    max-width: none;
    padding: 0 2px;
    font-size: 11px;
    line-height: 12px;
  }
  .names span {
    display: -webkit-box;
    -webkit-box-orient: vertical;
    -webkit-line-clamp: 2;
    overflow: hidden;
    overflow-wrap: anywhere;
    white-space: normal;
  }
  button.off {
    border: 1px dashed var(--edge);
    color: var(--dim);
  }
  button.off[aria-pressed="true"] {
    color: #000;
    background: #9aa0a7;
  }
  @media (max-width: 899px) {
    .view {
      display: none; /* they stand with what is shown below */
    }
  }
  @media ${low} {
    .view {
      display: block;
    }
  }
  @media ${low} {
    @media (min-width: 780px) {
      .blend_pads {
        display: none; /* it stands below the picture */
      }
    }
  }
  @media ${narrow} or ${low} {
    .still {
      display: none; /* the picture is small; the mixer has it */
    }
  }
  @media (pointer: coarse) {
    .several .still {
      display: none; /* beside the keys of characters there is room for as many as these; the mixer has it */
    }
  }
  @media (pointer: coarse) and (max-width: 1100px) and (max-height: 560px) {
    .several .blend_pads,
    .still {
      display: none; /* with keys for fingers it would be a third row */
    }
  }
  @media ${narrow} or ${low} {
    .row {
      flex-wrap: nowrap; /* one line, which scrolls */
      gap: 2px;
      justify-content: safe center;
      overflow-x: auto;
      scrollbar-width: none;
      pointer-events: auto;
    }
    .names,
    .tools {
      flex: 1 0 auto;
      max-width: none;
      overflow: visible;
    }
  }
  @media ${narrow} {
    :host {
      padding: 4px;
    }
  }
  @media (pointer: coarse) {
    button,
    .names button {
      min-height: 44px;
      min-width: 44px;
    }
    .tools {
      gap: 2px;
    }
    .tools button {
      padding: 0 2px;
    }
  }
  @media ${narrow} {
    button {
      min-width: 40px;
      padding: 0 4px;
      font-size: 12px;
    }
  }
`;

/** A key for each character, one for all, one for places and framing, one for a close-up, one that holds still, one for pads of looks, one for layers, one to add another (a double click is one). Tells `scene`, `blend_pads`, `layers`. */
@customElement("omote-characters")
export class CharacterRow extends AnimatedElement {
  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["characters", "link", "arrangement"];

  /** To the first key. */
  override focus(): void {
    this.renderRoot.querySelector("button")?.focus();
  }

  override render() {
    const characters = Object.entries(this.store.state?.characters ?? {});
    const several = characters.length > 1;
    const commands = new SceneCommands(this.store);
    const why = commands.whyFull;
    return html`<div class="row ${several ? "several" : ""}" role="group" aria-label="Characters">
      ${several ? html`<div class="names">${characters.map(([name, character]) => this.#key(name, character))}</div>` : nothing}
      <div class="tools">${several ? this.#choice(characters) : nothing}
      <button class="still" aria-pressed="false" title="Holds still; else it blinks, breathes and looks about as people do (')"
        @click=${() => toggleStill(this.store)}>Still</button>
      <button class="view blend_pads" title="Pads: mixtures of looks (Shift H)" aria-pressed=${this.store.arrangement.view === "blend_pads"}
        @click=${() => this.tell("blend_pads")}>Pads</button>
      <button class="view layers" title="Layers as a mixer (;)" aria-pressed=${this.store.arrangement.view === "layers"}
        @click=${() => this.tell("layers")}>Layers<omote-unrouted-mark .context=${this.context}></omote-unrouted-mark></button>
      <button class="add" aria-label="Add a character" title=${why ?? "Add a character"} ?disabled=${why !== null}
        @click=${(event: MouseEvent) => event.detail < 2 && commands.add()}>+</button></div>
    </div>`;
  }

  paint(): void {
    const still = this.renderRoot.querySelector(".still");
    if (still !== null) this.write.attribute(still, "aria-pressed", String(isStill(this.store)));
  }

  #choice(characters: readonly (readonly [string, CharacterState])[]) {
    const { arrangement, played } = this.store;
    const { alone } = arrangement;
    const all = characters.map(([name]) => name);
    return html`<button class="all" aria-pressed=${played.names.length === all.length} title="Play all characters" @click=${() => this.store.play(all)}>All</button>
      <button class="view" aria-label="Scene: places, framing, names" title="Places, framing, names (P)"
        aria-pressed=${arrangement.view === "scene"} @click=${() => this.tell("scene")}>Scene</button>
      <button class="alone" aria-pressed=${alone} title="The picture shows the character played here alone"
        @click=${() => this.store.arrange({ alone: !alone })}>Close-up</button>`;
  }

  #key(name: string, character: CharacterState) {
    const [stands, { label }] = [standing(character), character];
    return html`<button data-character=${name} class=${stands === "" ? "" : "off"} aria-pressed=${this.store.played.names.includes(name)}
      title="Play ${label}${stands === "" ? "" : ` (${stands})`}; with Shift beside the others"
      @click=${(event: MouseEvent) => this.store.play(this.store.played.pressed(name, event.shiftKey))}
      ><span>${label}</span></button>`;
  }
}
