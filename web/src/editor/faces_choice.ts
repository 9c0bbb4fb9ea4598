import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { base } from "../console/theme";
import { controls } from "./controls_style";
import { BenchElement } from "./element";
import { MOST_NEIGHBOURS, type Topic } from "./workbench";

/** Which face is under work, and which stand beside it and follow. */
@customElement("omote-faces-choice")
export class FacesChoice extends BenchElement {
  @state() private open = false;

  static override styles = [
    base,
    controls,
    css`
      :host {
        position: relative;
      }
      .list {
        position: absolute;
        right: 0;
        top: calc(100% + 4px);
        z-index: 6;
        width: 270px;
        max-height: 60vh;
        overflow: auto;
        padding: 8px;
        display: grid;
        grid-template-columns: 1fr auto auto;
        align-items: center;
        gap: 2px 10px;
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
        justify-self: center;
      }
      input[type="checkbox"] {
        justify-self: center;
        width: 18px;
        height: 18px;
      }
    `,
  ];

  protected override topics(): readonly Topic[] {
    return ["cast"];
  }

  override render() {
    const { work, neighbours } = this.bench;
    return html`
      <button aria-expanded=${this.open} title="Which faces are shown"
        @click=${() => {
          this.open = !this.open;
        }}>Faces: ${neighbours.length + 1} ▾</button>
      ${this.open ? this.#list(work, neighbours) : nothing}
    `;
  }

  #list(work: string, neighbours: readonly string[]) {
    const faces = this.bench.manifest?.faces ?? [];
    return html`<div class="panel list" role="group" aria-label="Faces shown"
      @keydown=${(event: KeyboardEvent) => {
        if (event.key === "Escape") this.open = false;
      }}>
      <span class="head">Up to ${MOST_NEIGHBOURS} beside the work</span><span class="head">work</span><span class="head">beside</span>
      ${faces.map(
        ({ name, label }) => html`
          <span>${label}</span>
          <input type="radio" name="work" aria-label="Work on ${label}" .checked=${name === work}
            @change=${() => this.bench.setWork(name)} />
          <input type="checkbox" aria-label="${label} beside" .checked=${neighbours.includes(name)} ?disabled=${name === work || (!neighbours.includes(name) && neighbours.length >= MOST_NEIGHBOURS)}
            @change=${() => this.#toggle(name)} />
        `,
      )}
    </div>`;
  }

  #toggle(name: string): void {
    const { neighbours } = this.bench;
    this.bench.setNeighbours(
      neighbours.includes(name) ? neighbours.filter((one) => one !== name) : [...neighbours, name],
    );
  }
}
