/** The layouts of the show, in the set-up: choose, save, rename, delete, and back again. */

import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { base, entry, flow } from "../../ui/theme";
import { ConsoleElement } from "../controls/console_element";
import type { Arrangement } from "../store/arrangement";
import type { Topic } from "../store/page_store";
import { DEFAULT_LAYOUT } from "./layout_storage";

const LONGEST_NAME = 40;

const style = css`
  :host {
    display: grid;
    gap: 10px;
  }
  p {
    color: var(--dim);
  }
  .row,
  .names {
    ${flow}
    gap: 6px;
  }
  .row button {
    flex: 1 1 auto;
    min-width: 0;
    overflow: hidden;
    text-overflow: ellipsis;
  }
  .names button {
    overflow-wrap: anywhere;
  }
  input {
    ${entry}
    flex: 1 1 140px;
    min-height: 26px;
  }
`;

@customElement("omote-layouts")
export class SetupLayouts extends ConsoleElement {
  /** The layout that is there already, and that saving once more replaces. */
  @state() private replaces: string | null = null;
  /** How the console was before a layout was chosen. */
  @state() private earlier: Arrangement | null = null;
  /** The name in the field. */
  @state() private typed = "";
  @query("input") private field!: HTMLInputElement;

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["layouts"];

  override firstUpdated(): void {
    this.#show(this.context.layouts.chosen);
  }

  override render() {
    const { layouts } = this.context;
    return html`
      <h2>Layout</h2>
      <p>What you set (times, by hand, palettes, faders, springs) stays in this browser. A saved layout can be chosen on every console of this show; a fresh one opens with ${DEFAULT_LAYOUT}.</p>
      <div class="names" role="group" aria-label="Choose a layout">
        ${layouts.names.map(
          (name) =>
            html`<button data-layout=${name} aria-pressed=${name === layouts.chosen} @click=${() => this.#choose(name)}>${name}</button>`,
        )}
      </div>
      <form class="row" @submit=${this.#save}>
        <input aria-label="Name of the layout" maxlength=${LONGEST_NAME} placeholder="name of a layout" @input=${this.#type} />
        <button type="submit">${this.replaces === null ? "Save as" : "Replace it"}</button>
      </form>
      ${layouts.has(layouts.chosen) ? this.#changes(layouts.chosen) : nothing}
      ${this.earlier === null ? nothing : html`<div class="row"><button @click=${this.#back}>Back to how it was</button></div>`}
    `;
  }

  /** What can be done to the layout that is chosen. */
  #changes(chosen: string) {
    const renamed = this.typed !== "" && this.typed !== chosen && chosen !== DEFAULT_LAYOUT;
    return html`<div class="row">
      ${chosen === DEFAULT_LAYOUT ? nothing : html`<button ?disabled=${!renamed} title="Type the new name above" @click=${() => this.#rename(chosen)}>Rename ${chosen}${renamed ? ` to ${this.typed}` : ""}</button>`}
      <button @click=${() => this.#drop(chosen)}>Delete ${chosen}</button>
    </div>`;
  }

  readonly #type = (): void => {
    this.replaces = null;
    this.typed = this.field.value.trim();
  };

  /** Writes the name of a layout into the field, where it can be changed. */
  #show(name: string): void {
    this.field.value = name === DEFAULT_LAYOUT ? "" : name;
    this.#type();
  }

  async #choose(name: string): Promise<void> {
    const before = this.store.arrangement;
    const choice = await this.context.layouts.choose(name);
    if (choice === "overtaken") return;
    if (choice === "missing") {
      this.store.say(`There is no layout ${name} any more, or the show does not answer.`);
      return;
    }
    this.earlier ??= before;
    this.#show(name);
    this.store.say(`Laid out as ${name}.`, "done");
    this.requestUpdate();
  }

  readonly #back = (): void => {
    if (this.earlier !== null) this.store.arrange(this.earlier);
    this.earlier = null;
    this.store.say(null);
  };

  /** Saves under a name; one that is there, in whatever case, is replaced only by a second press. */
  readonly #save = (event: Event): void => {
    event.preventDefault();
    if (this.typed === "") {
      this.store.say("Not saved: type a name for the layout first.");
      this.field.focus();
      return;
    }
    const existing = this.#existing(this.typed);
    if (existing !== undefined && this.replaces !== existing) {
      this.replaces = existing;
      this.store.say(`Every console has a layout ${existing}: press once more to replace it, or type another name.`);
      return;
    }
    const name = existing ?? this.typed;
    this.replaces = null;
    void this.context.layouts.save(name);
  };

  #existing(name: string): string | undefined {
    return this.context.layouts.names.find((existing) => existing.toLowerCase() === name.toLowerCase());
  }

  #rename(name: string): void {
    const { layouts } = this.context;
    const [to, existing] = [this.typed, this.#existing(this.typed)];
    if (existing !== undefined && existing !== name)
      this.store.say(`There is a layout ${existing} already: type another name.`);
    else layouts.rename(name, to);
  }

  async #drop(name: string): Promise<void> {
    if (!(await this.context.layouts.drop(name))) this.store.say("Not deleted: the show does not answer.");
  }
}
