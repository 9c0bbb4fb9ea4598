/** The row of memories: whole looks that are kept by a press and called by another. */

import { css, html, nothing } from "lit";
import { customElement, query, queryAll, state } from "lit/decorators.js";
import { base, ellipsis, flow } from "../../ui/theme";
import { THUMBNAIL_SIZE } from "../../ui/thumbnails";
import { hearWhileShown } from "../../ui/topic_element";
import { ConsoleElement } from "../controls/console_element";
import { short } from "../controls/screen_sizes";
import type { Topic } from "../store/page_store";
import { MemoryCommands, type MemoryPress, PLACES, pictureOf, placesOf } from "./memory_commands";

const style = css`
  .row {
    ${flow}
    flex-wrap: nowrap;
    gap: 4px;
    padding: 4px 10px;
    overflow-x: auto;
  }
  .row.more {
    mask-image: linear-gradient(90deg, #000 calc(100% - 40px), #0003);
  }
  .row > span {
    color: var(--dim);
  }
  button {
    flex: 1 0 auto;
    min-width: 24px;
    max-width: 110px;
    padding: 0 3px;
    ${ellipsis}
  }
  button.kept {
    position: relative;
    padding: 0;
    background: #000;
  }
  button.named {
    min-width: 72px;
  }
  canvas {
    display: block;
    height: var(--picture, 30px);
    aspect-ratio: ${THUMBNAIL_SIZE.width} / ${THUMBNAIL_SIZE.height};
    margin: 0 auto;
  }
  .kept > span {
    position: absolute;
    inset: 1px auto auto 1px;
    max-width: calc(100% - 2px);
    padding: 0 3px;
    font-size: 11px;
    line-height: 14px;
    border-radius: 3px;
    color: var(--text);
    background: #000c;
    ${ellipsis}
  }
  button.empty {
    color: var(--dim);
    border-style: dashed;
    background: none;
  }
  .means {
    flex: 0 0 auto;
    order: -1; /* where the row scrolls they are in sight */
  }
  .row > span {
    order: -2;
  }
  .means[aria-pressed="true"],
  .asked button:not(.means) {
    border-color: var(--attention);
  }
  @media (max-width: 1400px) {
    .row > span {
      display: none;
    }
  }
  @media ${short} {
    .row {
      padding: 3px;
    }
    .row > span {
      display: none;
    }
  }
  @media (pointer: coarse) {
    button {
      min-width: 40px;
    }
    :host {
      --picture: 38px;
    }
  }
`;

/** A key for each memory, one that keeps what shows in the next one pressed, one that deletes that. */
@customElement("omote-memories")
export class MemoryRow extends ConsoleElement {
  /** What the next press means: after it, a press calls again. */
  @state() private means: MemoryPress = "call";
  /** Whether there are memories to the right of what is in sight. */
  @state() private goesOn = false;
  @query(".row") private row!: HTMLElement;
  @queryAll("canvas") private pictures!: NodeListOf<HTMLCanvasElement>;
  #shown = "";

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["state", "memory_list", "pad_list", "manifest", "characters"];

  constructor() {
    super();
    hearWhileShown<PointerEvent>(this, window, ["pointerdown"], (event) => {
      if (!event.composedPath().includes(this)) this.means = "call"; // whoever goes on elsewhere has thought better of it
    });
  }

  /** States come sixty times a second. */
  protected override changed(topic: Topic): void {
    const shown = JSON.stringify(this.#commands.kept);
    if (topic !== "state" || shown !== this.#shown) this.requestUpdate();
    this.#shown = shown;
  }

  get #commands(): MemoryCommands {
    return new MemoryCommands(this.store);
  }

  /** A key or a click: calls a memory, or does what was asked for before. */
  press(name: string): void {
    const { means } = this;
    this.means = "call";
    this.#commands.press(name, means);
  }

  /** The next press keeps what shows; asked again, it calls. */
  readonly keep = (): void => this.#mean("keep");

  #mean(means: MemoryPress): void {
    this.means = this.means === means ? "call" : means;
  }

  override firstUpdated(): void {
    new ResizeObserver(this.#hint).observe(this.row);
  }

  override updated(): void {
    this.#hint();
    for (const canvas of this.pictures) {
      const subject = pictureOf(this.store, canvas.dataset.of ?? "");
      canvas.style.visibility = subject === null ? "hidden" : "";
      if (subject !== null) this.context.thumbnails.ask(canvas, subject);
    }
  }

  /** Fades what goes on to the right: scroll bars are hidden on tablets until they are used. */
  readonly #hint = (): void => {
    const { scrollLeft, clientWidth, scrollWidth } = this.row;
    this.goesOn = scrollWidth - clientWidth - scrollLeft > 4;
  };

  override render() {
    const { kept } = this.#commands;
    return html`<div class="row ${this.means === "call" ? "" : "asked"} ${this.goesOn ? "more" : ""}" role="group" aria-label="Memories"
      @scroll=${this.#hint}>
      <span>Memory</span>
      ${placesOf(kept).map((name) => this.#key(name, kept.includes(name)))}
      <button class="means" aria-label="Keep a memory" aria-pressed=${this.means === "keep"}
        title="The next place pressed keeps the whole look that shows: faces, expressions, poses, head, gaze, light, framing (\\)"
        @click=${this.keep}>Keep</button>
      <button class="means" aria-label="Delete a memory" aria-pressed=${this.means === "delete"}
        title="The next place pressed is emptied" @click=${() => this.#mean("delete")}>✕</button>
    </div>`;
  }

  #key(name: string, there: boolean) {
    const [key, does] = [PLACES.includes(name) ? ` (Shift ${name})` : "", DOES[this.means]];
    return html`<button class=${there ? (key === "" ? "kept named" : "kept") : "empty"} data-memory=${name} aria-label="Memory ${name}${there ? "" : ", empty"}"
      title="${does} ${name}${key}" @click=${() => this.press(name)}>${
        there
          ? html`<canvas data-of=${name} width=${THUMBNAIL_SIZE.width} height=${THUMBNAIL_SIZE.height} aria-hidden="true"></canvas>`
          : nothing
      }<span>${name}</span></button>`;
  }
}

const DOES: Readonly<Record<MemoryPress, string>> = {
  call: "Call memory",
  keep: "Keep what shows as memory",
  delete: "Delete memory",
};
