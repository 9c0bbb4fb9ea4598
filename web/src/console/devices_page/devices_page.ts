/** The devices page: the panel of devices on a page of its own, with what an operator needs beside it. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { listenToKeys } from "../../ui/key_presses";
import { base, palette } from "../../ui/theme";
import { DevicesElement } from "../device_panel/devices_element";
import { offersOf, offersStyle } from "../panels/offers";
import { isPanic, stepOf } from "../store/keys";
import "../device_panel/devices_panel";

@customElement("omote-devices-page")
export class DevicesPage extends DevicesElement {
  #deaf: () => void = () => undefined;

  static override styles = [
    palette,
    base,
    offersStyle,
    css`
      :host {
        --finger: 40px;
        min-height: 100dvh;
        display: grid;
        grid-template-rows: auto minmax(0, 1fr);
        gap: 6px;
        padding: 6px;
        background: var(--ground);
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
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 4px 10px;
        min-height: 50px;
        padding: 4px 10px;
        background: var(--ground);
      }
      h1 {
        margin: 0;
        font-size: 15px;
        letter-spacing: 0.14em;
      }
      a {
        color: var(--focus);
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
      .lost {
        padding: 4px 10px;
        border-radius: 4px;
        font-weight: 700;
        color: #fff;
        background: #c3170a;
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
    `,
  ];

  protected override listen(changed: () => void): (() => void)[] {
    return (["link", "notice", "undo"] as const).map((topic) => this.store.listen(topic, changed));
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#deaf = listenToKeys({
      everywhere: (event) => isPanic(event) && this.#panic(event.repeat),
      page: this.#key,
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#deaf();
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
      <omote-devices .context=${this.context}></omote-devices>`;
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
