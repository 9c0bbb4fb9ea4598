/** The panel with commands that export and import items. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import type { Topic } from "../session/draft_store";
import { type CliHint, cliHintsOf } from "./cli_hints";

/** How the open item gets out of the show file, and others in: commands, ready to copy. */
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

  protected override topics(): readonly Topic[] {
    return ["draft", "items", "cast"];
  }

  override render() {
    const { item, work } = this.store;
    if (item === null) return html`<p>Open something to take it out of the show.</p>`;
    return html`
      <p>On the show's computer, in a terminal; SHOW.omote is the show's own file.</p>
      ${item.head === 0 ? html`<p class="note">Save first: only what is saved goes out.</p>` : ""}
      ${cliHintsOf(item, work).map((errand) => this.#errand(errand))}
    `;
  }

  #errand({ what, command }: CliHint) {
    return html`<div>
      <span class="note">${what}</span>
      <div class="command">
        <input readonly aria-label=${what} .value=${command} @focus=${(event: Event) => (event.target as HTMLInputElement).select()} />
        <button @click=${copyBeside}>Copy</button>
      </div>
    </div>`;
  }
}

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
