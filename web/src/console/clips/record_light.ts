/** The light that says that a pass is recorded: who records what of whom, since when, and what ends it. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { CLIP_PARTS } from "../../link/constants";
import type { ClipPass } from "../../link/messages";
import { base, ellipsis } from "../../ui/theme";
import { ConsoleDialog, sheet } from "../controls/console_dialog";
import { AnimatedElement, type ConsoleContext } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { clipTime, endPass, lightWords, passesOf, passWords, positionOf } from "./clip_passes";

const style = css`
  :host {
    flex: 0 1 auto;
    min-width: 92px;
    max-width: 520px;
  }
  :host([none]) {
    display: none;
  }
  button {
    display: flex;
    align-items: center;
    gap: 8px;
    width: 100%;
    min-height: 44px;
    padding: 0 10px;
    color: #fff;
    font-weight: 800;
    background: #c3170a;
    border: 2px solid #ff9a8e;
    border-radius: 6px;
    overflow: hidden;
  }
  @media (hover: hover) {
    button:hover {
      color: #fff;
      border-color: #fff;
    }
  }
  .lamp {
    flex: none;
    width: 14px;
    height: 14px;
    border-radius: 50%;
    background: #fff;
    animation: blink 1s steps(2, jump-none) infinite;
  }
  time {
    flex: none;
    font-size: 17px;
  }
  .words {
    ${ellipsis}
    display: var(--light-words, block);
    font-weight: 600;
  }
  @keyframes blink {
    to {
      opacity: 0.25;
    }
  }
  @media (prefers-reduced-motion: reduce) {
    .lamp {
      animation: none;
    }
  }
  @media (max-width: 1100px) {
    :host(:not([words])) .words {
      display: none;
    }
    :host(:not([words])) {
      flex: none;
    }
  }
  @media (max-width: 599px) {
    :host {
      min-width: 0;
    }
    .word {
      display: none;
    }
    button {
      gap: 6px;
      padding: 0 8px;
    }
    time {
      font-size: 15px;
    }
  }
`;

type LightContext = Pick<ConsoleContext, "store" | "painter">;

const labelOf = ({ store }: LightContext, { character }: ClipPass): string =>
  store.state?.characters[character]?.label || character;

/** Nothing while nobody records; `words`: they stand beside it on a small screen too. */
@customElement("omote-record-light")
export class RecordLight extends AnimatedElement<LightContext> {
  @state() private opened = false;

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["clip_work", "characters", "link"];

  override render() {
    const passes = passesOf(this.store);
    this.toggleAttribute("none", passes.length === 0);
    const [first] = passes;
    if (first === undefined) {
      this.opened = false;
      return nothing;
    }
    const words = passes.map((pass) => passWords(pass, labelOf(this.context, pass), CLIP_PARTS.length)).join("; ");
    return html`<button title="${words}: press to end it" aria-label="Recording: ${words}" aria-haspopup="dialog" @click=${() => this.#open(true)}>
        <span class="lamp" aria-hidden="true"></span><span class="word">REC</span><time></time>${passes.length > 1 ? html`<b>×${passes.length}</b>` : nothing}<span class="words">${passes.map((pass) => lightWords(pass, labelOf(this.context, pass), CLIP_PARTS.length)).join("; ")}</span></button>
      <span hidden role="status">Recording: ${words}</span>
      ${this.opened ? html`<omote-passes .context=${this.context} @close=${() => this.#open(false)}></omote-passes>` : nothing}`;
  }

  #open(on: boolean): void {
    this.opened = on;
  }

  paint(): void {
    const [first] = passesOf(this.store);
    const time = this.renderRoot.querySelector("time");
    if (first !== undefined && time !== null)
      this.write.text(time, clipTime(positionOf({ ...first, start: 0, speed: 1 }, this.store.state?.time ?? 0)));
  }
}

const dialogStyle = css`
  section {
    width: min(560px, 100%);
  }
  .row {
    justify-content: space-between;
  }
  .row span {
    flex: 1 1 220px;
    overflow-wrap: anywhere;
  }
  button,
  a {
    min-height: 44px;
    color: var(--text);
  }
  a {
    display: inline-flex;
    align-items: center;
    color: var(--focus);
  }
`;

/** Every pass that is recorded, with what keeps and discards it. Tells `close`. */
@customElement("omote-passes")
export class Passes extends ConsoleDialog {
  static override styles = [base, sheet, dialogStyle];

  protected override readonly topics: readonly Topic[] = ["clip_work"];

  override render() {
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Recorded now">
      <h2>Recorded now</h2>
      ${passesOf(this.store).map(
        (pass) => html`<div class="row"><span>${passWords(pass, labelOf(this.context, pass), CLIP_PARTS.length)}</span>
          <button @click=${() => this.#end(pass, true)}>Keep</button><button @click=${() => this.#end(pass, false)}>Discard</button></div>`,
      )}
      <div class="row"><a href="/clips" target="omote-clips">Open the clips</a><button @click=${this.close}>Close</button></div>
    </section>`;
  }

  #end(pass: ClipPass, keep: boolean): void {
    endPass(this.store, pass, keep);
    this.close();
  }
}
