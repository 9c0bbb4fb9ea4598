/** The tools of the canvas and their options. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { live } from "lit/directives/live.js";
import { base, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { controls } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import type { Topic } from "../session/draft_store";
import type { Options } from "../session/editor_store";
import { TOOLS, VIEWS, type ViewKey } from "./keys";
import "./faces_choice";

const SHOWN: readonly (readonly [keyof Options & ("needles" | "wireframe" | "muscles"), string, string])[] = [
  ["needles", "Needles", "N"],
  ["wireframe", "Wires", "W"],
  ["muscles", "Muscles", "U"],
];

/** The same where a face is under work. */
const ON_FACES: typeof SHOWN = [
  ["needles", "Handles", "N"],
  ["wireframe", "Wires", "W"],
];

const style = css`
  :host {
    ${flow}
    gap: 4px 10px;
    padding: 6px 8px;
  }
  .group {
    display: flex;
    align-items: center;
    gap: 2px;
  }
  .group label {
    display: flex;
    align-items: center;
    gap: 5px;
    font-size: 12px;
  }
  .falloff input {
    width: 74px;
  }
  output {
    min-width: 38px;
    color: var(--text);
    font-size: 12px;
  }
  select {
    max-width: 112px;
  }
  @media (max-width: 1180px) {
    :host {
      gap: 4px 6px;
      padding: 5px 8px;
    }
    button,
    select {
      padding: 0 6px;
      font-size: 12px;
    }
    .falloff input {
      width: 54px;
    }
    select {
      max-width: 90px;
    }
  }
  @media (max-width: 940px) {
    select {
      max-width: 130px;
    }
  }
`;

/** What the hand does on the face, and what is shown of it. Tells `view` with the name of a view. */
@customElement("omote-tools")
export class Tools extends EditorElement {
  static override styles = [base, controls, style];

  protected override readonly topics: readonly Topic[] = ["options", "draft", "items"];

  override render() {
    const { store } = this;
    return html`
      ${store.net === null ? nothing : html`${this.#hands()} ${this.#reach()} ${this.#shown(SHOWN)}`}
      ${store.face === null ? nothing : html`${this.#mirror()} ${this.#shown(ON_FACES)}`}
      <div class="group" role="group" aria-label="Views">
        ${VIEWS.map(
          ([view, label, key]) =>
            html`<button data-view=${view} title="${label} (${key})" @click=${() => this.#view(view)}>${label}</button>`,
        )}
      </div>
      ${store.face === null ? html`<omote-faces-choice .context=${this.context}></omote-faces-choice>` : nothing}
    `;
  }

  #hands() {
    const { tool } = this.store.options;
    return html`<div class="group" role="radiogroup" aria-label="Tools">
      ${TOOLS.map(
        ([name, label, key, does]) => html`<button role="radio" data-tool=${name} aria-checked=${tool === name}
          title="${does} (${key})" @click=${() => this.store.setOptions({ tool: name })}>${label}</button>`,
      )}
    </div>`;
  }

  #reach() {
    const { falloff, region } = this.store.options;
    return html`
      ${this.#mirror()}
      <div class="group falloff">
        <label title="How far around a dragged needle others come along">Falloff
          <input type="range" min="0" max="60" step="1" .value=${String(falloff)} aria-valuetext="${falloff} mm"
            @input=${(event: Event) => this.store.setOptions({ falloff: Number(textOf(event)) })} /></label>
        <output>${falloff === 0 ? "off" : `${falloff} mm`}</output>
      </div>
      <select aria-label="Region that moves" title="Only this part of the face moves"
        @change=${(event: Event) => this.store.setOptions({ region: textOf(event) || null })}>
        <option value="" .selected=${live(region === null)}>Whole face</option>
        ${this.store.regions.map((name) => html`<option value=${name} .selected=${live(name === region)}>Only ${name}</option>`)}
      </select>
    `;
  }

  #mirror() {
    const { mirror } = this.store.options;
    return html`<div class="group">
      <button data-option="mirror" aria-pressed=${mirror} title="What you do on one side is done on the other (X)"
        @click=${() => this.store.setOptions({ mirror: !mirror })}>Mirror</button>
    </div>`;
  }

  #shown(options: typeof SHOWN) {
    return html`<div class="group" role="group" aria-label="Shown">
      ${options.map(
        ([option, label, key]) => html`<button data-option=${option} title="Show ${label.toLowerCase()} (${key})"
          aria-pressed=${this.store.options[option]} @click=${() => this.store.setOptions({ [option]: !this.store.options[option] })}>${label}</button>`,
      )}
    </div>`;
  }

  #view(view: ViewKey): void {
    this.dispatchEvent(new CustomEvent("view", { detail: view }));
  }
}
