/** What can be done to an own face or expression: edit, name and delete it. */

import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { EDITOR_TAB, editorAddress } from "../../link/editor_address";
import { onRoam } from "../../ui/gestures";
import { layerWhileShown } from "../../ui/key_presses";
import { base } from "../../ui/theme";
import { hearWhileShown } from "../../ui/topic_element";
import { ConsoleElement } from "../controls/console_element";
import type { OwnItem } from "../show_file/own_items";

/** What a palette tells when the menu of a tile is asked for. */
export interface MenuRequest {
  readonly item: OwnItem;
  readonly tile: DOMRect;
}

const WIDTH = 190;
const HEIGHT = 190;

const style = css`
  :host {
    position: fixed;
    z-index: 8;
    display: grid;
    width: 190px;
    border: 1px solid var(--edge);
    border-radius: 6px;
    background: var(--raised);
    box-shadow: 0 6px 24px #000a;
  }
  b {
    padding: 8px 12px 4px;
    overflow-wrap: anywhere;
  }
  a,
  button {
    min-height: 40px;
    padding: 0 12px;
    border: 0;
    background: none;
    color: var(--text);
    font: inherit;
    line-height: 40px;
    text-align: left;
    text-decoration: none;
  }
  kbd {
    float: right;
    font: inherit;
    color: var(--faint);
  }
  small {
    padding: 0 12px 10px;
    color: var(--attention);
  }
  @media (hover: hover) {
    a:hover,
    button:not(:disabled):hover {
      background: #22262b;
    }
  }
  @media (pointer: coarse) {
    kbd {
      display: none;
    }
    a,
    button {
      min-height: 48px;
      line-height: 48px;
    }
  }
`;

/** The menu beside a tile, which takes every key while it is open. Tells `close`. */
@customElement("omote-tile-menu")
export class TileMenu extends ConsoleElement {
  @property({ attribute: false }) asked!: MenuRequest;
  /** A pointer went down in the menu itself. */
  #pressed = false;

  static override styles = [base, style];

  constructor() {
    super();
    layerWhileShown(this, "menu", this.close);
    this.addEventListener("pointerdown", () => {
      this.#pressed = true;
    });
    this.addEventListener("click", (event) => this.#dropForeign(event), { capture: true });
    hearWhileShown(this, document, ["pointerdown"], (event) => event.composedPath().includes(this) || this.close());
  }

  override firstUpdated(): void {
    onRoam(this.renderRoot as unknown as HTMLElement, "a, button");
    this.renderRoot.querySelector<HTMLElement>("a")?.focus();
  }

  override render() {
    const { item, tile } = this.asked;
    const why = this.context.items.whyKept(item);
    this.style.left = `${Math.max(4, Math.min(tile.left, innerWidth - WIDTH - 4))}px`;
    this.style.top = `${Math.max(4, Math.min(tile.bottom + 2, innerHeight - HEIGHT - 4))}px`;
    return html`<b>${item.label}</b>
      <a role="menuitem" href=${editorAddress(item.kind, item.name)} target=${EDITOR_TAB} @click=${this.close}>Edit in the editor</a>
      <button role="menuitem" @click=${() => this.#do(() => this.context.items.beginNaming(item))}>Rename<kbd>F2</kbd></button>
      <button role="menuitem" ?disabled=${why !== null} @click=${() => this.#do(() => this.context.items.delete(item))}>Delete<kbd>Del</kbd></button>
      ${why === null ? nothing : html`<small>Not now: ${why}.</small>`}`;
  }

  /** The finger that held the tile lifts over the menu: that presses nothing. */
  #dropForeign(event: MouseEvent): void {
    if (this.#pressed || event.detail === 0) return;
    event.preventDefault();
    event.stopPropagation();
  }

  #do(act: () => void): void {
    this.close();
    act();
  }
}
