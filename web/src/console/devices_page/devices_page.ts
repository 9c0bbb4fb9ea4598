/** The devices page: the panel of devices on a page of its own, with what an operator needs beside it. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { listenToKeys } from "../../ui/key_presses";
import { base, palette, toolPage } from "../../ui/theme";
import { whileShown } from "../../ui/topic_element";
import { MappingsElement } from "../mappings/mappings_element";
import { offersOf, offersStyle } from "../panels/offers";
import { isPanic, stepOf } from "../store/keys";
import type { Topic } from "../store/page_store";
import "../mappings/devices_tabs";

const style = css`
  :host {
    --finger: 40px;
    display: grid;
    grid-template-rows: auto minmax(0, 1fr);
    gap: 6px;
  }
  @media (min-width: 900px) {
    :host {
      height: 100dvh;
    }
  }
  header {
    position: sticky;
    top: 0;
    z-index: 3;
    gap: 4px 10px;
    background: var(--ground);
  }
  .notice {
    flex: 1 1 220px;
    min-width: 0;
    color: var(--attention);
    overflow-wrap: anywhere;
  }
  .notice.done {
    color: var(--text);
  }
  .panic {
    min-width: 120px;
    min-height: 44px;
    font-size: 16px;
    font-weight: 800;
    letter-spacing: 0.16em;
    color: var(--attention);
    background: #241a02;
    border: 2px solid var(--attention);
    border-radius: 6px;
    touch-action: none;
  }
`;

@customElement("omote-devices-page")
export class DevicesPage extends MappingsElement {
  static override styles = [palette, base, toolPage, offersStyle, style];

  protected override readonly topics: readonly Topic[] = ["link", "notice", "undo"];

  constructor() {
    super();
    const everywhere = (event: KeyboardEvent): boolean => isPanic(event) && this.#panic(event.repeat);
    whileShown(this, () => listenToKeys({ everywhere, page: this.#key }));
  }

  override render() {
    const { history, notice, tone, online } = this.store;
    const [undo, redo] = [history.next("undo"), history.next("redo")];
    return html`<header>
        <h1>DEVICES</h1><a href="/console" target="omote-console">Console</a>
        ${online ? nothing : html`<span class="lost" role="alert">LINK LOST – nothing is sent</span>`}
        <span class="notice ${tone}" role="status">${notice ?? ""} ${offersOf(this.store)}</span>
        <button aria-label="Undo" title="Undo${undo === null ? "" : `: ${undo.what}`} (Ctrl Z)" ?disabled=${undo === null} @click=${() => this.store.undo()}>↶</button>
        <button aria-label="Redo" title="Redo${redo === null ? "" : `: ${redo.what}`} (Ctrl Y)" ?disabled=${redo === null} @click=${() => this.store.redo()}>↷</button>
        <button class="panic" title="Panic of all characters (Shift Backspace)" @pointerdown=${() => this.#panic()}
          @click=${(event: MouseEvent) => event.detail === 0 && this.#panic()}>PANIC</button>
      </header>
      <omote-devices-tabs .context=${this.context}></omote-devices-tabs>`;
  }

  readonly #key = (event: KeyboardEvent, typing: boolean): void => {
    const step = typing ? null : stepOf(event);
    if (step === null) return;
    event.preventDefault();
    if (!event.repeat) this.store[step]();
  };

  /** Of all characters: this page plays none of them alone. */
  #panic(held = false): boolean {
    if (!held) this.store.panic(true);
    return true;
  }
}
