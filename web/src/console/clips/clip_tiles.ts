/** The clips of the show as tiles of the palette: a press plays one on the characters that are played here, another ends it. */

import { css, html, nothing } from "lit";
import { customElement, property, queryAll } from "lit/decorators.js";
import type { ClipState } from "../../link/messages";
import { onRoam } from "../../ui/gestures";
import { base, thinBar } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import type { ConsoleStore } from "../store/console_store";
import { keyLabel } from "../store/keys";
import type { Topic } from "../store/page_store";
import { clipTime } from "./clip_passes";

const style = css`
  :host {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(96px, 1fr));
    grid-auto-rows: max-content;
    align-content: start;
    gap: 5px;
    overflow: hidden auto;
    min-height: 0;
    padding: 2px;
    margin: -2px;
    scrollbar-width: thin;
    scrollbar-color: var(--edge) transparent;
    overscroll-behavior: contain;
  }
  button,
  a {
    position: relative;
    display: grid;
    align-content: center;
    gap: 2px;
    min-height: 56px;
    padding: 6px 8px 8px;
    overflow: hidden;
    overflow-wrap: anywhere;
    font-size: 13px;
    text-align: left;
    text-decoration: none;
    color: var(--text);
    background: var(--raised);
    border: 2px solid var(--line);
    border-radius: 5px;
  }
  a {
    color: var(--focus);
    background: none;
  }
  .key {
    position: absolute;
    right: 3px;
    top: 3px;
    min-width: 15px;
    font-size: 10px;
    line-height: 14px;
    text-align: center;
    border-radius: 3px;
    background: #000c;
  }
  .left {
    font-size: 11.5px;
    color: var(--dim);
  }
  .left:empty {
    display: none;
  }
  .progress {
    ${thinBar}
    height: 5px;
    background: var(--air);
  }
  button.air[aria-pressed="true"] {
    color: #fff;
    background: var(--air-deep);
    border-color: var(--air);
  }
  .air .left {
    color: #fff;
  }
  .none {
    grid-column: 1 / -1;
    padding: 12px 4px;
    color: var(--faint);
  }
`;

/** The clips in whose names all words occur. */
export function clipsFound(store: ConsoleStore, search: string): readonly string[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  const names = store.newest("clips")?.names ?? [];
  return names.filter((name) => words.every((word) => name.toLowerCase().includes(word)));
}

/** A clip as a character plays it that is played here; null for none. */
export function playedClip(store: ConsoleStore, name: string): ClipState | null {
  const characters = store.played.names.map((each) => store.state?.characters[each]);
  return characters.flatMap((each) => each?.clips ?? []).findLast((clip) => clip.name === name) ?? null;
}

/** Plays a clip in the time of an expression's call, by hand in its own; one that plays ends in that time. */
export function pressClip(store: ConsoleStore, name: string): void {
  const seconds = store.callSeconds("expression");
  const type = playedClip(store, name) === null ? "play_clip" : "stop_clip";
  for (const character of store.played.targets) store.ask({ type, character, name, seconds });
}

@customElement("omote-clip-tiles")
export class ClipTiles extends AnimatedElement {
  @property() search = "";
  @queryAll("button[data-name]") private tiles!: NodeListOf<HTMLElement>;

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["clips", "characters"];

  override firstUpdated(): void {
    onRoam(this.renderRoot as unknown as HTMLElement, "button, a");
  }

  override render() {
    const found = clipsFound(this.store, this.search);
    return html`${found.map((name, index) => this.#tile(name, index))}
      ${found.length > 0 ? nothing : html`<div class="none">${this.search === "" ? "No clip yet." : `No clip is called "${this.search}".`}</div>`}
      <button class="stop" title="Ends all clips of the characters that are played here" @click=${this.#stop}>■ Stop clips</button>
      <a href="/clips" target="omote-clips">Record and edit clips</a>`;
  }

  #tile(name: string, index: number) {
    const key = this.search === "" ? keyLabel("expression", index) : null;
    return html`<button data-name=${name} aria-pressed="false" aria-label="Clip ${name}${key === null ? "" : `, key ${key}`}" title="Plays ${name}; again: ends it" @click=${(event: MouseEvent) => this.#press(event, name)}>
      <span>${name}</span><span class="left"></span>${key === null ? nothing : html`<span class="key">${key}</span>`}<span class="progress"></span></button>`;
  }

  /** A tile that was clicked keeps no focus: the space bar would play it again. */
  #press(event: MouseEvent, name: string): void {
    pressClip(this.store, name);
    if (event.detail > 0) (event.currentTarget as HTMLElement).blur();
  }

  readonly #stop = (): void => {
    const seconds = this.store.callSeconds("expression");
    for (const character of this.store.played.targets)
      this.store.ask({ type: "stop_clip", character, name: "", seconds });
  };

  paint(): void {
    for (const tile of this.tiles) {
      const clip = playedClip(this.store, tile.dataset.name ?? "");
      this.write.flag(tile, "air", clip !== null);
      this.write.attribute(tile, "aria-pressed", String(clip !== null));
      const part = clip === null || clip.seconds === 0 ? 0 : Math.min(1, clip.elapsed / clip.seconds);
      this.write.style(
        tile.querySelector<HTMLElement>(".progress") as HTMLElement,
        "transform",
        `scaleX(${part.toFixed(3)})`,
      );
      const left = clip === null ? "" : clip.loop ? "loops" : clipTime(Math.max(0, clip.seconds - clip.elapsed));
      this.write.text(tile.querySelector(".left") as Element, left);
    }
  }
}
