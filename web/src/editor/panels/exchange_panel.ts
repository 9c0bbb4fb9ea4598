/** The panel that exports the open item as downloads, and says how others come in. */

import { css, html } from "lit";
import { customElement, state } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import type { Topic } from "../session/draft_store";
import { download, type Export, exportsOf, importCommand } from "./exports";

/** How the open item gets out of the show, by buttons, and others in, by commands ready to copy. */
@customElement("omote-exchange")
export class Exchange extends EditorElement {
  static override styles = [
    base,
    controls,
    panel,
    css`
      .command {
        display: grid;
        grid-template-columns: 1fr auto;
        gap: 4px;
      }
      .command input {
        font-family: "DejaVu Sans Mono", "Consolas", monospace;
        font-size: 11.5px;
      }
    `,
  ];

  /** The address of the export that is under way; empty: none. */
  @state() private busy = "";

  protected override topics(): readonly Topic[] {
    return ["draft", "items", "cast"];
  }

  override render() {
    const { item, work } = this.store;
    if (item === null) return html`<p>Open something to take it out of the show.</p>`;
    return html`
      ${item.head === 0 ? html`<p class="note">Save first: only what is saved goes out.</p>` : ""}
      ${exportsOf(item, work).map((one) => this.#export(one, item.head === 0))}
      <p>In, on the show's computer, in a terminal, while no show plays SHOW.omote, the show's own file:</p>
      <div class="command">
        <input readonly aria-label="The command that takes others in" .value=${importCommand(item.kind)} @focus=${select} />
        <button @click=${copyBeside}>Copy</button>
      </div>
    `;
  }

  #export(one: Export, unsaved: boolean) {
    const busy = this.busy === one.address;
    return html`<div class="command">
      <span class="note">${one.what}</span>
      <button aria-label="Download ${one.file}" ?disabled=${unsaved || this.busy !== ""} @click=${() => this.#download(one)}>
        ${busy ? "Exporting ..." : `Download ${one.file.slice(one.file.lastIndexOf("."))}`}
      </button>
    </div>`;
  }

  async #download(one: Export): Promise<void> {
    this.busy = one.address;
    try {
      await download(one);
      this.store.say(`${one.file} is in your downloads.`, "done");
    } catch (error) {
      this.store.say((error as Error).message);
    } finally {
      this.busy = "";
    }
  }
}

const select = (event: Event): void => (event.target as HTMLInputElement).select();

/** Copies the field before a button; the old way too, because a LAN without https has no clipboard. */
async function copyBeside(event: Event): Promise<void> {
  const button = event.target as HTMLButtonElement;
  const field = button.previousElementSibling as HTMLInputElement;
  field.select();
  try {
    await navigator.clipboard.writeText(field.value);
  } catch {
    document.execCommand("copy");
  }
  button.textContent = "Copied";
}
