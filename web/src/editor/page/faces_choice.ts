/** The choice of the face under work and of the faces beside it. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { openLayer } from "../../ui/key_presses";
import { base } from "../../ui/theme";
import { hearWhileShown, whileShown } from "../../ui/topic_element";
import { controls } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { BESIDE } from "../pose/pose_work";
import type { Topic } from "../session/draft_store";
import { MOST_NEIGHBOURS } from "../session/editor_store";

/** Pixels that the list takes, with its margin. */
const WIDTH = 280;

const style = css`
  button {
    min-width: 84px;
  }
  .list {
    position: fixed;
    z-index: 6;
    width: 270px;
    overflow: auto;
    padding: 8px;
    display: grid;
    grid-template-columns: 1fr auto auto;
    align-items: center;
    gap: 4px 10px;
    box-shadow: 0 8px 30px #000c;
  }
  .head {
    font-size: 11px;
    color: var(--faint);
  }
  input[type="radio"] {
    accent-color: var(--text);
    width: 18px;
    height: 18px;
    margin: 0;
    justify-self: center;
  }
  input[type="checkbox"] {
    justify-self: center;
    width: 18px;
    height: 18px;
  }
  @media (pointer: coarse) {
    .list {
      gap: 12px 16px;
    }
    input[type="radio"],
    input[type="checkbox"] {
      width: 26px;
      height: 26px;
    }
  }
`;

/** Which face is under work, and which stand beside it and follow. */
@customElement("omote-faces-choice")
export class FacesChoice extends EditorElement {
  /** Where the list stands, pixels of the window; null: it is closed. */
  @state() private place: { left: number; top: number } | null = null;
  #gone: () => void = () => undefined;

  static override styles = [base, controls, style];

  protected override readonly topics: readonly Topic[] = ["cast", "draft"];

  constructor() {
    super();
    hearWhileShown(this, window, ["pointerdown", "focusin"], this.#elsewhere, true);
    hearWhileShown(this, window, ["resize"], this.#close);
    whileShown(this, () => () => this.#gone());
  }

  readonly #close = (): void => {
    this.place = null;
    this.#gone();
  };

  /** Whoever goes on elsewhere has chosen. */
  readonly #elsewhere = (event: Event): void => {
    if (!event.composedPath().includes(this)) this.#close();
  };

  /** By its key, and back to its button. */
  readonly #leave = (): void => {
    this.#close();
    this.renderRoot.querySelector("button")?.focus();
  };

  /** It stays where it opened, whatever the button comes to say. */
  readonly #toggle = (event: Event): void => {
    if (this.place !== null) {
      this.#close();
      return;
    }
    const { left, bottom } = (event.currentTarget as HTMLElement).getBoundingClientRect();
    this.place = { left: Math.max(4, Math.min(left, innerWidth - WIDTH)), top: bottom + 4 };
    this.#gone = openLayer({ element: this, kind: "menu", close: this.#leave });
  };

  override render() {
    const { work, neighbours, pose } = this.store;
    const shown = pose === null ? neighbours.length : Math.min(neighbours.length, BESIDE);
    return html`
      <button aria-expanded=${this.place !== null} title="Which faces are shown" @click=${this.#toggle}>Faces: ${shown + 1} ▾</button>
      ${this.place === null ? nothing : this.#list(work, neighbours, this.place)}
    `;
  }

  #list(work: string, neighbours: readonly string[], { left, top }: { left: number; top: number }) {
    const faces = this.store.manifest?.faces ?? [];
    return html`<div class="panel list" role="group" aria-label="Faces shown"
      style="left: ${left}px; top: ${top}px; max-height: ${Math.max(160, innerHeight - top - 12)}px">
      <span class="head">Up to ${MOST_NEIGHBOURS} beside the work</span><span class="head">work</span><span class="head">beside</span>
      ${faces.map(
        ({ name, label }) => html`
          <span>${label}</span>
          <input type="radio" name="work" aria-label="Work on ${label}" .checked=${name === work}
            @change=${() => this.store.setWork(name)} />
          <input type="checkbox" aria-label="${label} beside" .checked=${neighbours.includes(name)} ?disabled=${name === work || (!neighbours.includes(name) && neighbours.length >= MOST_NEIGHBOURS)}
            @change=${() => this.#choose(name)} />
        `,
      )}
    </div>`;
  }

  #choose(name: string): void {
    const { neighbours } = this.store;
    this.store.setNeighbours(
      neighbours.includes(name) ? neighbours.filter((other) => other !== name) : [...neighbours, name],
    );
  }
}
