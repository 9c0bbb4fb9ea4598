/** Frames around the heads of the picture: each is a key that chooses whom this console plays, and says whose hand is on it. */

import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { base, ellipsis } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { handOn } from "../store/played_characters";

/** Left, top, right and bottom as parts of the picture, by name. */
type Boxes = ReadonlyMap<string, readonly [number, number, number, number]>;

const style = css`
  :host {
    position: relative;
    min-width: 0;
    min-height: 0;
    overflow: hidden;
    pointer-events: none;
  }
  button {
    position: absolute;
    display: flex;
    flex-direction: column;
    justify-content: flex-end; /* keys of characters may lie over the upper end */
    align-items: flex-start;
    min-width: 0;
    min-height: 0;
    padding: 0;
    overflow: hidden;
    border: 1px solid transparent;
    border-radius: 6px;
    background: none;
    pointer-events: auto;
    container-type: inline-size;
  }
  @container (max-width: 44px) {
    span:not(.hand) {
      display: none; /* it would cover the face */
    }
  }
  button[hidden] {
    display: none;
  }
  button[aria-pressed="true"] {
    border: 2px solid var(--hand);
    background: none;
  }
  span {
    max-width: 100%;
    ${ellipsis}
    padding: 1px 6px;
    border-radius: 0 6px 0 0;
    font-size: 11px;
    line-height: 14px;
    color: var(--text);
    background: #000a;
  }
  .hand {
    color: #000;
    background: var(--attention);
  }
  .hand:empty {
    display: none;
  }
  @media (hover: hover) {
    button:not([aria-pressed="true"]):hover {
      border-color: var(--edge);
    }
  }
`;

/** Lies over the picture; shows nothing where there is one character alone. */
@customElement("omote-head-frames")
export class HeadFrames extends AnimatedElement {
  /** Where heads lie in the picture now. */
  @property({ attribute: false }) boxes: () => Boxes = () => new Map();

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["characters"];

  override render() {
    const characters = Object.entries(this.store.state?.characters ?? {});
    if (characters.length < 2) return nothing;
    const { played } = this.store;
    return characters.map(
      ([name, { label }]) => html`<button hidden tabindex="-1" data-character=${name}
        aria-pressed=${played.names.includes(name)} title="Play ${label}; with Shift beside the others"
        @click=${(event: MouseEvent) => this.store.play(played.pressed(name, event.shiftKey))}
        ><span>${label}</span><span class="hand"></span></button>`,
    );
  }

  paint(): void {
    const frames = this.renderRoot.querySelectorAll<HTMLElement>("button");
    if (frames.length === 0) return;
    const boxes = this.boxes();
    for (const frame of frames) {
      const name = frame.dataset.character ?? "";
      const box = boxes.get(name);
      frame.hidden = box === undefined;
      if (box !== undefined) this.#put(frame, name, box);
    }
  }

  #put(frame: HTMLElement, name: string, [left, top, right, bottom]: readonly [number, number, number, number]): void {
    const inside = (part: number): number => 100 * Math.min(1, Math.max(0, part));
    const per = {
      left: inside(left),
      top: inside(top),
      width: inside(right) - inside(left),
      height: inside(bottom) - inside(top),
    };
    for (const [property, value] of Object.entries(per)) this.write.style(frame, property, `${value.toFixed(2)}%`);
    this.write.text(frame.querySelector(".hand") as Element, handOn(this.store.hands, name));
  }
}
